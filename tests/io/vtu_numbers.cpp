// SPDX-License-Identifier: MIT
#include "tests/io/support.h"

namespace polydec::test::in_vtu_numbers {

constexpr VtuOptions in_floats{VtuNumbers::float32};

VtuGrid two_triangles() {
    VtuGrid grid;
    grid.points = Points::Random(4, 3);
    add_polygon(grid, std::vector<Index>{0, 1, 2});
    add_polygon(grid, std::vector<Index>{0, 2, 3});
    grid.point_data.push_back(vtu_array("u", Vector::Random(4)));
    grid.cell_data.push_back(vtu_array("v", DenseMatrix::Random(2, 3)));
    grid.cell_data.push_back({"tag", std::vector<Index>{std::numeric_limits<Index>::max(), -7}});
    grid.field_data.push_back(vtu_array("eigenvalues", Vector::Random(5)));
    return grid;
}

std::string text_of(const VtuGrid& grid, const VtuOptions& options = {}) {
    const TemporaryFolder folder;
    write_vtu(folder.path("a.vtu"), grid, options);
    return read_text(folder.path("a.vtu"));
}

VtuGrid read_again(const VtuGrid& grid, const VtuOptions& options) {
    const TemporaryFolder folder;
    write_vtu(folder.path("a.vtu"), grid, options);
    return read_grid(folder.path("a.vtu"));
}

std::vector<double> as_floats(std::vector<double> numbers) {
    for (double& number : numbers)
        number = static_cast<float>(number);
    return numbers;
}

const std::vector<double>& doubles(const VtuArray& array) {
    return std::get<std::vector<double>>(array.values);
}

std::string float_error(const VtuGrid& grid) {
    return refusal([&grid] { write_vtu("a.vtu", grid, in_floats); });
}

TEST(VtuNumbers, AreRoundedToTheNearestFloatAndOtherwiseExact) {
    const auto grid = two_triangles();
    for (const auto& options : {VtuOptions{}, in_floats}) {
        const bool exact = options.numbers == VtuNumbers::float64;
        const auto found = read_again(grid, options);
        EXPECT_EQ(found.points == grid.points, exact); // the twin: neither does for the other
        EXPECT_EQ(found.points == grid.points.cast<float>().cast<double>(), !exact);
        for (const auto& [list, own] : {std::pair{&found.point_data[0], &grid.point_data[0]},
                                        std::pair{&found.cell_data[0], &grid.cell_data[0]}}) {
            EXPECT_EQ(doubles(*list) == doubles(*own), exact);
            EXPECT_EQ(doubles(*list) == as_floats(doubles(*own)), !exact);
        }
        EXPECT_EQ(doubles(found.cell_data[1]), (std::vector<double>{2147483647, -7}));
    }
}

TEST(VtuNumbers, OfTheWholeKeepAllDigitsAndSayHowManyTheyAre) {
    for (const auto& options : {VtuOptions{}, in_floats}) {
        const auto text = text_of(two_triangles(), options);
        const auto begin = text.find("<FieldData>\n");
        EXPECT_LT(begin, text.find("<Piece"));
        EXPECT_EQ(text.substr(begin + 12, text.find('\n', begin + 12) - begin - 12),
                  "<DataArray type=\"Float64\" Name=\"eigenvalues\" NumberOfTuples=\"5\" "
                  "format=\"binary\">");
    }
    auto grid = two_triangles();
    grid.field_data.clear();
    EXPECT_EQ(text_of(grid).find("FieldData"), std::string::npos);
}

TEST(VtuNumbers, OfTheSameGridAreTheSameBytes) {
    const auto grid = two_triangles();
    auto other = grid;
    EXPECT_EQ(text_of(grid, in_floats), text_of(other, in_floats));
    other.points(1, 1) = std::nextafter(static_cast<float>(other.points(1, 1)), 2.0F);
    EXPECT_NE(text_of(grid, in_floats), text_of(other, in_floats));
}

TEST(VtuNumbers, ThatFloatsCannotHoldAreRefused) {
    const double large = 2.0 * std::numeric_limits<float>::max();
    auto grid = two_triangles();
    grid.field_data[0] = {"shift", std::vector<double>{large}};
    EXPECT_EQ(text_of(grid, in_floats).substr(0, 5), "<?xml");
    std::get<std::vector<double>>(grid.cell_data[0].values)[4] = -large;
    EXPECT_EQ(text_of(grid).substr(0, 5), "<?xml");
    EXPECT_SAYS(float_error(grid), "a.vtu", "array", "v", "cells", "-6.805646932770577e+38",
                "entry 1", "Float32");
    grid.points(2, 0) = large;
    EXPECT_SAYS(float_error(grid), "a.vtu", "point 2", "coordinate", "Float32");
}

TEST(VtuNumbers, OfTheWholeAreFiniteAndHaveNames) {
    auto grid = two_triangles();
    grid.field_data.push_back(grid.field_data[0]);
    EXPECT_SAYS(float_error(grid), "a.vtu", "name 'eigenvalues'", "not unique");
    grid.field_data[1] = {"times", std::vector<double>{0, std::nan("")}};
    EXPECT_SAYS(float_error(grid), "a.vtu", "array", "times", "NaN", "entry 1");
    grid.field_data[1] = {"times", std::vector<double>(4), 3};
    EXPECT_SAYS(float_error(grid), "a.vtu", "array", "times", "4 values", "3 components", "1", "3");
}

TEST(VtuVectors, OfADifferentialAreTheGradient) {
    for (const double scale : {1.0, std::ldexp(1.0, 60)}) {
        Mesh input = grid(3, 2);
        input.points.conservativeResize(input.points.rows() + 1, 2); // of no cell
        input.points.bottomRows(1).setConstant(0.5);
        const Vector x = 3 * input.points.col(0) - input.points.col(1);
        input.points *= scale;
        const auto mesh = discretize(std::move(input));
        const Cochain dx{Side::primal, 1,
                         derivative(mesh.complex(), 0) * x.head(mesh.complex().size(0))};
        auto picture = draw_cells(mesh, 1);
        EXPECT_FALSE(
            add_vectors(picture, mesh, "f", {Side::primal, 0, x.head(mesh.complex().size(0))}));
        EXPECT_TRUE(add_vectors(picture, mesh, "f", dx));
        ASSERT_EQ(picture.point_data.size(), 1U);
        EXPECT_EQ(picture.point_data[0].name, "f_vector");
        const auto& values = doubles(picture.point_data[0]);
        ASSERT_EQ(std::ssize(values), 3 * picture.points.rows());
        constexpr std::array gradient{3.0, -1.0, 0.0};
        for (std::size_t i = 0; i < values.size(); ++i)
            EXPECT_NEAR(values[i] * scale, i + 3 < values.size() ? gradient[i % 3] : 0, 1e-13);
    }
}

TEST(VtuSpectra, TellWhatProvesThem) {
    const auto mesh = discretize(grid(3, 3));
    const auto found = spectrum({mesh, Side::primal, 1}, {.count = 3});
    const auto picture = draw_modes(mesh, found);
    const auto& field = picture.field_data;
    std::vector<std::string> names;
    for (const auto& array : field)
        names.push_back(array.name);
    EXPECT_EQ(names,
              (std::vector<std::string>{"eigenvalues", "radii", "residuals", "shift", "below_shift",
                                        "returned_below_shift", "complete", "degree", "is_dual"}));
    EXPECT_EQ(doubles(field[0]),
              std::vector<double>(found.eigenvalues.begin(), found.eigenvalues.end()));
    EXPECT_EQ(doubles(field[1]), std::vector<double>(found.radii.begin(), found.radii.end()));
    EXPECT_EQ(std::get<std::vector<Index>>(field[6].values), std::vector<Index>{1});
    EXPECT_EQ(std::get<std::vector<Index>>(field[7].values), std::vector<Index>{1});
    EXPECT_EQ(picture.point_data.size(), 3U);
    EXPECT_EQ(picture.cell_data.size(), 3U);
}

} // namespace polydec::test::in_vtu_numbers
