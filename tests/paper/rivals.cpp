// SPDX-License-Identifier: MIT
#include "examples/paper/rivals/alexa_wardetzky.h"
#include "examples/paper/rivals/bunge_diamond.h"
#include "examples/paper/rivals/bunge_virtual_vertex.h"
#include "examples/paper/rivals/de_goes.h"
#include "tests/paper/rival_surfaces.h"

namespace polydec::paper::in_rivals {

using test::each_says;
using test::refusal;
using test::relative_difference;
using test::says;
using test::Words;

std::vector<std::string> keys(const auto& map) {
    std::vector<std::string> result;
    for (const auto& [key, value] : map)
        result.push_back(key);
    return result;
}

std::vector<bool> on_boundary(const PolygonMesh& mesh) {
    std::map<std::pair<Index, Index>, int> uses;
    for (Index f = 0; f < mesh.size(); ++f) {
        const auto around = mesh.face(f);
        for (std::size_t i = 0; i < around.size(); ++i)
            ++uses[std::minmax({around[i], around[(i + 1) % around.size()]})];
    }
    std::vector<bool> result(static_cast<std::size_t>(mesh.points.rows()), false);
    for (const auto& [edge, count] : uses)
        if (count == 1)
            for (const Index v : {edge.first, edge.second})
                result[static_cast<std::size_t>(v)] = true;
    return result;
}

SparseMatrix transposed(const SparseMatrix& A) {
    return A.transpose();
}

double asymmetry(const SparseMatrix& A) {
    return relative_difference(transposed(A), A);
}

double kernel_defect(const PolygonLaplacian& L) {
    return (L.stiffness * ones(L.stiffness)).cwiseAbs().maxCoeff() / test::largest(L.stiffness);
}

/// Eigenvalues over the largest, ascending.
Vector eigenvalues(const SparseMatrix& A) {
    const Vector all =
        Eigen::SelfAdjointEigenSolver<DenseMatrix>(DenseMatrix(A), Eigen::EigenvaluesOnly)
            .eigenvalues();
    return all / all.maxCoeff();
}

double linear_defect(const PolygonMesh& mesh, const PolygonLaplacian& L) {
    const Points residual = L.stiffness * mesh.points;
    const auto boundary = on_boundary(mesh);
    double worst = 0;
    for (Index v = 0; v < residual.rows(); ++v)
        if (!boundary[static_cast<std::size_t>(v)])
            worst = std::max(worst, residual.row(v).cwiseAbs().maxCoeff());
    return worst / (test::largest(L.stiffness) * mesh.points.cwiseAbs().maxCoeff());
}

/// Through triangles that tile the planar faces.
double area(const PolygonMesh& mesh) {
    const Mesh triangles = split_polygons(mesh);
    double sum = 0;
    for (Index t = 0; t < triangles.simplices.rows(); ++t) {
        const Eigen::Vector3d p = mesh.points.row(triangles.simplices(t, 0)),
                              q = mesh.points.row(triangles.simplices(t, 1)),
                              r = mesh.points.row(triangles.simplices(t, 2));
        sum += (q - p).cross(r - p).norm() / 2;
    }
    return sum;
}

double area_defect(const PolygonMesh& mesh, const PolygonLaplacian& L) {
    return std::abs(ones(L.mass).dot(L.mass * ones(L.mass)) / area(mesh) - 1);
}

double difference(const PolygonLaplacian& L, const PolygonLaplacian& M) {
    return std::max(relative_difference(L.stiffness, M.stiffness),
                    relative_difference(L.mass, M.mass));
}

class Rivals : public testing::TestWithParam<std::tuple<std::string, std::string>> {
protected:
    const Laplacian& laplacian() const { return rivals().at(std::get<0>(GetParam())); }
    const Surface& surface() const { return surfaces().at(std::get<1>(GetParam())); }
    const PolygonMesh& mesh() const { return surface().mesh; }
    bool is(const std::string& rival) const { return std::get<0>(GetParam()) == rival; }
};

TEST_P(Rivals, are_symmetric) {
    const auto L = laplacian()(mesh());
    EXPECT_LE(asymmetry(L.stiffness), 1e-13);
    EXPECT_LE(asymmetry(L.mass), 1e-14);
}

TEST_P(Rivals, send_constants_and_nothing_else_to_zero) {
    const auto L = laplacian()(mesh());
    EXPECT_LE(kernel_defect(L), 1e-13);
    const Vector values = eigenvalues(L.stiffness);
    EXPECT_GE(values[0], -1e-13);
    EXPECT_GE(values[1], 1e-4);
}

TEST_P(Rivals, have_a_positive_mass) {
    EXPECT_GE(eigenvalues(laplacian()(mesh()).mass)[0], 1e-3);
}

TEST_P(Rivals, spread_the_area_over_the_vertices) {
    if (surface().faceted) {
        EXPECT_LE(area_defect(mesh(), laplacian()(mesh())), 1e-13);
    }
}

TEST_P(Rivals, find_linear_functions_harmonic_inside_a_planar_mesh) {
    if (surface().planar) {
        EXPECT_LE(linear_defect(mesh(), laplacian()(mesh())), 1e-13);
    }
}

TEST_P(Rivals, scale_with_the_area) {
    const auto L = laplacian()(mesh());
    for (const double scale : {1e-8, 3.0, 1e8}) {
        auto scaled = mesh();
        scaled.points *= scale;
        const auto M = laplacian()(scaled);
        EXPECT_LE(difference({L.stiffness, L.mass * (scale * scale)}, M), 1e-12) << scale;
    }
}

TEST_P(Rivals, do_not_feel_rigid_motions) {
    const Eigen::Matrix3d rotation =
        Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, -2).normalized()).toRotationMatrix();
    auto turned = mesh();
    turned.points = (mesh().points * rotation).rowwise() + Eigen::RowVector3d(5, -3, 2);
    EXPECT_LE(difference(laplacian()(mesh()), laplacian()(turned)), 1e-11);
}

/// Vertex v becomes vertex v + 1, the last the first; faces come in opposite order, begin at
/// another corner, and every second one, or none, is turned over.
PolygonMesh rearranged(const PolygonMesh& mesh) {
    PolygonMesh result;
    const auto n = static_cast<Index>(mesh.points.rows());
    result.points.resize(n, 3);
    result.points << mesh.points.bottomRows(1), mesh.points.topRows(n - 1);
    for (Index f = mesh.size() - 1; f >= 0; --f) {
        const auto around = mesh.face(f);
        std::vector<Index> face(around.begin(), around.end());
        std::rotate(face.begin(), face.begin() + 1, face.end());
        if (f % 2 == 0)
            std::reverse(face.begin(), face.end());
        for (const Index v : face)
            result.corners.push_back((v + 1) % n);
        result.offsets.push_back(static_cast<Index>(result.corners.size()));
    }
    return result;
}

/// What it is under the old numbers.
SparseMatrix renumbered(const SparseMatrix& A) {
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, Index> order(A.rows());
    for (Index v = 0; v < A.rows(); ++v)
        order.indices()[v] = (v + 1) % static_cast<Index>(A.rows());
    return order.transpose() * A * order;
}

TEST_P(Rivals, do_not_depend_on_numbers_and_orientation) {
    const auto L = laplacian()(mesh());
    const auto M = laplacian()(rearranged(mesh()));
    EXPECT_LE(difference(L, {renumbered(M.stiffness), renumbered(M.mass)}), 1e-12);
    EXPECT_GE(difference(L, M), 1e-3) << "the order matters if it is not undone";
}

/// On triangles: the stiffness of circumcentric duals, whose star_1 is the cotangents.
TEST_P(Rivals, are_the_cotangent_laplacian_on_triangles_but_for_the_diamonds) {
    if (mesh().corners.size() != 3 * static_cast<std::size_t>(mesh().size()))
        return;
    const auto L = laplacian()(mesh());
    const auto made = discretize(split_polygons(mesh()), {.criterion = MergeCriterion::none});
    const SparseMatrix cotangent =
        symmetric_laplacian({made.input(), made.input_geometry().volumes()}, 0);
    const double distance = relative_difference(L.stiffness, cotangent);
    if (is("bunge_diamond")) {
        EXPECT_GE(distance, 0.1);
        EXPECT_GT(L.stiffness.nonZeros(), cotangent.nonZeros());
    } else {
        EXPECT_LE(distance, 1e-12);
        EXPECT_CLOSE(Vector(L.mass * ones(L.mass)), Vector(equal_shares(mesh()) * ones(L.mass)),
                     1e-13);
    }
}

TEST(VirtualVertexMass, on_triangles_is_that_of_linear_elements) {
    for (const auto& name : {"triangles", "icosphere"}) {
        const auto& mesh = surfaces().at(name).mesh;
        const auto linear = assemble(mesh, [](const Polygon& triangle) -> DenseMatrix {
            const DenseMatrix pattern = DenseMatrix::Ones(3, 3) + DenseMatrix::Identity(3, 3);
            return area_vector(triangle).norm() / 12 * pattern;
        });
        const auto L = bunge_virtual_vertex(mesh);
        EXPECT_CLOSE(L.mass, linear, 1e-13);
        EXPECT_GE(relative_difference(bunge_diamond(mesh).mass, linear), 1e-2);
    }
}

INSTANTIATE_TEST_SUITE_P(OnSurfaces, Rivals,
                         testing::Combine(testing::ValuesIn(keys(rivals())),
                                          testing::ValuesIn(keys(surfaces()))),
                         [](const auto& instance) {
                             return std::get<0>(instance.param) + "_on_" +
                                    std::get<1>(instance.param);
                         });

TEST(RivalTwins, break_the_laws) {
    const auto& quads = surfaces().at("quads").mesh;
    const auto graph = of_graph(quads);
    EXPECT_GE(linear_defect(quads, graph), 1e-3);
    EXPECT_GE(area_defect(quads, graph), 0.1);

    const auto L = alexa_wardetzky(quads);
    const SparseMatrix strong =
        equal_shares(quads).diagonal().cwiseInverse().asDiagonal() * L.stiffness;
    EXPECT_GE(asymmetry(strong), 0.1);
    EXPECT_GE(kernel_defect({L.stiffness + L.mass, L.mass}), 1e-2);

    const auto& triangles = surfaces().at("triangles").mesh;
    EXPECT_GE(relative_difference(of_graph(triangles).stiffness, de_goes(triangles).stiffness),
              1e-2);
}

TEST(RivalTwins, without_lambda_do_not_see_a_checkerboard) {
    const auto& squares = surfaces().at("squares").mesh;
    EXPECT_LE(eigenvalues(alexa_wardetzky(squares, 0).stiffness)[1], 1e-13);
    EXPECT_LE(eigenvalues(de_goes(squares, 0).stiffness)[1], 1e-13);
}

/// The row of an inner vertex of a grid of unit squares, by how far the others are away.
double stencil(const PolygonLaplacian& L, Index across, Index up) {
    constexpr Index to_right = 6; // vertices in a column
    constexpr Index center = 3 * to_right + 3;
    return L.stiffness.coeff(center, center + across * to_right + up);
}

TEST(RivalStencils, on_squares_mix_straight_and_diagonal_neighbors) {
    const auto squares = polygons(grid(6, 5, 6.0, 5.0));
    // with t of the straight five-point stencil and 1 - t of the diagonal one
    const auto expect_mix = [&](const PolygonLaplacian& L, double t) {
        EXPECT_NEAR(stencil(L, 0, 0), 2 + 2 * t, 1e-13);
        EXPECT_NEAR(stencil(L, 1, 0), -t, 1e-13);
        EXPECT_NEAR(stencil(L, 0, -1), -t, 1e-13);
        EXPECT_NEAR(stencil(L, 1, 1), -(1 - t) / 2, 1e-13);
        EXPECT_NEAR(stencil(L, -1, 1), -(1 - t) / 2, 1e-13);
    };
    expect_mix(alexa_wardetzky(squares), 4);
    expect_mix(de_goes(squares), 2);
    expect_mix(bunge_virtual_vertex(squares), 0.5);
    expect_mix(alexa_wardetzky(squares, 0.5), 1);
    expect_mix(de_goes(squares, 0.5), 1);
}

TEST(RivalStencils, of_diamonds_on_squares_reach_two_vertices_far) {
    const auto L = bunge_diamond(polygons(grid(6, 5, 6.0, 5.0)));
    const double expected[3][3] = {
        {9.0 / 4, -7.0 / 16, -1.0 / 16}, {-7.0 / 16, 0, -1.0 / 32}, {-1.0 / 16, -1.0 / 32, 0}};
    for (const Index across : {0, 1, 2})
        for (const Index up : {0, 1, 2}) {
            // the grid ends two vertices above the center, where diamonds are half
            EXPECT_NEAR(stencil(L, -across, -up), expected[across][up], 1e-13)
                << across << ", " << up;
        }
}

PolygonMesh square() {
    PolygonMesh mesh;
    mesh.points = Points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    mesh.corners = {0, 1, 2, 3};
    mesh.offsets = {0, 4};
    return mesh;
}

std::vector<std::string> refusals(const PolygonMesh& mesh) {
    std::vector<std::string> messages;
    for (const auto& [name, laplacian] : rivals())
        messages.push_back(refusal([&, &laplacian = laplacian] { laplacian(mesh); }));
    return messages;
}

TEST(RivalErrors, name_the_face_or_vertex) {
    const auto all = [](const Words& words) { return std::vector<Words>(rivals().size(), words); };
    EXPECT_EQ(refusals(square()), std::vector<std::string>(rivals().size(), "accepted"));

    auto mesh = square();
    mesh.corners = {0, 1, 2, 4};
    EXPECT_TRUE(each_says(refusals(mesh), all({"face 0", "vertex 4", "0", "3"})));
    mesh.corners = {0, 1, 1, 3};
    EXPECT_TRUE(each_says(refusals(mesh), all({"face 0", "vertex 1", "twice"})));
    mesh.corners = {0, 2, 0, 2};
    EXPECT_TRUE(each_says(refusals(mesh), all({"face 0", "area"})));
    mesh.corners = {0, 1, 2};
    mesh.offsets = {0, 3};
    EXPECT_TRUE(each_says(refusals(mesh), all({"vertex 3", "no face"})));
    mesh.offsets = {0, 0, 3};
    EXPECT_TRUE(each_says(refusals(mesh), all({"face 0", "0 corners", "3"})));

    mesh = square();
    mesh.points(2, 1) = std::nan("");
    EXPECT_TRUE(each_says(refusals(mesh), all({"vertex 2", "coordinate", "finite"})));
    mesh.points.conservativeResize(Eigen::NoChange, 2);
    EXPECT_TRUE(each_says(refusals(mesh), all({"points", "2 coordinates", "3"})));
}

TEST(RivalErrors, name_what_lambda_should_be) {
    EXPECT_REFUSED(alexa_wardetzky(square(), -1), "lambda", "-1.000000");
    EXPECT_REFUSED(de_goes(square(), std::nan("")), "lambda", "nan");
}

TEST(RivalErrors, name_the_edge_of_a_diamond) {
    auto pages = square();
    pages.points.conservativeResize(5, 3);
    pages.points.row(4) << 0, 0, 1;
    pages.corners = {0, 1, 2, 0, 1, 3, 0, 1, 4};
    pages.offsets = {0, 3, 6, 9};
    EXPECT_REFUSED(bunge_diamond(pages), "edge", "vertex 0", "1", "3 faces", "2");
    EXPECT_NO_THROW(de_goes(pages));
}

/// A U with its notch down to the height `floor`; edge 4, from vertex 4 to 5, is the notch's floor.
PolygonMesh notched(double floor) {
    PolygonMesh mesh;
    mesh.points = Points{{0, 0, 0},     {3, 0, 0},     {3, 3, 0}, {2, 3, 0},
                         {2, floor, 0}, {1, floor, 0}, {1, 3, 0}, {0, 3, 0}};
    mesh.corners = {0, 1, 2, 3, 4, 5, 6, 7};
    mesh.offsets = {0, 8};
    return mesh;
}

/// How high the virtual vertex is above the notch's floor.
double height(double floor) {
    const Polygon polygon = notched(floor).points;
    return (virtual_vertex_weights(polygon).transpose() * polygon)(1) - floor;
}

TEST(RivalErrors, name_the_edge_beyond_which_a_virtual_vertex_lies) {
    ASSERT_GT(height(0.1), 0);
    EXPECT_REFUSED(bunge_diamond(notched(0.1)), "edge", "vertex 3", "4", "diamond");
    EXPECT_GE(area_defect(notched(0.1), bunge_virtual_vertex(notched(0.1))), 1e-2);
    EXPECT_LE(area_defect(notched(0.1), de_goes(notched(0.1))), 1e-14);

    double below = 0.1, above = 1;
    for (int step = 0; step < 60; ++step) {
        const double middle = (below + above) / 2;
        (height(middle) > 0 ? below : above) = middle;
    }
    EXPECT_REFUSED(bunge_virtual_vertex(notched(below)), "face 0", "virtual vertex", "edge",
                   "vertex 4", "5");
}

} // namespace polydec::paper::in_rivals
