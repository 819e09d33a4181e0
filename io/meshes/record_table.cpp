// SPDX-License-Identifier: MIT
#include "io/meshes/record_table.h"

#include "base/errors.h"

#include <fmt/format.h>

#include <algorithm>

namespace polydec {

namespace {

/// So many records of a run, from one on, into the matrix from this row on.
void read_records(const RecordTable& table, const PartialFile& file, std::endian order,
                  const RecordTable::Run& records, DenseMatrix& rows, Eigen::Index row) {
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

} // namespace

std::int64_t RecordTable::count() const {
    std::int64_t sum = 0;
    for (const Run& run : runs)
        sum += run.count;
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
    std::int64_t first = 0; // record of a run
    for (const RecordTable::Run& run : table.runs) {
        const std::int64_t last = std::min(end, first + run.count);
        const std::int64_t at_once = std::max<std::int64_t>(1, bytes_at_once / run.stride);
        for (std::int64_t at = std::max(begin, first); at < last; at += at_once)
            read_records(
                table, file, order,
                {std::min(at_once, last - at), run.begin + (at - first) * run.stride, run.stride},
                rows, at - begin);
        first += run.count;
    }
    return rows;
}

} // namespace polydec
