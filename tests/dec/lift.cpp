// SPDX-License-Identifier: MIT
#include "tests/dec/discretized.h"

namespace polydec::test::in_lift {

class Lifts : public OverMeshes {
protected:
    const std::vector<SparseMatrix>& S() const { return discretized(GetParam()).merged().lift(); }
};

SparseMatrix diamond(const Merged& mesh, int k) {
    return mesh.merging().diamond(k).cast<double>();
}

/// The way back of Schier's paper: each piece has its fraction of the cell's value, removed
/// simplices 0.
SparseMatrix by_fraction(const Merged& mesh, int k) {
    return primal_to_input(mesh.merging(), mesh.input_volumes, k);
}

double commutation_defect(const Merged& mesh, const SparseMatrix& upper, const SparseMatrix& lower,
                          int k) {
    return largest(derivative(mesh.K(), k) * lower - upper * derivative(mesh.P(), k));
}

TEST_P(Lifts, are_right_inverses_of_the_map_to_merged_cells) {
    for (int k = 0; k <= mesh().n(); ++k)
        EXPECT_CLOSE(diamond(mesh(), k) * S()[k], identity(mesh().P().size(k)), 1e-13)
            << "k = " << k;
}

TEST_P(Lifts, are_cochain_maps) {
    for (int k = 0; k < mesh().n(); ++k)
        EXPECT_LE(commutation_defect(mesh(), S()[k + 1], S()[k], k), 1e-12) << "k = " << k;
}

TEST_P(Lifts, keep_functions_and_share_top_forms_by_volume) {
    EXPECT_EQ(relative_difference(S()[0], identity(mesh().K().size(0))), 0);
    EXPECT_CLOSE(S()[mesh().n()], by_fraction(mesh(), mesh().n()), 1e-14);
}

TEST_P(Lifts, depend_on_the_closure_of_the_carrier_alone) {
    const auto& carriers = [&](int k) -> const auto& {
        return mesh().merging().carriers(k);
    };
    // closure[m][F]: cells, as (degree, number), whose pieces are faces of pieces of F
    using Cell = std::pair<int, Index>;
    std::vector<std::vector<std::set<Cell>>> closure;
    for (int m = 0; m <= mesh().n(); ++m) {
        closure.emplace_back(mesh().P().size(m));
        for (Index piece = 0; piece < mesh().K().size(m); ++piece) {
            if (carriers(m)[piece].dimension != m)
                continue;
            const auto collect = [&](const auto& self, int k, Index s) -> void {
                const auto& own = carriers(k)[s];
                closure[m][carriers(m)[piece].cell].insert({own.dimension, own.cell});
                for (int omitted = 0; k > 0 && omitted <= k; ++omitted)
                    self(self, k - 1, mesh().K().face(k, s, omitted));
            };
            collect(collect, m, piece);
        }
    }
    for (int k = 0; k <= mesh().n(); ++k)
        for (Index s = 0; s < mesh().K().size(k); ++s) {
            const auto& carrier = carriers(k)[s];
            for (SparseMatrix::InnerIterator entry(S()[k], s); entry; ++entry)
                EXPECT_TRUE(closure[carrier.dimension][carrier.cell].contains(
                    {k, static_cast<Index>(entry.col())}))
                    << "k = " << k << ", simplex " << s;
        }
}

/// Largest error of S_k where it should return the integrals of a random constant k-form.
double constant_error(const Merged& mesh, const SparseMatrix& lift, int k, unsigned seed) {
    const auto N = static_cast<Index>(mesh.points.cols());
    const Vector w =
        integrate(mesh.K(), mesh.points, k, constant_form(random_vector(coefficients(N, k), seed)));
    return relative_difference(lift * (diamond(mesh, k) * w), w);
}

TEST_P(Lifts, return_constant_forms_exactly_on_flat_cells) {
    if (!is_flat(mesh_named(GetParam())))
        return;
    for (int k = 0; k <= mesh().n(); ++k)
        for (const unsigned seed : {1U, 2U, 3U})
            EXPECT_LE(constant_error(mesh(), S()[k], k, seed), 1e-12) << "k = " << k;
}

POLYDEC_OVER_MESHES(Lifts);

const std::vector<std::string> merging_meshes = {"grid4", "hex4",        "torus8x6",
                                                 "kuhn3", "split_cubes", "kuhn4"};

TEST(LiftsBroken, the_transposed_map_is_no_right_inverse_and_no_cochain_map) {
    for (const auto& name : merging_meshes) {
        const auto& mesh = merged(name);
        for (int k = 0; k < mesh.n(); ++k)
            EXPECT_GE(commutation_defect(mesh, diamond(mesh, k + 1).transpose(),
                                         diamond(mesh, k).transpose(), k),
                      0.5)
                << name << ", k = " << k;
        const int n = mesh.n();
        EXPECT_GE(relative_difference(diamond(mesh, n) * SparseMatrix(diamond(mesh, n).transpose()),
                                      identity(mesh.P().size(n))),
                  1.0)
            << name;
    }
}

TEST(LiftsBroken, sharing_by_volume_alone_is_a_right_inverse_but_no_cochain_map) {
    for (const auto& name : merging_meshes) {
        const auto& mesh = merged(name);
        for (int k = 0; k <= mesh.n(); ++k)
            EXPECT_CLOSE(diamond(mesh, k) * by_fraction(mesh, k), identity(mesh.P().size(k)),
                         1e-13);
        for (int k = 0; k < mesh.n(); ++k)
            EXPECT_GE(commutation_defect(mesh, by_fraction(mesh, k + 1), by_fraction(mesh, k), k),
                      0.1)
                << name << ", k = " << k;
        EXPECT_GT(constant_error(mesh, by_fraction(mesh, 1), 1, 1), 0.1) << name;
    }
}

/// The 2-simplices inside merged 3-cells, filled by Stokes and least norm instead of least energy.
double constant_error_of_least_norm(const Merged& mesh) {
    const Vector w = integrate(mesh.K(), mesh.points, 2, constant_form(random_vector(3, 1)));
    std::vector<Index> inside;
    Vector known = w;
    for (Index s = 0; s < mesh.K().size(2); ++s)
        if (mesh.merging().carriers(2)[s].dimension == 3) {
            inside.push_back(s);
            known[s] = 0;
        }
    const DenseMatrix d(derivative(mesh.K(), 2));
    const DenseMatrix D = d(Eigen::indexing::all, inside);
    const Vector x = least_squares(D, -d * known).shortest;
    return relative_difference(x, Vector(w(inside)));
}

TEST(LiftsBroken, least_norm_misses_constant_forms_on_cubes_split_at_random) {
    EXPECT_GT(constant_error_of_least_norm(merged("split_cubes")), 0.01);
}

/// A regular polygon, as triangles from one corner.
Mesh polygon(Index corners) {
    Mesh mesh;
    mesh.points.resize(corners, 2);
    mesh.simplices.resize(corners - 2, 3);
    for (Index i = 0; i < corners; ++i)
        mesh.points.row(i) << std::cos(2 * std::numbers::pi * i / corners),
            std::sin(2 * std::numbers::pi * i / corners);
    for (Index t = 0; t < corners - 2; ++t)
        mesh.simplices.row(t) << 0, t + 1, t + 2;
    return mesh;
}

TEST(LiftsOfGiants, are_held_against_memory_before_they_are_made) {
    const auto mesh = discretize(polygon(600));
    ASSERT_EQ(mesh.complex().size(2), 1);
    const auto with_at_most = [](std::uint64_t bytes, const auto& call) {
        set_memory_limit(bytes);
        const auto told = message_of<IoError>(call);
        set_memory_limit(machine_memory());
        return told;
    };
    const auto lift = [&] { mesh.merged().lift(); };
    EXPECT_SAYS(with_at_most(1000000, lift), "598 simplices", "2-cell", "11.5 MB", "1 MB");
    const auto star = [&] { mesh.with_stars(StarKind::galerkin).chosen_stars(); };
    EXPECT_SAYS(with_at_most(15000000, star), "star of 1-forms", "3.6e+05", "21.6 MB");
    EXPECT_EQ(message_of<IoError>([&] { mesh.merged().lift(); }), "accepted");
}

TEST(LiftsOfGiants, are_refused_where_they_would_take_minutes) {
    const auto mesh = discretize(polygon(2003));
    ASSERT_EQ(mesh.complex().size(2), 1);
    EXPECT_REFUSED(mesh.merged().lift(), "2-cell 0", "2001 simplices", "2000",
                   "StarKind::circumcentric");
    mesh.with_stars(StarKind::circumcentric).chosen_stars(); // which lifts nothing
}

} // namespace polydec::test::in_lift
