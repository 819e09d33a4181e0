// SPDX-License-Identifier: MIT
#include "distributed/read_parts.h"

#include "distributed/mesh_file.h"
#include "tests/distributed/binary_files.h"
#include "tests/distributed/common_folder.h"
#include "tests/distributed/compare.h"
#include "tests/io/support.h"

namespace polydec::test::in_read_parts {

/// What reading ends with: a slice or an error's text.
struct Outcome {
    std::optional<MeshSlice> slice;
    std::string error;
};

template <class Work>
Outcome outcome(Work work) {
    try {
        return {work(), ""};
    } catch (const Error& error) {
        return {std::nullopt, error.what()};
    }
}

constexpr const char* fallback = "one rank read the whole file: ";

std::vector<std::string> without_fallback(std::vector<std::string> warnings) {
    std::erase_if(warnings, [](const std::string& w) { return w.starts_with(fallback); });
    return warnings;
}

/// What differs from what one process reads and cuts; empty if nothing does.
std::string difference(const Outcome& found, const Outcome& expected) {
    if (found.error != expected.error)
        return fmt::format("'{}' for '{}'", found.error, expected.error);
    if (!found.slice)
        return "";
    const MeshSlice &a = *found.slice, &b = *expected.slice;
    if (a.vertices != b.vertices || a.cells != b.cells || a.points != b.points ||
        a.simplices != b.simplices || a.has_tags != b.has_tags)
        return "other points or cells";
    if (without_fallback(a.warnings) != b.warnings)
        return fmt::format("{} warnings for {}", a.warnings.size(), b.warnings.size());
    return "";
}

/// Reads a file with this text on all ranks; whether each has read its part.
bool expect_like_one_process(const Ranks& ranks, const std::filesystem::path& path,
                             const std::string& text, const std::string& in) {
    on_rank_0(ranks, [&] { std::ofstream(path, std::ios::binary) << text; });
    bool is_scattered = false;
    ranks.listen([&](std::string_view what) { is_scattered = is_scattered || what == "scatter"; });
    const Outcome found = outcome([&] { return read_slice(ranks, path); });
    ranks.listen({});
    const Outcome expected = outcome([&] { return slice_of(ranks, tidy(read_mesh(path))); });
    EXPECT_EQ(difference(found, expected), "") << in;
    ranks.any(false); // all have read before another file takes its place
    return found.slice && !is_scattered;
}

struct Format {
    const char* file;
    std::string (*text)(const Mesh&, const BinaryKind&);
    int least, most; ///< dimension of cells
};
constexpr Format formats[] = {
    {"a.ply", binary_ply, 2, 2}, {"a.msh", binary_gmsh, 1, 3}, {"a.vtu", binary_vtu, 1, 3}};

/// The kinds of files, of which each mesh gets one by turns.
const std::vector<BinaryKind>& kinds() {
    constexpr auto little = std::endian::little, big = std::endian::big;
    static const std::vector<BinaryKind> all = {
        {.order = little},
        {.order = big},
        {.order = little, .is_narrow = true, .has_more = true},
        {.order = big, .is_old = true, .is_scrambled = true, .has_more = true},
        {.order = little, .is_scrambled = true, .has_more = true, .block = 7},
        {.order = little, .is_old = true, .has_more = true, .block = 1},
        {.order = big, .is_old = true, .block = 9},
        {.order = big, .is_narrow = true, .is_scrambled = true},
    };
    return all;
}

/// Without cells that one kind of file, with its floats, may make flat.
bool fits(const Format& format, const Mesh& mesh) {
    return mesh.ambient_dimension() <= 3 && mesh.dimension() >= format.least &&
           mesh.dimension() <= format.most;
}

TEST(ReadParts, are_the_slices_of_one_process_in_every_format) {
    const auto ranks = Ranks::all();
    const CommonFolder folder(ranks);
    std::size_t turn = 0, in_parts = 0, all = 0;
    for (const auto& [name, mesh] : meshes())
        for (const Format& format : formats) {
            if (!fits(format, mesh))
                continue;
            const std::size_t first = ++turn % kinds().size();
            for (std::size_t k = 0; k < (ranks.size() == 2 ? kinds().size() : 2); ++k) {
                const BinaryKind& kind = kinds()[(first + k) % kinds().size()];
                in_parts += expect_like_one_process(
                    ranks, folder / format.file, format.text(mesh, kind),
                    fmt::format("{} as {}, kind {}", name, format.file, k + first));
                ++all;
            }
        }
    EXPECT_EQ(in_parts, all);
}

TEST(ReadParts, leave_to_one_rank_what_has_no_fixed_width_or_is_to_be_tidied) {
    const auto ranks = Ranks::all();
    const CommonFolder folder(ranks);
    const std::string header = "ply\nformat binary_little_endian 1.0\nelement vertex 4\n"
                               "property uchar x\nproperty uchar y\nproperty uchar z\n";
    using namespace std::string_literals;
    const std::string square = "\0\0\0\1\0\0\1\1\0\0\1\0"s;
    const std::string faces = "element face 1\nproperty list uchar uchar vertex_indices\n";
    for (const auto& [name, text] : std::vector<std::pair<const char*, std::string>>{
             {"a.ply", header + faces + "end_header\n" + square + "\4\0\1\2\3"s},
             {"a.ply", header + faces + "property list uchar uchar more\nend_header\n" + square +
                           "\3\0\1\2\1\7"s},
             {"a.ply", header + "property list uchar int more\n" + faces + "end_header\n" +
                           "\0\0\0\0\1\0\0\0\1\1\0\0\0\1\0\0"s + "\3\0\1\2"s}})
        EXPECT_FALSE(expect_like_one_process(ranks, folder / name, text, text));
    const Mesh& mesh = mesh_named("grid4");
    Mesh twice = mesh, repeated = mesh, flat = mesh, unused = mesh;
    twice.simplices.row(twice.simplices.rows() - 1) = mesh.simplices.row(0).reverse();
    repeated.simplices(3, 0) = repeated.simplices(3, 1);
    flat.points.row(flat.simplices(0, 0)) = flat.points.row(flat.simplices(0, 1));
    unused.points.conservativeResize(unused.points.rows() + 8, Eigen::NoChange);
    unused.points.bottomRows(8).setConstant(2.5);
    for (const Format& format : formats) {
        for (const Mesh& untidy : {twice, repeated, flat})
            EXPECT_FALSE(expect_like_one_process(ranks, folder / format.file,
                                                 format.text(untidy, {}), format.file));
        EXPECT_TRUE(expect_like_one_process(ranks, folder / format.file, format.text(unused, {}),
                                            format.file));
    }
    const auto as_pdm = [&](const Mesh& given) {
        on_rank_0(ranks, [&] { write_mesh(folder / "given.pdm", given); });
        return read_text(folder / "given.pdm");
    };
    for (const Mesh& untidy : {twice, repeated, flat})
        EXPECT_FALSE(expect_like_one_process(ranks, folder / "a.pdm", as_pdm(untidy), "a.pdm"));
    EXPECT_TRUE(expect_like_one_process(ranks, folder / "a.pdm", as_pdm(unused), "a.pdm"));
    on_rank_0(ranks, [&] { write_mesh(folder / "a.ply", mesh); }); // text, which all are told of
    EXPECT_TRUE(read_slice(ranks, folder / "a.ply").warnings.empty());
}

TEST(ReadParts, say_of_what_is_wrong_what_one_process_says) {
    const auto ranks = Ranks::all();
    const CommonFolder folder(ranks);
    const Mesh mesh = grid(2, 2);
    Mesh far = mesh, nowhere = mesh;
    far.simplices(5, 2) = 77;
    nowhere.points(6, 1) = std::nan("");
    for (const Format& format : formats)
        for (std::size_t k = 0; k < kinds().size(); ++k) {
            const auto in = fmt::format("{}, kind {}", format.file, k);
            for (const Mesh& bad : {far, nowhere}) {
                const std::string text = format.text(bad, kinds()[k]);
                EXPECT_FALSE(expect_like_one_process(ranks, folder / format.file, text, in));
                EXPECT_THROW(read_slice(ranks, folder / format.file), InvalidInput) << in;
            }
        }
}

TEST(ReadParts, of_a_file_that_is_cut_off_anywhere_are_refused_as_by_one_process) {
    const auto ranks = Ranks::all();
    const CommonFolder folder(ranks);
    const Mesh mesh = grid(2, 1);
    const std::size_t step = ranks.size() == 3 ? 1 : 37;
    for (const Format& format : formats)
        for (const std::size_t k : {std::size_t{2}, std::size_t{4}, std::size_t{5}}) {
            const std::string text = format.text(mesh, kinds()[k]);
            for (std::size_t end = 0; end < text.size(); end += step)
                expect_like_one_process(ranks, folder / format.file, text.substr(0, end),
                                        fmt::format("{} bytes of {}", end, format.file));
        }
}

/// Any byte may be another: the same error, or the same mesh.
TEST(ReadParts, of_a_damaged_file_are_what_one_process_reads) {
    const auto ranks = Ranks::all();
    const CommonFolder folder(ranks);
    const Mesh mesh = grid(2, 1);
    const std::size_t step = ranks.size() == 3 ? 3 : 53;
    for (const Format& format : formats)
        for (const std::size_t k : {std::size_t{2}, std::size_t{5}}) {
            const std::string whole = format.text(mesh, kinds()[k]);
            for (std::size_t place = 0; place < whole.size(); place += step) {
                std::string text = whole;
                text[place] = static_cast<char>(text[place] ^ (1 << place % 8));
                expect_like_one_process(ranks, folder / format.file, text,
                                        fmt::format("byte {} of {}", place, format.file));
            }
        }
}

TEST(ReadParts, of_files_that_differ_between_ranks_are_refused_by_all) {
    const auto ranks = Ranks::all();
    if (ranks.size() == 1)
        return;
    const CommonFolder folder(ranks);
    on_rank_0(ranks, [&] {
        for (const char* name : {"a.ply", "b.ply"})
            std::ofstream(folder / name, std::ios::binary) << binary_ply(grid(2, 2), {});
        std::ofstream(folder / "b.ply", std::ios::binary | std::ios::app) << "more";
        write_mesh(folder / "a.pdm", grid(2, 2));
        write_mesh(folder / "b.pdm", grid(2, 3));
    });
    const bool is_last = ranks.rank() == ranks.size() - 1;
    for (const std::string format : {".ply", ".pdm"}) {
        const std::string name = (is_last ? "b" : "a") + format;
        const auto found = outcome([&] { return read_slice(ranks, folder / name.c_str()); });
        EXPECT_SAYS(found.error, "bytes", "rank");
    }
    const auto missing =
        outcome([&] { return read_slice(ranks, folder / (is_last ? "none.ply" : "a.ply")); });
    EXPECT_SAYS(missing.error, "none.ply", "No such file");
}

} // namespace polydec::test::in_read_parts
