// SPDX-License-Identifier: MIT
#include "dec/metric/cell_volumes.h"

#include "tests/support/over_meshes.h"
#include "tests/support/refusal.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

namespace polydec::test {
namespace {

std::vector<Vector> three_degrees(Index size) {
    return std::vector<Vector>(3, Vector::Ones(size));
}

std::string refusal_of_primal(double value) {
    auto primal = three_degrees(4);
    primal[1][3] = value;
    return refusal([&] { CellVolumes(primal, three_degrees(4)); });
}

TEST(CellVolumesErrors, name_degree_and_cell_of_what_is_no_volume) {
    EXPECT_EQ(refusal_of_primal(0),
              "the 1-cell 3 has volume 0: expected a finite number above 0; remove the cell");
    EXPECT_EQ(refusal_of_primal(-1.5),
              "the 1-cell 3 has volume -1.5: expected a finite number above 0; remove the cell");
    EXPECT_EQ(refusal_of_primal(std::numeric_limits<double>::infinity()),
              "the 1-cell 3 has volume inf: expected a finite number above 0; remove the cell");
    auto dual = three_degrees(4);
    dual[2][1] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(refusal([&] { CellVolumes(three_degrees(4), dual); }),
              "the 2-cell 1 has dual volume nan, a sum of terms of size nan, to within nan: "
              "expected finite numbers");
}

TEST(CellVolumesErrors, name_sizes_that_differ) {
    auto dual = three_degrees(4);
    EXPECT_EQ(refusal([&] {
                  CellVolumes(three_degrees(4), dual, {dual[0], dual[1]});
              }),
              "volumes are given in 3 degrees, dual volumes in 3, their terms in 2 and rounding "
              "errors in 2: expected the same number");
    dual[1] = Vector::Ones(5);
    EXPECT_EQ(refusal([&] { CellVolumes(three_degrees(4), dual); }),
              "4 volumes, 5 dual volumes, 5 terms and 5 rounding errors are given for the 1-cells: "
              "expected one of each for every cell");
}

TEST(CellVolumesErrors, name_the_degrees_that_there_are) {
    const CellVolumes volumes(three_degrees(4), three_degrees(4));
    EXPECT_EQ(volumes.dimension(), 2);
    for (const int k : {-1, 3}) {
        const auto expected = "volumes of " + std::to_string(k) +
                              "-cells are asked for: there are cells of degrees 0 to 2";
        EXPECT_EQ(refusal([&] { volumes.primal(k); }), expected);
        EXPECT_EQ(refusal([&] { volumes.dual(k); }), expected);
        EXPECT_EQ(refusal([&] { volumes.terms(k); }), expected);
        EXPECT_EQ(refusal([&] { volumes.with_dual(k, Vector::Ones(4)); }), expected);
    }
    EXPECT_EQ(CellVolumes().dimension(), -1);
    EXPECT_EQ(refusal([] { CellVolumes().dual(0); }),
              "volumes of 0-cells are asked for: there are no cells");
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

} // namespace
} // namespace polydec::test
