// SPDX-License-Identifier: MIT
#include "distributed/mesh_file.h"

#include "base/errors.h"
#include "base/printable.h"
#include "dec/merging/flat_simplices.h"
#include "distributed/read_parts.h"
#include "distributed/shared_folder.h"
#include "io/meshes/mesh_files.h"
#include "io/meshes/pdm.h"
#include "io/source_file.h"
#include "meshes/tidy.h"
#include "system/atomic_file.h"
#include "system/regular_file.h"

#include <fmt/format.h>

#include <algorithm>

namespace polydec {

namespace {

/// A stretch of the bytes between header and sums.
struct Bytes {
    std::int64_t begin;
    std::string text;
};

/// Collective: opens a file on every rank, and makes sure that all see the same.
PartialFile open_on_all(const Ranks& ranks, const std::filesystem::path& path) {
    const auto name = printable(path.string());
    const auto opened = ranks.together("read", [&] {
        try {
            auto file = std::make_shared<RegularFile>(path);
            if (file->is_regular())
                return file;
        } catch (const IoError& error) {
            throw IoError(fmt::format("cannot read {}: {}", name, error.what()), {.path = path});
        }
        throw IoError(fmt::format("cannot read {}: it is not a regular file", name),
                      {.path = path});
    });
    const auto size = static_cast<std::int64_t>(opened->size());
    const GlobalIndex longest = ranks.largest(size), shortest = -ranks.largest(-size);
    if (shortest < longest)
        throw IoError(fmt::format("cannot read {}: it has {} bytes on one rank and {} on another; "
                                  "all ranks need the same file",
                                  name, shortest, longest),
                      {.path = path});
    return {path.string(), size, [opened](std::int64_t begin, std::int64_t end) {
                return opened->read(static_cast<std::size_t>(begin), static_cast<std::size_t>(end));
            }};
}

MeshSlice read_pdm_slice(const Ranks& ranks, const PartialFile& file) {
    return ranks.together("read", [&] {
        const PdmReader reader(file);
        const PdmLayout& layout = reader.layout();
        const EqualStretches vertices(layout.vertices, ranks.size()),
            cells(layout.cells, ranks.size());
        MeshSlice slice{layout.vertices, layout.cells, {}, {}, {}, layout.has_tags};
        slice.points = reader.points(vertices.begin(ranks.rank()), vertices.end(ranks.rank()));
        const auto corners = reader.cells(cells.begin(ranks.rank()), cells.end(ranks.rank()));
        slice.simplices = Eigen::Map<const GlobalSimplices>(
            corners.data(), cells.end(ranks.rank()) - cells.begin(ranks.rank()),
            layout.dimension + 1);
        slice.tags = reader.tags(cells.begin(ranks.rank()), cells.end(ranks.rank()));
        return slice;
    });
}

struct Stretch {
    std::int64_t begin, size;
};

/// The part of some bytes that lies between two places.
Bytes part(const Bytes& bytes, std::int64_t begin, std::int64_t end) {
    const std::int64_t from = std::max(begin, bytes.begin),
                       to = std::min(end, bytes.begin + std::ssize(bytes.text));
    if (from >= to)
        return {from, {}};
    return {from, bytes.text.substr(static_cast<std::size_t>(from - bytes.begin),
                                    static_cast<std::size_t>(to - from))};
}

/// The blocks of every rank, put together of what all ranks have of them.
Bytes own_blocks(const Ranks& ranks, const PdmLayout& layout, const std::vector<Bytes>& parts) {
    const EqualStretches blocks(layout.blocks(), ranks.size());
    auto texts = ranks.empty_parcels<char>();
    auto places = ranks.empty_parcels<Stretch>();
    ranks.together("blocks", [&] {
        for (int r = 0; r < ranks.size(); ++r)
            for (const Bytes& bytes : parts) {
                const Bytes sent = part(bytes, layout.block_begin(blocks.begin(r)),
                                        layout.block_begin(blocks.end(r)));
                texts[r].insert(texts[r].end(), sent.text.begin(), sent.text.end());
                places[r].push_back({sent.begin, std::ssize(sent.text)});
            }
    });
    const auto arrived = ranks.deliver(std::move(texts));
    const auto where = ranks.deliver(std::move(places));
    return ranks.together("blocks", [&] {
        const std::int64_t begin = layout.block_begin(blocks.begin(ranks.rank())),
                           end = layout.block_begin(blocks.end(ranks.rank()));
        Bytes own{begin, std::string(static_cast<std::size_t>(end - begin), '\0')};
        for (std::size_t r = 0; r < arrived.size(); ++r) {
            auto next = arrived[r].begin();
            for (const auto& [place, size] : where[r])
                if (size > 0) {
                    std::copy(next, next + size, own.text.begin() + (place - begin));
                    next += size;
                }
        }
        return own;
    });
}

/// With cells without volume where these may become pieces of their neighbors.
Mesh tidied(const std::filesystem::path& path) {
    Mesh mesh = read_mesh(path);
    const bool may_be_flat = can_take_flat_simplices(static_cast<int>(mesh.simplices.cols()) - 1,
                                                     static_cast<Index>(mesh.points.cols()));
    return tidy(std::move(mesh),
                may_be_flat ? CellsWithoutVolume::keep : CellsWithoutVolume::leave_out);
}

} // namespace

MeshSlice read_slice(const Ranks& ranks, const std::filesystem::path& path) {
    const std::string format = lower_extension(path);
    std::string why;
    std::optional<MeshSlice> parts;
    if (format == ".pdm")
        parts = read_pdm_slice(ranks, open_on_all(ranks, path));
    else if (format == ".ply" || format == ".msh" || format == ".vtu")
        parts = read_parts(ranks, open_on_all(ranks, path), why);
    if (parts && is_tidy(ranks, *parts, why))
        return *std::move(parts);
    const auto mesh = ranks.together(
        "read", [&] { return ranks.rank() == 0 ? std::optional(tidied(path)) : std::nullopt; });
    MeshSlice slice = scatter(ranks, mesh);
    if (ranks.rank() == 0 && ranks.size() > 1 && !why.empty())
        slice.warnings.push_back(fmt::format("one rank read the whole file: {}", why));
    return slice;
}

void write_slice(const Ranks& ranks, const std::filesystem::path& path, const MeshSlice& slice) {
    const PdmLayout layout{slice.ambient_dimension(), slice.dimension(), slice.vertices,
                           slice.cells, ranks.any(!slice.tags.empty())};
    std::unique_ptr<AtomicFile> file; // of rank 0
    ranks.together("write", [&] {
        if (lower_extension(path) != ".pdm")
            throw InvalidInput(fmt::format("cannot write {}: several ranks write only .pdm",
                                           printable(path.string())),
                               {.path = path});
        if (ranks.rank() == 0) {
            file = std::make_unique<AtomicFile>(path);
            write_part(file->unfinished(), 0, header_of(layout), path);
        }
    });
    const std::string unfinished = told_by_first(ranks, file ? file->unfinished().string() : "");

    const auto first = [&](GlobalIndex count) {
        return EqualStretches(count, ranks.size()).begin(ranks.rank());
    };
    const auto parts = ranks.together("bytes", [&] {
        const std::vector<GlobalIndex> corners(slice.simplices.data(),
                                               slice.simplices.data() + slice.simplices.size());
        return std::vector<Bytes>{
            {PdmLayout::header_bytes + first(slice.vertices) * layout.point_bytes(),
             pdm_bytes(slice.points)},
            {layout.cells_begin() + first(slice.cells) * layout.cell_bytes(),
             pdm_bytes(corners, layout.number_bytes())},
            {layout.tags_begin() + 4 * first(slice.cells), pdm_bytes(slice.tags)}};
    });
    const Bytes own = own_blocks(ranks, layout, parts);
    ranks.together("write", [&] {
        std::string sums;
        for (std::size_t at = 0; at < own.text.size(); at += PdmLayout::block_bytes)
            sums += checksum_of(std::string_view(own.text).substr(at, PdmLayout::block_bytes));
        const std::int64_t first_block = first(layout.blocks());
        write_part(unfinished, own.begin, own.text, path);
        write_part(unfinished, layout.sums_begin() + first_block * PdmLayout::sum_bytes, sums,
                   path);
    });
    ranks.together("write", [&] {
        if (file)
            file->commit();
    });
}

} // namespace polydec
