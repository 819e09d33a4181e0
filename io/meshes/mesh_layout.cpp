// SPDX-License-Identifier: MIT
#include "io/meshes/mesh_layout.h"

#include "base/errors.h"
#include "io/source_file.h"

#include <fmt/format.h>

#include <algorithm>

namespace polydec {

namespace {

/// So many records of a stretch, from one on, into the matrix from this row on.
void read_records(const RecordTable& table, const PartialFile& file, std::endian order,
                  const RecordTable::Stretch& records, DenseMatrix& rows, Eigen::Index row) {
    const std::int64_t bytes = (records.count - 1) * records.stride + table.reach();
    const std::string text = file.read(records.begin, records.begin + bytes);
    if (std::ssize(text) < bytes)
        throw IoError(fmt::format("{}: the file has become shorter while it was read", file.name),
                      {.path = file.name});
    for (std::int64_t i = 0; i < records.count; ++i)
        for (std::size_t f = 0; f < table.fields.size(); ++f)
            rows(row + i, static_cast<Eigen::Index>(f)) =
                value_at(text.data() + i * records.stride + table.fields[f].offset,
                         table.fields[f].type, order);
}

void check_places(const PartialFile& file, const RecordTable& table) {
    for (const auto& stretch : table.stretches)
        if (stretch.begin + (stretch.count - 1) * stretch.stride + table.reach() > file.size)
            refuse_layout(file, "the file ends within its records");
}

std::optional<MeshLayout> layout_of(const PartialFile& file) {
    const auto extension = lower_extension(file.name);
    if (extension == ".ply")
        return ply_layout(file);
    if (extension == ".msh")
        return gmsh_layout(file);
    if (extension == ".vtu")
        return vtu_layout(file);
    return std::nullopt;
}

} // namespace

std::int64_t RecordTable::count() const {
    std::int64_t sum = 0;
    for (const Stretch& stretch : stretches)
        sum += stretch.count;
    return sum;
}

std::int64_t RecordTable::reach() const {
    std::int64_t farthest = 0;
    for (const Field& field : fields)
        farthest =
            std::max(farthest, field.offset + static_cast<std::int64_t>(size_of(field.type)));
    return farthest;
}

RecordTable table_of(NumberType type, int fields) {
    RecordTable table;
    for (int f = 0; f < fields; ++f)
        table.fields.push_back({f * static_cast<std::int64_t>(size_of(type)), type});
    return table;
}

DenseMatrix rows_of(const RecordTable& table, const PartialFile& file, std::endian order,
                    std::int64_t begin, std::int64_t end) {
    constexpr std::int64_t bytes_at_once = 4 << 20;
    DenseMatrix rows(end - begin, static_cast<Eigen::Index>(table.fields.size()));
    std::int64_t first = 0; // record of a stretch
    for (const RecordTable::Stretch& stretch : table.stretches) {
        const std::int64_t last = std::min(end, first + stretch.count);
        const std::int64_t at_once = std::max<std::int64_t>(1, bytes_at_once / stretch.stride);
        for (std::int64_t at = std::max(begin, first); at < last; at += at_once)
            read_records(table, file, order,
                         {std::min(at_once, last - at),
                          stretch.begin + (at - first) * stretch.stride, stretch.stride},
                         rows, at - begin);
        first += stretch.count;
    }
    return rows;
}

std::optional<MeshLayout> mesh_layout(const PartialFile& file) {
    auto layout = layout_of(file);
    if (!layout)
        return layout;
    if (layout->points.count() == 0 || layout->cells.count() == 0)
        refuse_layout(file, "there are no vertices, or no cells");
    check_places(file, layout->points);
    check_places(file, layout->cells);
    if (layout->nodes)
        check_places(file, *layout->nodes);
    for (const auto& table : layout->others)
        check_places(file, table);
    for (const auto& expectation : layout->expected)
        check_places(file, expectation.table);
    return layout;
}

void refuse_layout(const PartialFile& file, const std::string& why) {
    refuse_contents(file.name, why);
}

} // namespace polydec
