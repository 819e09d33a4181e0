// SPDX-License-Identifier: MIT
#pragma once

#include "io/scanner.h"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace polydec {

/// The contents of the section MeshFormat.
struct GmshFormat {
    int major_version = 1; ///< 1, which states no version, 2 or 4
    int minor_version = 0;
    std::optional<std::endian> order = {}; ///< of bytes; none in a text file
    std::size_t size_bytes = 4;            ///< size of a record count in a binary file

    /// Version 4.0, of 2018, has its own order: node by node, and the entity before its dimension.
    bool is_4_0() const { return major_version == 4 && minor_version == 0; }

    /// Whether a block lists the numbers of all its nodes before their places.
    bool numbers_first() const { return major_version == 4 && !is_4_0(); }

    /// The size of a node or element number in a binary file.
    std::size_t number_bytes() const { return is_4_0() ? 4 : size_bytes; }
};

/// Reads the section MeshFormat up to its end. Throws InvalidInput for versions other than 2 to
/// 2.2, 4.0 and 4.1.
GmshFormat read_gmsh_format(Scanner& scanner);

/// Reads the numbers of a section, from text or bytes.
class GmshSource {
public:
    GmshSource(Scanner& scanner, const GmshFormat& format) : scanner_(scanner), format_(format) {}

    std::int64_t integer(std::string_view expected);

    /// A record count, which is wider than an integer since version 4.
    std::int64_t size(std::string_view expected);

    /// A node or element number, which is wider than an integer since version 4.1.
    std::int64_t number(std::string_view expected);

    double real(std::string_view expected);

    /// The dimension of an entity, 0 to 3.
    std::size_t dimension();

    /// A count of records with the given contents per record. Throws InvalidInput if the rest of
    /// the file cannot hold them.
    struct Record {
        std::size_t integers = 0, sizes = 0, reals = 0;
    };
    Index count(std::string_view plural, const Record& record);

    /// The same on a line of text, as in version 2 even if records are binary.
    Index count_on_line(std::string_view plural, const Record& record);

    /// The same check for a number that was already read.
    Index check(std::int64_t number, std::string_view plural, const Record& record) const;

    /// Skips a counted list of integers, after checking that the file can hold it.
    void skip_integers(std::string_view plural);
    void skip_reals(int count);

    const GmshFormat& format() const { return format_; }
    const Scanner& scanner() const { return scanner_; }
    [[noreturn]] void fail(const std::string& text) const { scanner_.fail(text); }

private:
    std::int64_t whole_number(std::size_t bytes, std::string_view expected);

    Scanner& scanner_;
    const GmshFormat& format_;
};

/// A map from numbers in the file to values: sorted pairs, searched by bisection.
class NumberTable {
public:
    void add(std::int64_t number, Index value) { pairs_.emplace_back(number, value); }

    /// Sorts the entries; returns a repeated number, if there is one.
    std::optional<std::int64_t> close();

    std::optional<Index> find(std::int64_t number) const;

private:
    std::vector<std::pair<std::int64_t, Index>> pairs_;
};

} // namespace polydec
