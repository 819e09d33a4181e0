// SPDX-License-Identifier: MIT
#pragma once

#include "tests/solvers/smooth_waves.h"

/// The cases that solvers are tested on: meshes, stars, sides, degrees and conditions.
namespace polydec::test {

constexpr Side sides[] = {Side::primal, Side::dual};

/// The mesh with stars of a kind, also where those are not positive.
Discretization with_stars(const Mesh& mesh, StarKind star);

/// The unit cube filled with cells of a pattern, so many along an edge.
Mesh unit_cube(const std::string& pattern, int cells);

/// A pattern with a coarse and a fine mesh, and the stars.
struct Case {
    std::string pattern;
    int coarse = 8, fine = 16;
    StarKind star = StarKind::circumcentric;

    std::string name() const;
    int dimension() const { return mesh(coarse).dimension(); }

    /// The mesh of so many cells along an edge, made once.
    const Discretization& mesh(int cells) const;
};

inline std::ostream& operator<<(std::ostream& out, const Case& of) {
    return out << of.name();
}

/// What gtest calls the instance of a suite whose parameter has a name.
template <class Parameter>
std::string name_of(const testing::TestParamInfo<Parameter>& instance) {
    return instance.param.name();
}

/// The power of the length of edges by which errors shrink from the coarse to the fine mesh.
double order(const Case& of, const std::function<double(const Discretization& mesh)>& error);

/// The same for several errors.
Vector orders(const Case& of, const std::function<Vector(const Discretization& mesh)>& errors);

/// Where in the boundary a form is given: everywhere, nowhere, or on the left, with Robin's
/// condition at the other facets or without.
enum class Where { essential, natural, mixed, robin };

constexpr Where everywhere[] = {Where::essential, Where::natural, Where::mixed, Where::robin};

/// The left of the unit cube is the facets at x = 0; of other meshes, those with x below `end`.
BoundaryConditions conditions_of(const Discretization& mesh, Where where, double end = 1e-9);

/// Robin's condition everywhere.
inline BoundaryConditions robin(double coefficient) {
    return {BoundaryCondition::robin, {}, {coefficient}};
}

/// Calls law(side, degree) for the forms on cells of dimension n.
template <class Law>
void for_all_forms(int n, Law law) {
    for (const Side side : sides)
        for (int degree = 0; degree <= n; ++degree) {
            SCOPED_TRACE(name(side) + std::to_string(degree));
            law(side, degree);
        }
}

/// Calls law(side, degree, where) for the forms on cells of dimension n under every condition.
template <class Law>
void for_all_conditions(int n, Law law) {
    for_all_forms(n, [&](Side side, int degree) {
        for (const Where where : everywhere) {
            if (where == Where::robin && degree == n)
                continue; // n-forms have no trace
            SCOPED_TRACE("condition " + std::to_string(static_cast<int>(where)));
            law(side, degree, where);
        }
    });
}

/// The smooth form among discrete ones. Where stars are matrices a dual form is what they make of
/// a primal one.
Cochain exact_form(const Discretization& mesh, Side side, const WaveForm& wave);

/// Norm in the inner product of the form's side, but of cells without dual.
double size_of(const Discretization& mesh, const Cochain& form);

/// All that can be given of a form on the boundary, at random.
BoundaryForms random_data(const CellComplex& complex, Side side, int degree);

/// The conditions' data for the smooth form; of Robin's, the trace's part is added by its star.
BoundaryForms data_of(const Discretization& mesh, Side side, const WaveForm& wave, Where where);

/// Functions of a side, by default with values given on the whole boundary.
FormSpace functions(const Cells& cells, Side side, const BoundaryConditions& conditions = {});

/// The solution of Poisson's problem for functions, of f and of boundary values where they have
/// values (see sites and boundary_sites), and of outward derivatives at facets; what is empty is 0.
PoissonSolution solved(const PoissonSolver& solver, const Vector& f, const Vector& values = {},
                       const Vector& derivatives = {});

/// A form of the space after steps of the heat equation.
Cochain heated(const FormSpace& space, const Cochain& start, double time_step, int steps = 1,
               const std::string& integrator = "backward-euler");

/// A function at places, a row of coordinates each.
Vector at(const Points& sites, const std::function<double(const Vector& point)>& function);

/// Root of the integral of the square of a function with values at vertices or of n-cells.
double l2_norm(const Discretization& mesh, Side side, const Vector& values);

/// Of the facets on the boundary of a full-dimensional mesh, a row each.
DenseMatrix outward_normals(const Discretization& mesh);

} // namespace polydec::test
