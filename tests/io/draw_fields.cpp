// SPDX-License-Identifier: MIT
//
// Pictures of several fields: each value is found where it belongs, in files, pages and series.
#include "io/pages/page_fields.h"
#include "tests/io/support.h"

namespace polydec::test::in_draw_fields {

std::vector<Discretization> flat_meshes() {
    return {discretize(grid(3, 2)), discretize(well_centered(3)), discretize(kuhn({2, 2, 1}))};
}

const VtuArray* found(const std::vector<VtuArray>& list, const std::string& name) {
    for (const VtuArray& array : list)
        if (array.name == name)
            return &array;
    return nullptr;
}

Vector numbers(const VtuArray& array) {
    const auto& values = std::get<std::vector<double>>(array.values);
    return Eigen::Map<const Vector>(values.data(), std::ssize(values));
}

/// One form of each kind, and vectors at vertices and at cells.
std::vector<NamedForm> all_fields(const Discretization& mesh, double factor = 1) {
    const int n = mesh.dimension();
    std::vector<NamedForm> fields;
    for (int k = 0; k <= n; ++k) {
        const Index size = mesh.complex().size(k);
        fields.emplace_back("p" + std::to_string(k),
                            Cochain{Side::primal, k, factor * random_vector(size, k)});
        fields.emplace_back("d" + std::to_string(n - k),
                            Cochain{Side::dual, n - k, factor * random_vector(size, k + 9)});
    }
    const auto vectors = [&](Index size) {
        return DenseMatrix(factor * random_vector(size * n, 5).reshaped(size, n));
    };
    fields.emplace_back("v", Side::primal, vectors(mesh.complex().size(0)));
    fields.emplace_back("w", Side::dual, vectors(mesh.complex().size(n)));
    return fields;
}

void expect_in(const std::vector<VtuArray>& list, const NamedForm& field) {
    const VtuArray* array = found(list, field.name);
    ASSERT_NE(array, nullptr) << field.name;
    if (field.vectors.size() == 0) {
        EXPECT_EQ(array->components, 1);
        EXPECT_EQ(numbers(*array), field.form.values) << field.name;
        return;
    }
    EXPECT_EQ(array->components, 3);
    for (Index i = 0; i < field.vectors.rows(); ++i)
        for (Index c = 0; c < 3; ++c)
            EXPECT_EQ(numbers(*array)[3 * i + c],
                      c < field.vectors.cols() ? field.vectors(i, c) : 0)
                << field.name;
}

TEST(DrawFields, HasEveryFieldOfAllDegreesTogether) {
    const TemporaryFolder folder;
    for (const Discretization& mesh : flat_meshes()) {
        const int n = mesh.dimension();
        const auto fields = all_fields(mesh);
        const VtuGrid grid = draw_fields(mesh, fields);
        for (const NamedForm& field : fields) {
            const int k = cell_degree(mesh.complex(), field.form.side, field.form.degree);
            expect_in(k == 0 ? grid.point_data : k == n ? grid.cell_data : grid.field_data, field);
        }
        for (const VtuArray& array : grid.field_data)
            EXPECT_EQ(static_cast<Index>(array.size()), mesh.complex().size(array.degree));
        EXPECT_NE(found(grid.point_data, "p1_vector"), nullptr);
        EXPECT_NE(found(grid.point_data, "d1_vector"), nullptr);

        write_vtu(folder.path("a.vtu"), grid);
        const VtuGrid again = read_grid(folder.path("a.vtu"));
        for (std::size_t i = 0; i < grid.point_data.size(); ++i)
            EXPECT_EQ(again.point_data.at(i).values, grid.point_data[i].values);
        for (std::size_t i = 0; i < grid.cell_data.size(); ++i)
            EXPECT_EQ(again.cell_data.at(i).values, grid.cell_data[i].values);
    }
}

TEST(DrawFields, OfOneDegreeAreShownOnCellsOfThatDegree) {
    const auto mesh = discretize(kuhn({2, 1, 1}));
    for (int k = 0; k <= 3; ++k) {
        const Vector values = random_vector(mesh.complex().size(k), 1);
        const VtuGrid grid = draw_fields(
            mesh, {{"a", {Side::primal, k, values}}, {"b", {Side::dual, 3 - k, values}}});
        EXPECT_EQ(numbers(*found(k > 0 ? grid.cell_data : grid.point_data, "b")), values);
        EXPECT_TRUE(grid.field_data.empty());
        EXPECT_EQ(std::ssize(grid.types), mesh.complex().size(k > 0 ? k : 3));
    }
}

TEST(DrawFields, RefuseAWrongNumberOfVectors) {
    const auto mesh = discretize(grid(3, 2));
    EXPECT_REFUSED(draw_fields(mesh, {{"wind", Side::primal, DenseMatrix::Zero(5, 2)}}), "5 rows",
                   "wind", "12");
    EXPECT_REFUSED(draw_fields(mesh, {{"wind", Side::dual, DenseMatrix::Zero(6, 4)}}), "wind",
                   "4 numbers", "3");
}

TEST(DrawFields, InSeriesHaveTheirValuesAtEveryTime) {
    const TemporaryFolder folder;
    for (const Discretization& mesh : flat_meshes()) {
        Series series(folder.path("a.pvd"), mesh);
        for (const double time : {1.0, 2.0, 3.0})
            series.add(time, all_fields(mesh, time));
        series.close();
        const Page page = read_series(folder.path("a.pvd"));
        ASSERT_EQ(page.steps.size(), 3U);
        for (const NamedForm& field : all_fields(mesh, 3)) {
            const int k = cell_degree(mesh.complex(), field.form.side, field.form.degree);
            if (k == 0)
                expect_in(page.steps[2].point_data, field);
            else if (k == mesh.dimension())
                expect_in(page.steps[2].cell_data, field);
        }
        const Vector first = numbers(*found(page.steps[0].point_data, "p1_vector"));
        EXPECT_LE((numbers(*found(page.steps[2].point_data, "p1_vector")) - 3 * first).norm(),
                  1e-13 * first.norm());
    }
}

TEST(DrawFields, OnPagesHaveArrowsAtEveryTime) {
    const auto mesh = discretize(kuhn({2, 1, 1}));
    Page page = draw_page(mesh, all_fields(mesh));
    ASSERT_EQ(page.arrows.size(), 4U) << "of both sides and both degrees";
    EXPECT_EQ(page.shown, "p0");
    page.steps = {draw_step(page, "0", all_fields(mesh, 1)),
                  draw_step(page, "1", all_fields(mesh, 5)),
                  draw_step(page, "2", all_fields(mesh, 2))};
    for (std::size_t i = 0; i < 4; ++i) {
        const Points& once = page.steps[0].vectors.at(i);
        EXPECT_GT(once.norm(), 0);
        EXPECT_LE((page.steps[1].vectors.at(i) - 5 * once).norm(), 1e-13 * once.norm());
    }
    const std::string html = to_html(page);
    EXPECT_NE(html.find("\"vectors3.2\""), std::string::npos);
    EXPECT_NE(html.find("\"step\":1,"), std::string::npos) << "which has the largest range";
    for (const char* place : {"vertex", "edge", "face", "cell"})
        EXPECT_NE(html.find("\"place\":\"" + std::string(place) + "\""), std::string::npos);

    page.steps[2].vectors.pop_back();
    EXPECT_REFUSED(to_html(page), "step 2", "3", "4 arrows", "expected");
}

TEST(DrawFields, OnEdgesAndFacesHaveTheLengthsOfTheirVectorsAtEveryTime) {
    const auto mesh = discretize(kuhn({2, 1, 1}));
    Page page = draw_page(mesh, all_fields(mesh));
    page.steps = {draw_step(page, "0", all_fields(mesh, 1)),
                  draw_step(page, "1", all_fields(mesh, 5))};
    const auto fields = page_fields(page, 3, &mesh.complex());
    for (std::size_t i = 0; i < 4; ++i) {
        const auto lengths = strengths(page, fields, page.arrows[i], mesh.complex().size(3));
        ASSERT_EQ(lengths.size(), 2U) << page.arrows[i].field;
        EXPECT_EQ(numbers(lengths[0]), page.steps[0].vectors[i].rowwise().stableNorm());
        EXPECT_EQ(numbers(lengths[1]), page.steps[1].vectors[i].rowwise().stableNorm());
        EXPECT_EQ(range_of(lengths)[1], numbers(lengths[1]).maxCoeff());
    }
}

/// The numbers of edges are larger in the first step, on longer edges.
TEST(DrawFields, OnPagesOpenWhereVectorsAreLongestNotTheNumbersOfEdges) {
    const auto mesh = discretize(grid(4, 4, 100, 1));
    const auto field = [&](int axis, double factor) {
        return std::vector<NamedForm>{{"X", de_rham(mesh, 1, [=](const Vector& point) {
                                           Vector X = Vector::Zero(2);
                                           X[axis] = factor * point[0] / 100;
                                           return X;
                                       })}};
    };
    Page page = draw_page(mesh, field(0, 1));
    page.steps = {draw_step(page, "0", field(0, 1)), draw_step(page, "1", field(1, 3))};
    EXPECT_NE(to_html(page).find("\"step\":1,"), std::string::npos);
}

TEST(LevelSetsOfForms, AreOrientedAsTheBoundaryOfWhereTheFormIsLess) {
    for (int n = 2; n <= 4; ++n) {
        const auto mesh = discretize(kuhn(n, 3));
        const Eigen::RowVectorXd center = Eigen::RowVectorXd::Constant(n, 0.5);
        const Cochain squared = de_rham(mesh, 0, function_form([&](const Vector& x) {
                                            return (x.transpose() - center).squaredNorm();
                                        }));
        const LevelSets sets = level_sets(mesh, squared, Vector{{0.2}});
        EXPECT_GT(sets.mesh.simplices.rows(), 0);
        for (const auto corners : sets.mesh.simplices.rowwise()) {
            const Points rays = sets.mesh.points(corners, Eigen::indexing::all).rowwise() - center;
            EXPECT_GT(DenseMatrix(rays).determinant(), 0) << n << " dimensions";
        }
    }
}

TEST(DrawFields, OnFacesOrEdgesNeedAMesh) {
    Page page;
    page.grid = draw_fields(discretize(grid(3, 2)), all_fields(discretize(grid(3, 2))));
    EXPECT_REFUSED(to_html(page), "p1", "degree 1", "mesh");
}

} // namespace polydec::test::in_draw_fields
