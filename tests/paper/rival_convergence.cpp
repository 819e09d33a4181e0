// SPDX-License-Identifier: MIT
#include "tests/paper/rival_surfaces.h"

#include <Eigen/SparseCholesky>

namespace polydec::paper::in_rival_convergence {

/// Solves stiffness u = 20 mass Y for two functions with the mean removed and divided by their
/// norm; the norm of what is between them.
double harmonic_error(const PolygonMesh& mesh, const PolygonLaplacian& L, double coefficient) {
    const auto last = static_cast<Index>(mesh.points.rows()) - 1;
    const auto x = mesh.points.col(0).array(), y = mesh.points.col(1).array(),
               z = mesh.points.col(2).array();
    const auto normalized = [&L](Vector u) -> Vector {
        const Vector weights = L.mass * ones(L.mass);
        u.array() -= weights.dot(u) / weights.sum();
        return u / std::sqrt(u.dot(L.mass * u));
    };
    const Vector Y = normalized((x.square() - y.square()) * (coefficient * z.square() - 1));

    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(
        L.stiffness.topLeftCorner(last, last));
    Vector u = Vector::Zero(last + 1);
    u.head(last) = solver.solve((20 * (L.mass * Y)).head(last));
    const Vector error = normalized(u) - Y;
    return std::sqrt(error.dot(L.mass * error));
}

struct Refinement {
    std::vector<PolygonMesh> meshes;
    double ratio; ///< of the sizes of the last two

    double order(const Laplacian& laplacian, double coefficient = 7) const {
        const auto error = [&](const PolygonMesh& mesh) {
            return harmonic_error(mesh, laplacian(mesh), coefficient);
        };
        return std::log(error(meshes[0]) / error(meshes[1])) / std::log(ratio);
    }
};

const std::map<std::string, Refinement>& spheres() {
    static const std::map<std::string, Refinement> all = {
        {"quads", {{polygons(uv_sphere(32, 16)), polygons(uv_sphere(64, 32))}, 2}},
        {"hexagons", {{polygons(goldberg(6)), polygons(goldberg(12))}, 2}}};
    return all;
}

TEST(RivalConvergence, on_spheres_is_of_second_order) {
    for (const auto& [name, refinement] : spheres())
        for (const auto& [rival, laplacian] : rivals()) {
            const double order = refinement.order(laplacian);
            EXPECT_GE(order, 1.8) << rival << " on " << name;
            EXPECT_LE(order, 2.3) << rival << " on " << name;
        }
}

TEST(RivalConvergence, fails_for_graphs_and_for_what_is_no_eigenfunction) {
    EXPECT_LE(spheres().at("quads").order(of_graph), 0.5);
    for (const auto& [rival, laplacian] : rivals())
        EXPECT_LE(spheres().at("quads").order(laplacian, 4), 0.5) << rival;
}

} // namespace polydec::paper::in_rival_convergence
