// SPDX-License-Identifier: MIT
#pragma once

#include "tests/support/test.h"

namespace polydec::test {

/// A mesh by its name, and what is done to the edges of its surface.
using RealSurface = std::tuple<std::string, Delaunay>;

/// Surfaces that are made with negative duals, closed, with boundary, branching; and where there
/// are test data an animal, two resolutions of a scan, of which the coarse one branches, and
/// machine parts of genus 2 to 23, one with boundary, one of slivers: merged, and those that do not
/// branch after flips or, with boundary, after flips and splits.
std::vector<RealSurface> real_surfaces();

/// Fixture of laws for each of these.
class OnRealSurfaces : public testing::TestWithParam<RealSurface> {
protected:
    /// Made once for all laws that follow each other on it.
    const Discretization& mesh() const;
    const CellComplex& P() const { return mesh().complex(); }

    /// Random values, the same for the same seed.
    Cochain random(Side side, int degree, unsigned seed) const;
};

std::string name_of_real_surface(const testing::TestParamInfo<RealSurface>& instance);

/// Instantiates a suite for every surface.
#define POLYDEC_ON_REAL_SURFACES(suite)                                                            \
    INSTANTIATE_TEST_SUITE_P(Real, suite, testing::ValuesIn(real_surfaces()), name_of_real_surface)

/// The largest of |defects| over what is summed there, in size: a law holds to rounding where this
/// is some eps. Infinite where a defect is no number, or has nothing to come from.
double worst_share(const Vector& defects, const Vector& sizes);

/// What the operators sum, in size: the same sums with every number and coefficient in size.
class Sizes {
public:
    explicit Sizes(const Discretization& mesh) : mesh_(mesh) {}

    /// Of d_k.
    Vector d(int k, const Vector& values) const;

    /// Of the product of a k-form and an l-form.
    Vector wedge(int k, const Vector& a, int l, const Vector& b, WedgeWeights weights) const;

    /// From the cells to the simplices of the input, and back.
    Vector to_simplices(int k, const Vector& values) const;
    Vector to_cells(int k, const Vector& values) const;

private:
    const Discretization& mesh_;
};

} // namespace polydec::test
