// SPDX-License-Identifier: MIT
#include "tests/real/surfaces.h"

#include "dec/metric/dual_parts.h"
#include "dec/metric/simplex_geometry.h"
#include "dec/metric/subsets.h"
#include "tests/io/support.h"
#include "tests/real/samples.h"

namespace polydec::test {

namespace {

/// A corner that both lists have, if they have no other in common.
std::optional<int> meeting(const std::vector<int>& a, const std::vector<int>& b) {
    std::vector<int> common;
    std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(common));
    return common.size() == 1 ? std::optional(common.front()) : std::nullopt;
}

SparseMatrix in_size(const SparseMatrix& A) {
    return A.cwiseAbs();
}

} // namespace

std::vector<RealSurface> real_surfaces() {
    using enum Delaunay;
    std::vector<RealSurface> all{{"made/torus", off},
                                 {"made/torus", flips},
                                 {"made/genus_two", off},
                                 {"made/genus_two", flips},
                                 {"made/bowl", off},
                                 {"made/bowl", flips},
                                 {"made/bowl", flips_and_splits},
                                 {"made/flange", off}};
    if (!test::has_test_data())
        return all;
    for (const char* name :
         {"surface/spot.obj", "cad/joint.obj", "cad/65004.stl", "cad/featuretype.STL",
          "cad/fixed_top.ply", "cad/1002_tray_bottom.STL"})
        for (const auto delaunay : {off, flips})
            all.emplace_back(name, delaunay);
    all.emplace_back("cad/featuretype.STL", flips_and_splits);
    all.emplace_back("table2/bun_zipper_res3.ply", off);
    all.emplace_back("table2/bun_zipper.ply", flips_and_splits);
    return all;
}

std::string name_of_real_surface(const testing::TestParamInfo<RealSurface>& instance) {
    const auto& [file, delaunay] = instance.param;
    return test_name(file) + (delaunay == Delaunay::off     ? "_merged"
                              : delaunay == Delaunay::flips ? "_flips"
                                                            : "_splits");
}

const Discretization& OnRealSurfaces::mesh() const {
    static RealSurface made_of;
    static std::optional<Discretization> made;
    if (!made || made_of != GetParam()) {
        made =
            circumcentric(mesh_of(std::get<0>(GetParam())), {.delaunay = std::get<1>(GetParam())});
        made_of = GetParam();
    }
    return *made;
}

Cochain OnRealSurfaces::random(Side side, int degree, unsigned seed) const {
    return {side, degree, random_vector(P().size(cell_degree(P(), side, degree)), seed)};
}

double worst_share(const Vector& defects, const Vector& sizes) {
    double worst = defects.size() == sizes.size() ? 0 : INFINITY;
    for (Index i = 0; i < defects.size() && std::isfinite(worst); ++i)
        if (defects[i] != 0)
            worst = std::isfinite(defects[i]) ? std::max(worst, std::abs(defects[i]) / sizes[i])
                                              : INFINITY;
    return worst;
}

Vector Sizes::d(int k, const Vector& values) const {
    return in_size(mesh_.complex().coboundary(k).cast<double>()) * values.cwiseAbs();
}

Vector Sizes::wedge(int k, const Vector& a, int l, const Vector& b, WedgeWeights weights) const {
    const int m = k + l;
    const auto& K = mesh_.pieces();
    const Vector x = in_size(mesh_.merged().lift()[k]) * a.cwiseAbs(),
                 y = in_size(mesh_.merged().lift()[l]) * b.cwiseAbs();
    const bool uniform = weights == WedgeWeights::uniform;
    const Points parts = uniform ? Points() : parts_of_duals(mesh_.geometry(), {}, 0, m);
    const auto share = [&](Index s, int v) {
        return uniform ? 1.0 / (m + 1)
                       : std::abs(parts(s, v)) / mesh_.geometry().volumes().primal(m)[s];
    };
    Vector sums = Vector::Zero(K.size(m));
    for (const auto& first : subsets(m + 1, k + 1))
        for (const auto& second : subsets(m + 1, l + 1))
            if (const auto v = meeting(first, second))
                for (Index s = 0; s < K.size(m); ++s)
                    sums[s] +=
                        share(s, *v) * x[face_at(K, m, s, first)] * y[face_at(K, m, s, second)];
    return in_size(mesh_.merging().diamond(m).cast<double>()) * sums;
}

Vector Sizes::to_simplices(int k, const Vector& values) const {
    const Vector pieces = in_size(mesh_.merged().lift()[k]) * values.cwiseAbs();
    return mesh_.passage().is_identity() ? pieces
                                         : in_size(mesh_.passage().matrix_back(k)) * pieces;
}

Vector Sizes::to_cells(int k, const Vector& values) const {
    const Vector pieces = mesh_.passage().is_identity()
                              ? Vector(values.cwiseAbs())
                              : Vector(in_size(mesh_.passage().matrix(k)) * values.cwiseAbs());
    return in_size(mesh_.merging().diamond(k).cast<double>()) * pieces;
}

} // namespace polydec::test
