// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"
#include "io/number_type.h"
#include "io/partial_file.h"

#include <bit>
#include <cstdint>
#include <vector>

namespace polydec {

/// Records of a binary file that all have the same numbers, in runs of one width each.
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

    /// The bytes that its fields reach into a record.
    std::int64_t reach() const;
};

/// Fields of one type, one behind the other.
RecordTable table_of(NumberType type, int fields);

/// The records from `begin` to before `end`, a row each. Reads a few MiB at once. Throws IoError,
/// naming the file, if that has become shorter.
DenseMatrix rows_of(const RecordTable& table, const PartialFile& file, std::endian order,
                    std::int64_t begin, std::int64_t end);

} // namespace polydec
