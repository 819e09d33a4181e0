// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <concepts>
#include <cstdint>
#include <string_view>
#include <type_traits>
#include <vector>

namespace polydec {

class CellComplex;
class Cells;
class Discretization;
class FormSpace;
class HodgeStar;
class HodgeStars;
struct BoundaryConditions;

/// A 64-bit hash that recognizes matching data: the same numbers and words in the same order give
/// the same value on every machine. Not cryptographic.
class Fingerprint {
public:
    template <class Word>
    requires std::integral<Word> || std::is_enum_v<Word> Fingerprint& add(Word word) {
        return add_word(static_cast<std::uint64_t>(word));
    }
    template <class Item>
    Fingerprint& add(const std::vector<Item>& items) {
        for (const Item& item : items)
            add(item);
        return *this;
    }
    Fingerprint& add(double number);
    Fingerprint& add(std::string_view text);
    Fingerprint& add(const Eigen::Ref<const DenseMatrix>& numbers);
    Fingerprint& add(const SparseMatrix& matrix);

    /// All incidences.
    Fingerprint& add(const CellComplex& complex);

    /// Every entry of a star; of all stars, plus the volumes of the cells.
    Fingerprint& add(const HodgeStar& star);
    Fingerprint& add(const HodgeStars& stars);

    /// The condition at every facet, coefficients, and fixed vertices.
    Fingerprint& add(const BoundaryConditions& conditions);

    /// Incidences, stars and the unit of cells; of a mesh also its points.
    Fingerprint& add(const Cells& cells);
    Fingerprint& add(const Discretization& mesh);

    /// Its cells, side, degree and conditions, and which cells are fixed.
    Fingerprint& add(const FormSpace& space);

    std::uint64_t value() const { return value_; }

private:
    Fingerprint& add_word(std::uint64_t word);

    std::uint64_t value_ = 0xcbf29ce484222325;
};

} // namespace polydec
