// SPDX-License-Identifier: MIT
#include "tests/support/slivers.h"

#include "dec/merging/facet_defects.h"
#include "dec/merging/flat_simplices.h"
#include "dec/merging/lift.h"
#include "tests/dec/discretized.h"

namespace polydec::test::in_slivers {

using Sizes = std::vector<Index>;

Index count_flat(const Discretization& mesh) {
    Index count = 0;
    for (Index t = 0; t < mesh.pieces().size(mesh.dimension()); ++t)
        count += mesh.geometry().is_flat(t);
    return count;
}

/// The largest distance of duals of cubes of edge h from those of exact ones, 1, 1/2, 1/4 or 1/8.
double off_cubes(const Discretization& mesh, double h) {
    double worst = 0;
    for (int k = 0; k <= 3; ++k)
        for (const double dual : mesh.volumes().dual(k)) {
            double least = 1;
            for (const double exact : {1.0, 0.5, 0.25, 0.125})
                least = std::min(least, std::abs(dual / std::pow(h, 3 - k) - exact));
            worst = std::max(worst, least);
        }
    return worst;
}

/// The integrals over the k-pieces of a constant form with one coefficient.
Vector constant(const Discretization& mesh, int k, int which) {
    return integrate(mesh.input(), mesh.points(), k, constant_form(Vector::Unit(3, which)));
}

/// How far the lifts are from giving constant forms back.
double off_constants(const Discretization& mesh, const std::vector<SparseMatrix>& lift) {
    double worst = 0;
    for (const int k : {1, 2})
        for (int axis = 0; axis < 3; ++axis) {
            const Vector exact = constant(mesh, k, axis);
            const Vector cells = mesh.merging().diamond(k).cast<double>() * exact;
            worst = std::max(worst, (lift[k] * cells - exact).cwiseAbs().maxCoeff());
        }
    return worst;
}

constexpr std::array jitters{0.0, 1e-12, 1e-8, 1e-6, 1e-5, 3e-5};

TEST(Slivers, of_jittered_points_become_pieces_of_cubes) {
    for (const int m : {3, 5})
        for (const double jitter : jitters) {
            const auto mesh = discretize(delaunay_grid(m, jitter));
            EXPECT_EQ(sizes(mesh.complex()), sizes_of_boxes(3, m)) << jitter;
            EXPECT_LE(off_cubes(mesh, 1.0 / m), 5 * jitter + 1e-14) << jitter;
            if (jitter > 1e-7) {
                EXPECT_GT(count_flat(mesh), 10) << jitter;
            }
        }
}

TEST(Slivers, without_any_volume_become_pieces_of_cubes) {
    for (const int m : {2, 3, 4}) {
        const auto mesh = discretize(five_to_a_cube(m));
        EXPECT_EQ(sizes(mesh.complex()), sizes_of_boxes(3, m));
        EXPECT_EQ(count_flat(mesh), mesh.pieces().size(3) - 5 * m * m * m);
        EXPECT_GT(count_flat(mesh), 0);
        EXPECT_LE(off_cubes(mesh, 1), 1e-14);
    }
}

TEST(Slivers, upon_each_other_become_pieces_of_prisms) {
    for (const double jitter : {0.0, 1e-12, 1e-8, 1e-5}) {
        const auto mesh = discretize(perturbed(hexagonal_prisms(), jitter, 1));
        EXPECT_EQ(sizes(mesh.complex()), (Sizes{18, 30, 15, 2})) << jitter;
        EXPECT_EQ(count_flat(mesh), 3);
        EXPECT_LE(off_constants(mesh, mesh.merged().lift()), 20 * jitter + 1e-12) << jitter;
        const Vector sums = mesh.volumes().primal(2).cwiseProduct(mesh.volumes().dual(2));
        EXPECT_NEAR(sums.sum() / (3 * mesh.volumes().primal(3).sum()), 1, 5 * jitter + 1e-13);
    }
}

TEST(Slivers, leave_the_laws_of_duals) {
    for (const double jitter : jitters) {
        const auto mesh = discretize(delaunay_grid(4, jitter));
        for (int k = 0; k <= 3; ++k) {
            const double sum = mesh.volumes().primal(k).dot(mesh.volumes().dual(k));
            const double binomial = k == 0 || k == 3 ? 1 : 3;
            EXPECT_NEAR(sum, binomial, k == 2 ? 1e-13 : 5 * jitter + 1e-13) << k << ' ' << jitter;
        }
    }
}

TEST(Slivers, leave_no_dual_at_all_to_what_is_removed) {
    for (const double jitter : {1e-8, 1e-5}) {
        const auto mesh = discretize(delaunay_grid(3, jitter));
        for (Index f = 0; f < mesh.pieces().size(2); ++f)
            if (mesh.merging().carriers(2)[f].dimension == 3) {
                EXPECT_EQ(mesh.geometry().volumes().dual(2)[f], 0);
            }
    }
}

TEST(SliversBroken, by_their_own_circumcenters_would_stay) {
    const auto mesh = discretize(delaunay_grid(3, 1e-5));
    const auto own = circumcentric_volumes(mesh.input(), mesh.geometry().metric());
    Index far = 0;
    for (Index t = 0; t < mesh.pieces().size(3); ++t)
        for (int i = 0; i <= 3 && mesh.geometry().is_flat(t); ++i)
            far += std::abs(own.dual(2)[mesh.pieces().face(3, t, i)]) > 1e-2;
    EXPECT_GT(far, 10);
}

TEST(SliversBroken, by_jitter_above_the_tolerance_would_not_be_cubes) {
    EXPECT_NE(sizes(discretize(delaunay_grid(3, 1e-3)).complex()), sizes_of_boxes(3, 3));
    EXPECT_EQ(sizes(discretize(delaunay_grid(3, 3e-4), {.tolerance = 1e-3}).complex()),
              sizes_of_boxes(3, 3));
}

TEST(Slivers, do_not_depend_on_numbers) {
    const auto sorted = [](Vector values) {
        std::sort(values.begin(), values.end());
        return values;
    };
    for (const Mesh& mesh : {delaunay_grid(3, 1e-8), delaunay_grid(3, 1e-5), five_to_a_cube(3)}) {
        const auto one = discretize(mesh);
        for (const std::uint64_t seed : {1, 2, 3}) {
            const auto other = discretize(shuffled(mesh, seed).mesh);
            ASSERT_EQ(sizes(other.complex()), sizes(one.complex()));
            EXPECT_EQ(count_flat(other), count_flat(one));
            for (int k = 0; k <= 3; ++k)
                EXPECT_WITHIN(sorted(other.volumes().dual(k)), sorted(one.volumes().dual(k)),
                              1e-13);
        }
    }
}

TEST(Slivers, leave_the_lift_a_cochain_map_exact_for_constants) {
    for (const double jitter : {0.0, 1e-12, 1e-8, 1e-6, 1e-5}) {
        for (const Mesh& given :
             {delaunay_grid(3, jitter), perturbed(five_to_a_cube(3), jitter, 1)}) {
            const auto mesh = discretize(given);
            ASSERT_EQ(sizes(mesh.complex()), sizes_of_boxes(3, 3));
            const auto& S = mesh.merged().lift();
            for (int k = 0; k < 3; ++k) {
                const SparseMatrix d = mesh.pieces().coboundary(k).cast<double>() * S[k];
                const SparseMatrix d_P = S[k + 1] * mesh.complex().coboundary(k).cast<double>();
                EXPECT_LE(largest(d - d_P), 1e-13) << k << ' ' << jitter;
            }
            EXPECT_LE(off_constants(mesh, S), 5 * jitter + 1e-12) << jitter;
        }
    }
}

/// Those of any height have accurate masses.
TEST(SliversBroken, taken_for_ordinary_pieces_would_spoil_the_lift) {
    for (const double jitter : {0.0, 1e-15, 1e-14}) {
        const auto mesh = discretize(perturbed(five_to_a_cube(3), jitter, 1));
        const auto lift = commuting_lift(mesh.merging(), mesh.geometry().with_flat({}));
        EXPECT_GT(off_constants(mesh, lift), 0.1) << jitter;
    }
}

TEST(Slivers, leave_fields_and_stars_exact_for_constants) {
    for (const double jitter : {0.0, 1e-8, 1e-5}) {
        const auto mesh = discretize(perturbed(five_to_a_cube(3), jitter, 1));
        const double tolerance = 50 * jitter + 1e-11;
        for (int axis = 0; axis < 3; ++axis) {
            const Cochain form{Side::primal, 1,
                               mesh.merging().diamond(1).cast<double>() * constant(mesh, 1, axis)};
            for (const DenseMatrix& field :
                 {sharp_pp(mesh, form), sharp_pd(mesh, form), whitney_at_centroids(mesh, form)}) {
                const Eigen::RowVector3d exact = Eigen::RowVector3d::Unit(axis);
                EXPECT_WITHIN(field.rowwise(), exact, tolerance) << jitter;
            }
            const auto galerkin = mesh.with_stars(StarKind::galerkin).chosen_stars();
            EXPECT_NEAR(form.values.dot(galerkin.stars[1] * form.values), 27, 27 * tolerance);
            const SparseMatrix twice =
                material_star(mesh, 1, Vector::Constant(mesh.input().size(3), 2));
            EXPECT_NEAR(form.values.dot(twice * form.values), 54, 54 * tolerance);
        }
    }
}

TEST(Slivers, leave_no_crack_between_the_forms_of_galerkin) {
    for (const double jitter : jitters) {
        Mesh input = delaunay_grid(4, jitter);
        input.points.conservativeResize(Eigen::NoChange, jitter > 1e-7 ? 4 : 3);
        input.points.rightCols(input.points.cols() - 3).setZero();
        const auto mesh = discretize(input);
        const SparseMatrix d = derivative(mesh.complex(), 0);
        const auto star = mesh.with_stars(StarKind::galerkin).stars()[1];
        const auto inside = relative_to_boundary(mesh.complex());
        for (int axis = 0; axis < 3; ++axis) {
            const Vector dx = d * mesh.points().col(axis);
            EXPECT_NEAR(dx.dot(star * dx), 1, 1e-12) << jitter;
            const Vector flows = d.transpose() * (star * dx);
            EXPECT_LE(inside.restrict(0, flows).norm(), 1e-12) << jitter;
        }
    }
}

TEST(Slivers, are_refused_where_they_lie_on_no_sphere) {
    // four points of a plane on no circle, between two pairs of tetrahedra
    const Mesh mesh =
        made_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 2, 0}, {0.4, 0.4, 1}, {0.4, 0.4, -1}},
                {{0, 1, 2, 4}, {0, 2, 3, 4}, {0, 1, 3, 5}, {1, 2, 3, 5}, {0, 1, 2, 3}});
    EXPECT_REFUSED(discretize(mesh), "cell 4", "vertices 0 1 2 3", "volume", "plane", "peeled");
    EXPECT_REFUSED(discretize(five_to_a_cube(2), {.criterion = MergeCriterion::none}), "cell",
                   "volume");
}

TEST(FlatSimplices, are_none_in_thin_layers) {
    for (const double thickness : {1e-2, 1e-4, 1e-6}) {
        Mesh mesh = five_to_a_cube(3, true);
        mesh.points.col(2) *= thickness;
        const auto thin = discretize(mesh);
        EXPECT_EQ(sizes(thin.complex()), sizes_of_boxes(3, 3)) << thickness;
        EXPECT_TRUE(flat_simplices(thin.geometry()).empty());
    }
}

TEST(FlatSimplices, near_the_tolerance_are_told) {
    const auto mesh = discretize(delaunay_grid(4, 3e-4));
    bool told = false;
    for (const auto& warning : mesh.warnings())
        told = told || warning.find("try the tolerance 1e-03") != std::string::npos;
    EXPECT_TRUE(told);
}

} // namespace polydec::test::in_slivers
