// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"
#include "dec/forms/cochain.h"
#include "dec/forms/derivative.h"
#include "dec/forms/laplacian.h"
#include "dec/forms/star.h"
#include "dec/input_units.h"

namespace polydec {

/// The stars of a discretization in the units of the input; stars() are in its unit(). Throws
/// InvalidInput, naming the degree, for numbers out of range.
inline HodgeStars stars_of_input(const Discretization& mesh) {
    return in_input_units(mesh.stars(), mesh.unit());
}

/// The operators on the cells of a discretization: those of its complex and stars, see there, in
/// the units of the input.
inline SparseMatrix derivative(const Discretization& mesh, int k) {
    return derivative(mesh.complex(), k);
}
inline SparseMatrix dual_derivative(const Discretization& mesh, int j) {
    return dual_derivative(mesh.complex(), j);
}
inline HodgeStar star(const Discretization& mesh, int k) {
    return stars_of_input(mesh)[k];
}
inline Operator codifferential(const Discretization& mesh, int k) {
    return codifferential(mesh.complex(), stars_of_input(mesh), k);
}
inline Operator dual_codifferential(const Discretization& mesh, int j) {
    return dual_codifferential(mesh.complex(), stars_of_input(mesh), j);
}
inline Operator laplacian(const Discretization& mesh, int k) {
    return laplacian(mesh.complex(), stars_of_input(mesh), k);
}
inline Operator dual_laplacian(const Discretization& mesh, int j) {
    return dual_laplacian(mesh.complex(), stars_of_input(mesh), j);
}
inline Operator symmetric_laplacian(const Discretization& mesh, int k) {
    return symmetric_laplacian(mesh.complex(), stars_of_input(mesh), k);
}

/// The same on forms as values.
inline Cochain d(const Discretization& mesh, const Cochain& form) {
    return d(mesh.complex(), form);
}
inline Cochain star(const Discretization& mesh, const Cochain& form) {
    return star(mesh.complex(), stars_of_input(mesh), form);
}
inline Cochain codifferential(const Discretization& mesh, const Cochain& form) {
    return codifferential(mesh.complex(), stars_of_input(mesh), form);
}
inline Cochain laplacian(const Discretization& mesh, const Cochain& form) {
    return laplacian(mesh.complex(), stars_of_input(mesh), form);
}
inline double inner_product(const Discretization& mesh, const Cochain& a, const Cochain& b) {
    return inner_product(mesh.complex(), stars_of_input(mesh), a, b);
}
inline double norm(const Discretization& mesh, const Cochain& form) {
    return norm(mesh.complex(), stars_of_input(mesh), form);
}

} // namespace polydec
