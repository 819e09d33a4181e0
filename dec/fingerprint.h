// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <concepts>
#include <cstdint>
#include <string_view>
#include <type_traits>

namespace polydec {

class CellComplex;
class Cells;
class Discretization;
class FormSpace;
class HodgeStar;
class HodgeStars;
struct BoundaryConditions;

/// 64 bits by which what belongs together is known again: the same numbers and words in the same
/// order give the same value on every machine. No protection against intent.
class Fingerprint {
public:
    template <class Word>
    requires std::integral<Word> || std::is_enum_v<Word> Fingerprint& add(Word word) {
        return add_word(static_cast<std::uint64_t>(word));
    }
    Fingerprint& add(double number);
    Fingerprint& add(std::string_view text);
    Fingerprint& add(const Eigen::Ref<const DenseMatrix>& numbers);
    Fingerprint& add(const SparseMatrix& matrix);

    /// All incidences.
    Fingerprint& add(const CellComplex& complex);

    /// Every entry of a star; of all stars, and the volumes of the cells.
    Fingerprint& add(const HodgeStar& star);
    Fingerprint& add(const HodgeStars& stars);

    /// Those of every facet, coefficients, and fixed vertices.
    Fingerprint& add(const BoundaryConditions& conditions);

    /// Incidences, stars and the unit of cells; of a mesh its points as well.
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
