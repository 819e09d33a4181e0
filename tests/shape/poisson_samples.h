// SPDX-License-Identifier: MIT
#pragma once

#include "shape/poisson_pair.h"
#include "tests/shape/known_shapes.h"

namespace polydec::test {

constexpr double everywhere = 1e9; // of sides

/// One problem on any refinement of a mesh.
struct Sample {
    std::string name;
    Mesh mesh;
    std::vector<PartOfBoundary> parts = {};
    bool has_materials = false;
    double flow = 0; ///< where y is greatest
};

inline Eigen::RowVectorXd centroid(const Mesh& mesh, const Pieces& pieces, int k, Index s) {
    Eigen::RowVectorXd sum = Eigen::RowVectorXd::Zero(mesh.points.cols());
    for (int i = 0; i <= k; ++i)
        sum += mesh.points.row(pieces.vertex_number(pieces.simplices(k)(s, i))) / (k + 1);
    return sum;
}

/// A row of coordinates for each.
inline Points vertices_of(const Mesh& mesh) {
    return vertex_points(SimplicialComplex(mesh.simplices), mesh.points);
}

inline Vector f_at(const Points& p) {
    return 1 + p.col(0).array() - 2 * p.col(p.cols() - 1).array();
}

inline PoissonProblem problem_of(const Sample& sample, const Mesh& mesh, const Vector& f) {
    PoissonProblem problem{unmerged(mesh, conditions_of(mesh, sample.parts)), {}, {}};
    const Pieces& pieces = problem.shape.pieces;
    const int n = pieces.dimension();
    if (sample.has_materials) {
        problem.shape.conductivity.resize(pieces.size(n));
        for (Index s = 0; s < pieces.size(n); ++s)
            problem.shape.conductivity[s] = centroid(mesh, pieces, n, s)[0] < 0.5 ? 1 : 10;
    }
    problem.source.resize(pieces.size(n), n + 1);
    for (Index s = 0; s < pieces.size(n); ++s)
        for (int i = 0; i <= n; ++i)
            problem.source(s, i) = f[pieces.simplices(n)(s, i)];
    if (sample.flow != 0) {
        problem.flow = Vector::Zero(pieces.size(n - 1));
        for (Index e = 0; e < problem.flow.size(); ++e)
            if (centroid(mesh, pieces, n - 1, e)[1] > mesh.points.col(1).maxCoeff() - 1e-9)
                problem.flow[e] = sample.flow;
    }
    return problem;
}

inline Vector at_vertices(const Pieces& pieces, const DenseMatrix& corners) {
    Vector values(pieces.size(0));
    const Simplices& simplices = pieces.simplices(pieces.dimension());
    for (Index s = 0; s < simplices.rows(); ++s)
        for (Index i = 0; i < simplices.cols(); ++i)
            values[simplices(s, i)] = corners(s, i);
    return values;
}

/// Galerkin's solution with the boundary values of a function.
inline Vector galerkin(const PoissonProblem& problem, const Vector& start) {
    const PoissonForms forms(problem.shape, "auto");
    const DenseMatrix corners = forms.at_corners(start);
    const LocalData data = forms.local(problem.source, problem.flow);
    return at_vertices(problem.shape.pieces,
                       corners + forms.to_galerkin(corners, data).values.cast<double>());
}

inline const auto is_left = [](const Eigen::RowVectorXd& p) { return p[0] < 1e-9; };
inline const auto is_right = [](const Eigen::RowVectorXd& p) { return p[0] > 1 - 1e-9; };
inline const auto is_any = [](const Eigen::RowVectorXd& p) { return p[0] < everywhere; };

/// f = 1, u = 0 on the boundary.
inline PoissonProblem torsion(const Mesh& mesh) {
    const Shape shape = unmerged(mesh, {BoundaryCondition::essential});
    return {shape, DenseMatrix::Ones(shape.pieces.size(shape.pieces.dimension()), 1), {}};
}

} // namespace polydec::test
