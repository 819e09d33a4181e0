// SPDX-License-Identifier: MIT
//
// Cells that there are not, values for another number of cells, volumes of another mesh, matrices
// for vectors and references to temporaries: each is refused, or does not compile.
#include "dec/metric/subsets.h"
#include "tests/io/doors.h"
#include "tests/io/support.h"

namespace polydec::test {
namespace {

using Calls = std::vector<std::pair<const char*, std::function<void()>>>;

TEST(doors, a_cell_that_there_is_not_is_refused) {
    for (const Sample& s : samples()) {
        const int n = s.n();
        for (int k = 0; k <= n; ++k)
            for (const Index cell : {-1, s.P().size(k), s.P().size(k) + 1, Index(1) << 30}) {
                EXPECT_EQ(outcome([&] { s.mesh.merging().vertices(k, cell); }), "refused");
                EXPECT_EQ(outcome([&] { cell_vertices(s.mesh, k, cell); }), "refused");
            }
        for (const Index cell : {-1, s.K().size(n), Index(1) << 30}) {
            EXPECT_EQ(outcome([&] { s.K().input_row(cell); }), "refused");
            EXPECT_EQ(outcome([&] { s.K().orientation(cell); }), "refused");
            EXPECT_EQ(outcome([&] {
                          whitney_form(s.K(), s.mesh.points(),
                                       {Side::primal, 0, Vector::Ones(s.K().size(0))}, cell,
                                       Vector::Constant(n + 1, 1.0 / (n + 1)));
                      }),
                      "refused");
        }
        for (const Index cell : {-1, s.P().size(2), Index(1) << 30})
            EXPECT_EQ(outcome([&] { corners(s.mesh.merging(), cell); }), "refused");
        EXPECT_EQ(outcome([&] { geodesic_distance(s.mesh, std::vector<Index>{-1}); }), "refused");
    }
}

TEST(doors, polyhedra_that_there_are_not_are_refused) {
    using Faces = std::vector<std::vector<Index>>;
    const auto written = [](const Faces& faces) {
        VtuGrid grid;
        grid.points = Points::Identity(4, 3);
        add_polyhedron(grid, faces);
        const test::TemporaryFolder folder;
        return outcome([&] { write_vtu(folder.path("a.vtu"), grid); });
    };
    EXPECT_EQ(written({{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}), "accepted");
    EXPECT_EQ(written({{0, 2, 1}, {0, 1, 4}, {1, 2, 4}, {0, 4, 2}}), "refused");
    EXPECT_EQ(written({{0, 2, 1}, {0, 1, -1}, {1, 2, -1}, {0, -1, 2}}), "refused");
    EXPECT_EQ(written({{0, 2, 1}, {0, 1}, {1, 2, 3}, {0, 3, 2}}), "refused");
    EXPECT_EQ(written({}), "refused");
}

TEST(doors, sizes_and_vertices_that_there_are_not_are_refused) {
    EXPECT_EQ(outcome([] { Operator::zero(3, 2) * Vector::Ones(2); }), "accepted");
    EXPECT_EQ(outcome([] { Operator::zero(-1, 2); }), "refused");
    EXPECT_EQ(outcome([] { Operator::zero(2, -1); }), "refused");
    for (const Sample& s : samples())
        for (const Index no : {-1, s.pieces().size(0), Index(1) << 30}) {
            EXPECT_EQ(outcome([&] { s.pieces().vertex_numbers({no}); }), "refused");
            EXPECT_EQ(outcome([&] { s.pieces().vertex_numbers(0, no); }), "refused");
        }
}

/// One value fewer or more is asked of every function elsewhere; operators look at the number in
/// one place.
TEST(doors, values_of_another_number_than_the_cells_are_refused) {
    for (const Sample& s : samples()) {
        const int n = s.n();
        const auto relative = relative_to_boundary(s.P());
        for (int k = 0; k <= n; ++k)
            for (const Index size : {0, s.P().size(k) - 1, s.P().size(k) + 1, 5000}) {
                const Vector x = Vector::Ones(size);
                const Calls calls = {{"check",
                                      [&] {
                                          check(s.P(), Cochain{Side::primal, k, x});
                                      }},
                                     {"check, dual",
                                      [&] {
                                          check(s.P(), Cochain{Side::dual, n - k, x});
                                      }},
                                     {"operator", [&] { Operator::derivative(s.P(), k) * x; }},
                                     {"restrict", [&] { relative.restrict(k, x); }}};
                for (const auto& [what, call] : calls)
                    EXPECT_EQ(outcome(call), "refused")
                        << what << ", degree " << k << ", " << size << " values on " << s.name;
                if (size != relative.complex.size(k)) {
                    EXPECT_EQ(outcome([&] { relative.extend(k, x); }), "refused");
                }
            }
        EXPECT_EQ(outcome([&] { subsets(n, -1); }), "refused");
        EXPECT_EQ(outcome([&] { subsets(-1, 0); }), "refused");
    }
}

/// Whatever takes cells takes none with the volumes of others, as there are no such cells.
TEST(doors, volumes_and_points_of_another_mesh_are_refused) {
    for (const Sample& s : samples()) {
        const Sample other("another", kuhn(s.n(), s.n() == 4 ? 2 : 5));
        const Points few = s.mesh.points().topRows(2);
        Calls calls = {
            {"cells", [&] { Cells(s.P(), other.V()); }},
            {"merged cells", [&] { MergedCells(s.mesh.merging(), s.mesh.geometry(), other.V()); }},
            {"geometry", [&] { Geometry(s.K(), s.mesh.geometry().metric(), other.W()); }},
            {"volumes", [&] { relative_volumes(relative_to_boundary(s.P()), other.V()); }},
            {"edge_lengths", [&] { edge_lengths(s.K(), few); }}};
        for (int k = 0; k <= s.n(); ++k)
            calls.emplace_back("dual_to_merged",
                               [&, k] { dual_to_merged(s.mesh.merging(), other.W(), k); });
        for (const auto& [what, call] : calls)
            EXPECT_EQ(outcome(call), "refused") << what << " on " << s.name;
    }
}

// A matrix where a vector is wanted: of several columns, of one type or another.
TEST(doors, a_matrix_is_no_vector) {
    const Sample& s = sample("a sphere");
    const Index size = s.P().size(0);
    const DenseMatrix three = DenseMatrix::Ones(size, 3);
    EXPECT_EQ(outcome([&] { check(s.P(), Cochain{Side::primal, 0, three}); }), "refused");
    EXPECT_EQ(outcome([&] { check(s.P(), Chain{Side::primal, 0, three}); }), "refused");
    Cochain w{Side::primal, 0, Vector::Ones(size)};
    EXPECT_EQ(outcome([&] { w.values = three; }), "refused");
    EXPECT_EQ(outcome([&] { laplacian(s.cells(), 0) * three; }), "refused");
    EXPECT_EQ(outcome([&] { with_conductivity(s.mesh, Side::primal, three); }), "refused");
    EXPECT_EQ(
        outcome([&] { de_rham(s.mesh, 0, [&](const Vector&) { return DenseMatrix(1, 2); }); }),
        "refused");
    EXPECT_EQ(outcome([&] { GeodesicDistance(GluedSurface(s.K()), three); }), "refused");
    EXPECT_EQ(outcome([&] { CertifiedEigensolver(SparseMatrix(size, size), three); }), "refused");
}

TEST(doors, several_forms_are_restricted_as_one_by_one) {
    const Sample& s = sample("a merged square");
    const auto relative = relative_to_boundary(s.P());
    for (int k = 0; k <= s.n(); ++k) {
        const DenseMatrix forms = DenseMatrix::Random(s.P().size(k), 3);
        const DenseMatrix kept = relative.restrict(k, forms), back = relative.extend(k, kept);
        for (int j = 0; j < 3; ++j) {
            EXPECT_EQ(kept.col(j), relative.restrict(k, Vector(forms.col(j))));
            EXPECT_EQ(back.col(j), relative.extend(k, Vector(kept.col(j))));
        }
    }
}

// what refers to a temporary cannot be had; what is copied out of one can
template <class Owner>
concept KeepsNoReference = requires(Owner&& owner) {
    requires !std::is_reference_v<decltype(std::forward<Owner>(owner).complex())>;
    requires !std::is_reference_v<decltype(std::forward<Owner>(owner).input())>;
};
static_assert(KeepsNoReference<Discretization> && !KeepsNoReference<Discretization&>);
static_assert(!std::is_reference_v<decltype(std::declval<Merging>().merged())>);
static_assert(!std::is_reference_v<decltype(std::declval<Merging>().diamond(0))>);
static_assert(!std::is_reference_v<decltype(std::declval<SimplicialComplex>().simplices(0))>);
static_assert(!std::is_reference_v<decltype(std::declval<CellComplex>().coboundary(0))>);
static_assert(!std::is_reference_v<decltype(std::declval<CellComplex>().coface_counts(0))>);
static_assert(!std::is_reference_v<decltype(std::declval<PoissonSolver>().space())>);

TEST(doors, a_temporary_gives_what_it_holds) {
    const auto& complex = discretize(kuhn(2, 2)).complex();
    EXPECT_EQ(complex.size(2), 4);
    const auto& coboundary = discretize(kuhn(2, 2)).complex().coboundary(1);
    EXPECT_EQ(coboundary.rows(), 4);
    for (const Index count : discretize(kuhn(2, 2)).complex().coface_counts(1))
        EXPECT_LE(count, 2);
}

} // namespace
} // namespace polydec::test
