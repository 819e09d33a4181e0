// SPDX-License-Identifier: MIT
#pragma once

#include "tests/shape/shapes.h"

namespace polydec::test {

/// A shape with eigenvalues in closed form, ascending and all there are below some number.
struct KnownShape {
    std::string name;
    Shape shape;
    std::vector<double> eigenvalues;
};

constexpr double pi = 3.14159265358979323846;

/// The shape of the simplices of a mesh, none merged.
Shape unmerged(const Mesh& mesh,
               const BoundaryConditions& conditions = {BoundaryCondition::natural});
Shape unmerged(const PeriodicMesh& mesh);

/// The shape of a box of these sides whose left is glued to its right, and its bottom to its top
/// the other way round.
Shape glued_bottle(const Mesh& box, double a, double b);

/// Conditions by facet: at facets whose centroid fulfills a predicate these, elsewhere natural.
struct PartOfBoundary {
    std::function<bool(const Eigen::RowVectorXd& centroid)> where;
    BoundaryCondition condition;
    double coefficient = 0;
};
BoundaryConditions conditions_of(const Mesh& mesh, const std::vector<PartOfBoundary>& parts);

/// All sums below `limit` of one number from each ascending list.
std::vector<double> sums(const std::vector<std::vector<double>>& lists, double limit);

/// Eigenvalues of -u'' on an interval below `limit`, with - u' + left u = 0 and u' + right u = 0;
/// infinity: u = 0.
std::vector<double> interval_eigenvalues(double length, double left, double right, double limit);

/// A box of Kuhn's simplices, inner vertices moved at random, each pair of sides with conditions of
/// its own: natural, essential, Robin's or two of them.
KnownShape random_box(std::mt19937& random, const std::vector<int>& cells);

/// A flat torus of three to five cells each way, sheared and perturbed.
KnownShape random_torus(std::mt19937& random);

/// A Klein bottle, functions or twisted 2-forms.
KnownShape klein_bottle(std::mt19937& random, ShapeFunctions functions);

/// Pages, rectangles that share a side, natural conditions.
KnownShape book(std::mt19937& random, int pages, int cells);

/// Three squares of side 1 around the corner of an L, of 2 n^2 triangles each.
Mesh l_shape(int n);

/// Two unit squares of 2 n^2 triangles, glued along their boundaries.
Mesh pillow(int n);

/// Each triangle divided into four: the same surface.
Mesh divided(const Mesh& mesh);

/// Values at the vertices of the divided mesh of a function that is linear on triangles.
Vector divided(const Pieces& pieces, const Vector& values);

/// Expects bounds of as many eigenvalues as there are of both to enclose these, but for a share of
/// them.
void expect_enclosed(const ShapeSpectrum& found, const std::vector<double>& eigenvalues,
                     double share = 0);

/// Small shapes of every kind, with names: domains, surfaces, a solid, conditions, materials.
std::vector<std::pair<std::string, Shape>> small_shapes();

/// One of those with eigenvalues in closed form: tori, Klein bottles, books, boxes.
KnownShape random_shape(std::mt19937& random);

} // namespace polydec::test
