// SPDX-License-Identifier: MIT
#include "tests/support/test.h"

namespace polydec::test::in_glued_pictures {

using std::numbers::pi;

PeriodicMesh torus(int n, int cells) {
    std::vector<Vector> translations;
    for (int axis = 0; axis < n; ++axis)
        translations.push_back(Vector::Unit(n, axis));
    return periodic(kuhn(n, cells), translations);
}

Vector numbers_of(const VtuArray& array) {
    const auto& values = std::get<std::vector<double>>(array.values);
    return Eigen::Map<const Vector>(values.data(), std::ssize(values));
}

/// Of every degree and side: the picture of a form is that of the box with the same form.
TEST(GluedPictures, show_forms_where_cells_lie_in_the_box) {
    for (int n = 1; n <= 3; ++n) {
        const PeriodicMesh glued = torus(n, 4);
        const auto mesh = discretize(glued);
        const Discretization& box = placed(mesh);
        const auto wave = [n](Index size) {
            return [=](const Vector& x) -> Vector {
                return Vector::Constant(size,
                                        std::cos(2 * pi * x[0]) + std::sin(2 * pi * x[n - 1]));
            };
        };
        for (int k = 0; k <= n; ++k) {
            const Index size = k == 0 || k == n ? 1 : n;
            const Cochain form = de_rham(mesh, k, wave(size));
            VtuGrid grid = draw_cells(mesh, k);
            add_field(grid, mesh, k, {"u", form});
            VtuGrid expected = draw_cells(box, k);
            add_field(expected, box, k, {"u", de_rham(box, k, wave(size))});
            EXPECT_EQ(grid.points, glued.box.points);
            EXPECT_EQ(grid.corners, expected.corners);
            const auto& found = k > 0 ? grid.cell_data : grid.point_data;
            const auto& wanted = k > 0 ? expected.cell_data : expected.point_data;
            EXPECT_CLOSE(numbers_of(found.front()), numbers_of(wanted.front()), 1e-12) << n << k;
        }
        const Cochain numbers{Side::dual, 0, Vector::LinSpaced(mesh.complex().size(n), 1, 2)};
        VtuGrid grid = draw_cells(mesh, n);
        add_field(grid, mesh, n, {"u", numbers});
        const Vector shown = numbers_of(grid.cell_data.front());
        const auto cells = cells_of_places(mesh, n);
        for (Index i = 0; i < shown.size(); ++i)
            EXPECT_NEAR(shown[i], numbers.values[cells[i]], 1e-12);
        if (n > 1) {
            const Cochain along = de_rham(
                mesh, 1, [n](const Vector&) -> Vector { return Vector::LinSpaced(n, 1, 2); });
            VtuGrid lines = draw_cells(mesh, 1);
            EXPECT_TRUE(add_vectors(lines, mesh, "a", along));
            const Vector vectors = numbers_of(lines.point_data.front());
            for (Index v = 0; v < glued.box.points.rows(); ++v)
                EXPECT_NEAR(vectors[3 * v], 1, 1e-12);
        }
    }
}

TEST(GluedPictures, number_cells_as_operators_do) {
    const auto mesh = discretize(torus(2, 4));
    StructureOptions options;
    options.numbers = true;
    options.duals = true;
    options.view.width = 1200;
    const SvgDrawing drawing = draw_structure(mesh, options);
    int zeros = 0;
    for (const SvgShape& shape : drawing.shapes)
        if (const auto* text = std::get_if<SvgText>(&shape); text != nullptr && text->text == "0")
            ++zeros;
    EXPECT_EQ(zeros, 4 + 2 + 1) << "vertex 0 in four corners, edge 0 on two sides, cell 0";
    const Cochain u =
        de_rham(mesh, 0, function_form([](const Vector& x) { return std::cos(2 * pi * x[0]); }));
    const LevelSets sets = level_sets(mesh, u, Vector{{0.3}});
    const auto [points, corners] = mesh.places();
    for (Index i = 0; i < sets.mesh.simplices.rows(); ++i) {
        // between the corners of the simplex that it is said to lie in
        const Index owner = sets.owners[static_cast<std::size_t>(i)];
        const Points own = points(corners.row(owner), Eigen::indexing::all);
        for (const Index v : sets.mesh.simplices.row(i)) {
            const auto place = sets.mesh.points.row(v);
            EXPECT_TRUE((place.array() <= own.colwise().maxCoeff().array() + 1e-12).all());
            EXPECT_TRUE((place.array() >= own.colwise().minCoeff().array() - 1e-12).all());
        }
    }
}

TEST(GluedPictures, show_solids_and_pages) {
    const auto mesh = discretize(torus(3, 3));
    const auto all = [](const Vector&) { return true; };
    const Vector values = Vector::LinSpaced(mesh.complex().size(3), 0, 1);
    const SolidFaces faces = kept_faces(mesh, all, values);
    EXPECT_EQ(faces.polygons.offsets.size(), 6 * 9 + 1U) << "the box from outside";
    for (std::size_t i = 0; i < faces.cells.size(); ++i)
        EXPECT_EQ(faces.values[static_cast<Index>(i)], values[faces.cells[i]]);
    const Page page = draw_page(mesh, "torus");
    EXPECT_EQ(page.grid.points.rows(), 64);
}

} // namespace polydec::test::in_glued_pictures
