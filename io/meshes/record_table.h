// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"
#include "io/number_type.h"
#include "io/partial_file.h"

#include <bit>
#include <cstdint>
#include <vector>

namespace polydec {

/// Records of a binary file with the same fields, in runs of constant stride.
struct RecordTable {
    struct Field {
        std::int64_t offset = 0; ///< in the record
        NumberType type = NumberType::float64;
    };
    struct Run {
        std::int64_t count = 0;  ///< of records
        std::int64_t begin = 0;  ///< byte of the file
        std::int64_t stride = 0; ///< bytes from one record to the next
    };

    std::vector<Field> fields;
    std::vector<Run> runs = {};

    std::int64_t count() const;

    /// The last byte of its fields within a record, plus one.
    std::int64_t reach() const;
};

/// Contiguous fields of one type.
RecordTable table_of(NumberType type, int fields);

/// The records in [begin, end), one per row. Reads a few MiB at a time. Throws IoError, naming the
/// file, if it has become shorter.
DenseMatrix rows_of(const RecordTable& table, const PartialFile& file, std::endian order,
                    std::int64_t begin, std::int64_t end);

} // namespace polydec
