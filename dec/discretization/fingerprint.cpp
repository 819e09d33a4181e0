// SPDX-License-Identifier: MIT
#include "dec/discretization/fingerprint.h"

#include "dec/boundary/form_space.h"
#include "dec/discretization/discretization.h"

#include <bit>

namespace polydec {

Fingerprint& Fingerprint::add_word(std::uint64_t word) {
    value_ = (value_ ^ word) * 0x9e3779b97f4a7c15;
    value_ ^= value_ >> 29;
    return *this;
}

Fingerprint& Fingerprint::add(double number) {
    return add(std::bit_cast<std::uint64_t>(number));
}

Fingerprint& Fingerprint::add(std::string_view text) {
    add(text.size());
    for (const char c : text)
        add(static_cast<unsigned char>(c));
    return *this;
}

Fingerprint& Fingerprint::add(const Eigen::Ref<const DenseMatrix>& numbers) {
    add(numbers.rows()).add(numbers.cols());
    for (Eigen::Index j = 0; j < numbers.cols(); ++j)
        for (Eigen::Index i = 0; i < numbers.rows(); ++i)
            add(numbers(i, j));
    return *this;
}

Fingerprint& Fingerprint::add(const SparseMatrix& matrix) {
    add(matrix.rows()).add(matrix.cols());
    for (Index row = 0; row < matrix.outerSize(); ++row)
        for (SparseMatrix::InnerIterator entry(matrix, row); entry; ++entry)
            add(row).add(entry.col()).add(entry.value());
    return *this;
}

Fingerprint& Fingerprint::add(const CellComplex& complex) {
    for (int k = 1; k <= complex.dimension(); ++k)
        for (Index cell = 0; cell < complex.size(k); ++cell)
            for (const SignedFace& f : complex.incidences(k - 1)[cell])
                add(2 * std::int64_t{f.face} + (f.sign > 0));
    return *this;
}

Fingerprint& Fingerprint::add(const HodgeStar& star) {
    return star.is_diagonal() ? add(star.diagonal()) : add(star.matrix());
}

Fingerprint& Fingerprint::add(const HodgeStars& stars) {
    for (int k = 0; k <= stars.dimension(); ++k)
        add(stars.volumes().primal(k)).add(stars.volumes().dual(k)).add(stars[k]);
    return *this;
}

Fingerprint& Fingerprint::add(const BoundaryConditions& conditions) {
    add(conditions.everywhere).add(conditions.facets.size()).add(conditions.coefficients.size());
    return add(conditions.facets).add(conditions.coefficients).add(conditions.fixed_vertices);
}

Fingerprint& Fingerprint::add(const Cells& cells) {
    return add(cells.complex()).add(cells.stars()).add(cells.unit());
}

Fingerprint& Fingerprint::add(const Discretization& mesh) {
    add(static_cast<const Cells&>(mesh)).add(name(mesh.chosen_stars().kind));
    return add(DenseMatrix(mesh.measured_points()));
}

Fingerprint& Fingerprint::add(const FormSpace& space) {
    add(space.cells()).add(space.side()).add(space.degree()).add(space.conditions());
    return add(space.fixed());
}

} // namespace polydec
