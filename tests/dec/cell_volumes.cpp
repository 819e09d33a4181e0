// SPDX-License-Identifier: MIT
#include "dec/metric/angle_sums.h"
#include "dec/metric/pack.h"
#include "tests/support/test.h"

namespace polydec::test::in_cell_volumes {

std::vector<Vector> three_degrees(Index size) {
    return std::vector<Vector>(3, Vector::Ones(size));
}

std::string refusal_of_primal(double value) {
    auto primal = three_degrees(4);
    primal[1][3] = value;
    return refusal([&] { CellVolumes(primal, three_degrees(4)); });
}

TEST(CellVolumesErrors, name_degree_and_cell_of_what_is_no_volume) {
    EXPECT_SAYS(refusal_of_primal(0), "1-cell 3", "volume 0");
    EXPECT_SAYS(refusal_of_primal(-1.5), "1-cell 3", "volume", "-1.5");
    EXPECT_SAYS(refusal_of_primal(std::numeric_limits<double>::infinity()), "1-cell 3", "volume",
                "inf");
    auto dual = three_degrees(4);
    dual[2][1] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_REFUSED(CellVolumes(three_degrees(4), dual), "2-cell 1", "dual volume", "nan");
}

TEST(CellVolumesErrors, name_sizes_that_differ) {
    auto dual = three_degrees(4);
    EXPECT_REFUSED(CellVolumes(three_degrees(4), {dual[0], dual[1]}), "2 degrees", "dual volumes",
                   "3");
    dual[1] = Vector::Ones(5);
    EXPECT_REFUSED(CellVolumes(three_degrees(4), dual), "4 volumes", "5 dual volumes", "5 terms",
                   "5 rounding errors", "1-cells");
}

TEST(CellVolumesErrors, name_the_degrees_that_there_are) {
    const CellVolumes volumes(three_degrees(4), three_degrees(4));
    EXPECT_EQ(volumes.dimension(), 2);
    for (const int k : {-1, 3}) {
        const Words expected{std::to_string(k) + "-cells", "degree", "0", "2"};
        EXPECT_REFUSED(volumes.primal(k), expected);
        EXPECT_REFUSED(volumes.dual(k), expected);
        EXPECT_REFUSED(volumes.terms(k), expected);
        EXPECT_REFUSED(volumes.with_dual(k, Vector::Ones(4)), expected);
    }
    EXPECT_EQ(CellVolumes().dimension(), -1);
    EXPECT_REFUSED(CellVolumes().dual(0), "0-cells", "no cells");
}

TEST(AngleSums, leave_out_a_simplex_with_three_corners_on_a_line) {
    Points points(5, 3);
    points << 0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 1, 0, 0, 0, 1;
    Simplices simplices(2, 4);
    simplices << 0, 1, 2, 3, 0, 2, 3, 4;
    const SimplicialComplex K(simplices);
    const Vector sums = angle_sums(K, points);
    EXPECT_TRUE(sums.allFinite());
    EXPECT_EQ(sums[0], 0); // of the edge 0 1
}

TEST(UpperHalvesOf, numbers_are_at_most_a_millionth_above) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (int i = -300; i <= 300; ++i) {
        const double value = 1.23456789 * std::pow(10, i);
        const UpperHalves halves({value, 0}, {infinity, value});
        for (const double above : {halves.first()[0], halves.second()[1]}) {
            EXPECT_GE(above, value);
            EXPECT_LE(above, value * (1 + 1e-6));
        }
        EXPECT_EQ(halves.first()[1], 0);
        EXPECT_EQ(halves.second()[0], infinity);
    }
}

TEST(BoundsOf, numbers_are_at_most_a_hundredth_above) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double scale : {1e-300, 1e-200, 1.0, 1e200, 1e300}) {
        Vector values(1001);
        for (int i = 0; i <= 1000; ++i)
            values[i] = scale * std::pow(10, -0.07 * i);
        values = values.cwiseMax(1e-307);
        const Vector bounds = Bounds(values).vector();
        EXPECT_GE((bounds - values).minCoeff(), 0);
        EXPECT_LT((bounds.cwiseQuotient(values).array() - 1).maxCoeff(), 0.01);
        EXPECT_TRUE(Bounds(values).are_finite());
        const Vector alike = Vector::Constant(3, 0.75 * scale);
        EXPECT_LE(Bounds(alike)[2], 1.01 * alike[2]);
        EXPECT_GE(Bounds(alike)[2], alike[2]);
        values[17] = 0;
        EXPECT_EQ(Bounds(values)[17], 0);
    }
    for (const double value : {infinity, nan, -nan}) {
        EXPECT_EQ(Bounds(Vector::Constant(1, value))[0], infinity);
        EXPECT_FALSE(Bounds(Vector::Constant(3, value)).are_finite());
    }
    EXPECT_EQ(Bounds(Vector::Zero(3)).vector(), Vector::Zero(3));
}

TEST(CellVolumes, that_a_user_gives_are_their_own_terms) {
    auto dual = three_degrees(4);
    dual[1] << 1, -2, 0, 3;
    EXPECT_EQ(CellVolumes(three_degrees(4), dual).terms(1).vector(), dual[1].cwiseAbs());
    EXPECT_EQ(
        CellVolumes(three_degrees(4), three_degrees(4)).with_dual(1, dual[1]).terms(1).vector(),
        dual[1].cwiseAbs());
}

class Terms : public OverMeshes {};

TEST_P(Terms, are_no_smaller_than_what_they_add_up_to) {
    for (const auto& [name, complex, volumes] : both(mesh()))
        for (int k = 0; k <= complex.dimension(); ++k)
            EXPECT_TRUE(
                (volumes.terms(k).vector().array() * (1 + 1e-14) >= volumes.dual(k).array().abs())
                    .all())
                << name << ", k = " << k;
}

POLYDEC_OVER_MESHES(Terms);

TEST(TermsBroken, are_larger_where_something_cancels) {
    const auto& volumes = merged("obtuse_planar").input_volumes;
    EXPECT_GT((volumes.terms(1).vector() - volumes.dual(1).cwiseAbs()).maxCoeff(),
              1e-2 * volumes.terms(1).vector().maxCoeff());
}

} // namespace polydec::test::in_cell_volumes
