// SPDX-License-Identifier: MIT
#include "tests/io/support.h"

#include <rapidcheck.h>

namespace polydec::test::in_round_trip {

/// Every file is synced to the disk: fewer random cases, unless the caller wants another number.
[[maybe_unused]] const int few_cases = ::setenv("RC_PARAMS", "max_success=20", 0);

/// Any finite doubles, of all magnitudes.
double any_double() {
    const double mantissa = *rc::gen::inRange<std::int64_t>(-(1LL << 53), 1LL << 53);
    return std::ldexp(mantissa, *rc::gen::inRange(-1100, 960));
}

Mesh any_mesh(int ambient, int dimension) {
    const int vertices = *rc::gen::inRange(dimension + 1, 20);
    const int cells = *rc::gen::inRange(1, 20);
    Mesh mesh;
    mesh.points = Points::NullaryExpr(vertices, ambient, [] { return any_double(); });
    mesh.simplices = Simplices::NullaryExpr(cells, dimension + 1,
                                            [vertices] { return *rc::gen::inRange(0, vertices); });
    return mesh;
}

Mesh written_and_read(const std::string& name, const Mesh& mesh) {
    const TemporaryFolder folder;
    write_mesh(folder.path(name), mesh);
    return read_mesh(folder.path(name));
}

PolygonMesh pentagon_and_square() {
    PolygonMesh mesh;
    mesh.points = Points{{0, 0}, {1, 0}, {1.5, 1}, {0.5, 2}, {-0.5, 1}, {2, -1}, {3, 0}};
    mesh.corners = {0, 1, 2, 3, 4, 1, 5, 6, 2};
    mesh.offsets = {0, 5, 9};
    return mesh;
}

Mesh any_triangle() {
    return {Points{{0, 0}, {1, 0}, {0, 1}}, Simplices{{0, 1, 2}}, {}};
}

std::string writing_error(const std::string& name, const Mesh& mesh) {
    return refusal([&] { write_mesh(name, mesh); });
}

TEST(RoundTrip, SurfacesInSpaceAreTheSameInEveryTextFormat) {
    EXPECT_TRUE(rc::check([] {
        const auto mesh = any_mesh(3, 2);
        for (const char* name : {"a.off", "a.obj", "a.ply", "a.nsc", "a.mesh"})
            RC_ASSERT(same(written_and_read(name, mesh), mesh));
    }));
}

TEST(RoundTrip, PlanarSurfacesGetZeros) {
    EXPECT_TRUE(rc::check([] {
        const auto mesh = any_mesh(2, 2);
        Mesh padded = mesh;
        padded.points.conservativeResizeLike(Points::Zero(mesh.points.rows(), 3));
        for (const char* name : {"a.off", "a.obj", "a.ply"})
            RC_ASSERT(same(written_and_read(name, mesh), padded));
        for (const char* name : {"a.nsc", "a.mesh"})
            RC_ASSERT(same(written_and_read(name, mesh), mesh));
    }));
}

TEST(RoundTrip, EveryDimensionIsTheSameInNsc) {
    EXPECT_TRUE(rc::check([] {
        const int ambient = *rc::gen::inRange(1, 7);
        const auto mesh = any_mesh(ambient, *rc::gen::inRange(1, ambient + 1));
        RC_ASSERT(same(written_and_read("a.nsc", mesh), mesh));
    }));
}

TEST(RoundTrip, EdgesAndTetrahedraAreTheSameInMedit) {
    EXPECT_TRUE(rc::check([] {
        for (const int dimension : {1, 3}) {
            const auto mesh = any_mesh(3, dimension);
            RC_ASSERT(same(written_and_read("a.mesh", mesh), mesh));
        }
    }));
}

TEST(RoundTrip, FacetsWithTagsAreTheSameInMeditAndLostInNsc) {
    EXPECT_TRUE(rc::check([] {
        for (const int dimension : {2, 3}) {
            auto mesh = any_mesh(3, dimension);
            const auto facets = *rc::gen::inRange(1, 9);
            const int vertices = static_cast<int>(mesh.points.rows());
            mesh.facet_tags = {
                Simplices::NullaryExpr(facets, dimension,
                                       [vertices] { return *rc::gen::inRange(0, vertices); }),
                {}};
            for (int i = 0; i < facets; ++i)
                mesh.facet_tags.tags.push_back(*rc::gen::nonZero<Index>());
            RC_ASSERT(same(written_and_read("a.mesh", mesh), mesh));
            RC_ASSERT(!same(written_and_read("a.nsc", mesh), mesh));
        }
    }));
}

TEST(RoundTrip, FacetsWithTagsMustFitTheMesh) {
    Mesh mesh = any_triangle();
    mesh.facet_tags = {Simplices{{0, 1}}, {}};
    EXPECT_SAYS(writing_error("a.mesh", mesh), "0 tags", "1 facets");
    mesh.facet_tags.tags = {3};
    mesh.facet_tags.simplices = Simplices{{0, 1, 2}};
    EXPECT_SAYS(writing_error("a.mesh", mesh), "facets", "3 vertices", "2", "dimension 2");
    mesh.facet_tags.simplices = Simplices{{1, 3}};
    EXPECT_SAYS(writing_error("a.mesh", mesh), "facet 0", "tags", "vertices 1 3", "3");
}

TEST(RoundTrip, StlKeepsFloatsAndTheOrderOfCells) {
    EXPECT_TRUE(rc::check([] {
        Mesh mesh = any_mesh(3, 2);
        mesh.points = Points::NullaryExpr(mesh.points.rows(), 3, [] {
            return static_cast<double>(static_cast<float>(*rc::gen::inRange(-1000000, 1000000)) /
                                       7);
        });
        const auto read = written_and_read("a.stl", mesh);
        RC_ASSERT(read.simplices.rows() == mesh.simplices.rows());
        for (Eigen::Index i = 0; i < mesh.simplices.size(); ++i)
            RC_ASSERT(read.points.row(read.simplices.data()[i]) ==
                      mesh.points.row(mesh.simplices.data()[i]));
        RC_ASSERT(same(written_and_read("a.stl", read), read));
    }));
}

TEST(RoundTrip, StlHasUnitNormals) {
    Mesh mesh = made_of({{0, 0, 0}, {2, 0, 0}, {0, 3, 0}, {4, 0, 0}}, {{0, 1, 2}, {0, 1, 3}});
    const TemporaryFolder folder;
    write_mesh(folder.path("a.stl"), mesh);
    const auto text = read_text(folder.path("a.stl"));
    EXPECT_EQ(text.size(), 184U);
    EXPECT_EQ(text.substr(84, 12), std::string("\0\0\0\0\0\0\0\0\0\0\x80\x3F", 12));
    EXPECT_EQ(text.substr(134, 12), std::string(12, '\0'));
}

TEST(RoundTrip, GoldenMeshesAreTheSame) {
    const std::filesystem::path golden = std::filesystem::path(POLYDEC_TEST_FILES) / "golden";
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(golden)) {
        const auto extension = entry.path().extension();
        if (extension == ".off" || extension == ".nsc") {
            const auto mesh = read_mesh(entry.path());
            EXPECT_TRUE(same(written_and_read("a.nsc", mesh), mesh)) << entry.path();
            ++count;
        }
    }
    EXPECT_GT(count, 10);
}

TEST(RoundTrip, PolygonsAreWrittenAsPolygons) {
    const TemporaryFolder folder;
    const auto mesh = pentagon_and_square();
    write_mesh(folder.path("a.off"), mesh);
    EXPECT_EQ(read_text(folder.path("a.off")),
              "OFF\n7 2 0\n0 0 0\n1 0 0\n1.5 1 0\n0.5 2 0\n-0.5 1 0\n2 -1 0\n3 0 0\n5 0 1 2 3 4\n"
              "4 1 5 6 2\n");
    write_mesh(folder.path("a.obj"), mesh);
    EXPECT_EQ(read_text(folder.path("a.obj")),
              "v 0 0 0\nv 1 0 0\nv 1.5 1 0\nv 0.5 2 0\nv -0.5 1 0\nv 2 -1 0\nv 3 0 0\n"
              "f 1 2 3 4 5\nf 2 6 7 3\n");
    write_mesh(folder.path("a.ply"), mesh);
    const std::string header =
        "ply\nformat binary_little_endian 1.0\nelement vertex 7\nproperty double x\n"
        "property double y\nproperty double z\nelement face 2\n"
        "property list uchar int vertex_indices\nend_header\n";
    const std::string ply = read_text(folder.path("a.ply"));
    EXPECT_EQ(ply.substr(0, header.size()), header);
    EXPECT_EQ(ply.size(), header.size() + 7 * 3 * 8 + (1 + 5 * 4) + (1 + 4 * 4));
    for (const char* name : {"a.off", "a.obj", "a.ply"}) {
        EXPECT_EQ(rows(read_mesh(folder.path(name)).simplices),
                  rows(split_polygons(mesh).simplices));
    }
}

TEST(RoundTrip, PolygonsOfVeryManyCornersFitIntoPly) {
    PolygonMesh mesh;
    mesh.points = Points(300, 2);
    for (Index i = 0; i < 300; ++i) {
        mesh.points.row(i) << std::cos(0.02 * i), std::sin(0.02 * i);
        mesh.corners.push_back(i);
    }
    mesh.offsets.push_back(300);
    const TemporaryFolder folder;
    write_mesh(folder.path("a.ply"), mesh);
    EXPECT_EQ(read_mesh(folder.path("a.ply")).simplices.rows(), 298);
}

TEST(WriteMesh, RefusesWhatTheFormatCannotHold) {
    Mesh mesh;
    mesh.points = Points::Identity(5, 4);
    mesh.simplices = Simplices{{0, 1, 2, 3, 4}};
    EXPECT_SAYS(writing_error("a.off", mesh), "a.off", "4-simplices", "R^4", ".nsc");
    EXPECT_SAYS(writing_error("a.mesh", mesh), "a.mesh", "MEDIT", "4-simplices", "R^4", ".nsc");
    EXPECT_SAYS(writing_error("a.vtk", mesh), "a.vtk", "'.vtk'", "extension");
    mesh.simplices(0, 3) = 5;
    EXPECT_SAYS(writing_error("a.nsc", mesh), "a.nsc", "cell 0", "vertex 5", "0", "4");
    mesh.points(2, 1) = std::nan("");
    EXPECT_SAYS(writing_error("a.nsc", mesh), "a.nsc", "vertex 2", "coordinate", "NaN");
}

TEST(WriteMesh, RefusesCoordinatesBeyondTheFloatsOfStl) {
    Mesh mesh;
    mesh.points = Points::Identity(3, 3) * 1e39;
    mesh.simplices = Simplices{{0, 1, 2}};
    const TemporaryFolder folder;
    const auto path = folder.path("a.stl");
    EXPECT_REFUSED(write_mesh(path, mesh), path.string(), "vertex 0", "large", "STL");
    EXPECT_TRUE(folder.names().empty());
}

TEST(WriteMesh, RefusesPolygonsThatDoNotFit) {
    auto mesh = pentagon_and_square();
    EXPECT_REFUSED(write_mesh("a.stl", mesh), "a.stl", "'.stl'", "extension", "polygons");
    mesh.corners[0] = -1;
    EXPECT_REFUSED(write_mesh("a.off", mesh), "face 0", "vertex -1", "0", "6");
    mesh.corners[0] = 0;
    mesh.points = Points::Zero(7, 4);
    EXPECT_REFUSED(write_mesh("a.off", mesh), "a.off", "polygons", "R^4", ".nsc");
}

} // namespace polydec::test::in_round_trip
