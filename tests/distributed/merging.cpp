// SPDX-License-Identifier: MIT
#include "distributed/merging.h"

#include "distributed/cell_numbers.h"
#include "distributed/facet_classes.h"
#include "distributed/poisson.h"
#include "tests/distributed/compare.h"
#include "tests/support/slivers.h"

namespace polydec::test::in_merged_cells {

DistributedMerging merged_on(const Ranks& ranks, const LocalComplex& local,
                             const MergeOptions& options) {
    const auto volumes = dual_volumes(local.complex, local.points, {}, FlatSimplices::passed_over);
    return merge_cospherical(ranks, local, volumes, options);
}

/// What differs from the carriers, signs and volumes of pieces of one process.
std::string difference(const LocalComplex& local, const DistributedMerging& cells,
                       const CosphericalMerging& whole) {
    if (cells.rounds != whole.rounds)
        return fmt::format("{} rounds for {}", cells.rounds, whole.rounds);
    if (cells.degenerate_interior != whole.degenerate.interior ||
        cells.degenerate_boundary != whole.degenerate.boundary ||
        cells.degenerate_branching != whole.degenerate.branching)
        return "other degenerate facets";
    const Merging& merging = whole.merging;
    for (int k = 0; k <= local.dimension(); ++k)
        for (Index s = 0; s < local.degree(k).size(); ++s) {
            const auto number = static_cast<Index>(local.degree(k).number[s]);
            const auto expected = merging.carriers(k)[number];
            const auto& carrier = cells.carriers[k][s];
            const IncidenceMatrix& pieces = merging.diamond(expected.dimension);
            const Index first = IncidenceMatrix::InnerIterator(pieces, expected.cell).col();
            const int sign =
                expected.dimension == k ? merging.diamond(k).coeff(expected.cell, number) : 0;
            if (carrier.dimension != expected.dimension || carrier.first != first ||
                carrier.sign != sign)
                return fmt::format("{}-simplex {}: dimension {}, first {}, sign {} for {}, {}, {}",
                                   k, number, carrier.dimension, carrier.first, carrier.sign,
                                   expected.dimension, first, sign);
            if (local.degree(k).complete[s] &&
                cells.of_pieces.dual(k)[s] != whole.geometry.volumes().dual(k)[number])
                return fmt::format("dual of {}-simplex {}: {} for {}", k, number,
                                   cells.of_pieces.dual(k)[s],
                                   whole.geometry.volumes().dual(k)[number]);
        }
    return "";
}

/// What differs from numbers, volumes and incidences of the merged complex of one process.
std::string difference(const DistributedCells& cells, const Merged& whole) {
    const CellVolumes volumes =
        merged_volumes(whole.merging(), whole.result.geometry.volumes()); // between shared centers
    for (int k = 0; k <= whole.n(); ++k) {
        const auto& degree = cells.degree(k);
        if (degree.count != whole.P().size(k))
            return fmt::format("{} {}-cells for {}", degree.count, k, whole.P().size(k));
        const IncidenceMatrix transposed = whole.P().boundary(k + 1);
        const auto number_of_coface = [&](Index e) {
            return static_cast<Index>(cells.degree(k + 1).cell(degree.cofaces[e]).number);
        };
        for (std::size_t i = 0; i < degree.first.size(); ++i) {
            const auto cell = static_cast<Index>(degree.number[i]);
            const auto own = static_cast<Index>(i);
            if (cells.volumes.primal(k)[own] != volumes.primal(k)[cell] ||
                cells.volumes.dual(k)[own] != volumes.dual(k)[cell])
                return fmt::format("volumes of {}-cell {}", k, cell);
            if (k == whole.n())
                continue;
            int entries = 0;
            for (Index e = degree.begins[i]; e < degree.begins[i + 1]; ++e, ++entries)
                if (transposed.coeff(cell, number_of_coface(e)) != degree.signs[e])
                    return fmt::format("a sign of {}-cell {}", k, cell);
            if (entries != transposed.row(cell).nonZeros())
                return fmt::format("cofaces of {}-cell {}", k, cell);
        }
    }
    return "";
}

void expect_same(const Ranks& ranks, const std::string& name, const Mesh& mesh,
                 const MergeOptions& options, Ownership by) {
    const Merged whole = make_merged(mesh, options);
    const LocalComplex local = distributed(ranks, mesh, by);
    const DistributedMerging cells = merged_on(ranks, local, options);
    EXPECT_EQ(difference(local, cells, whole.result), "") << name << " by " << static_cast<int>(by);
    EXPECT_EQ(difference(distributed_cells(ranks, local, cells), whole), "") << name;
}

TEST(DistributedMerging, are_those_of_one_process) {
    const auto ranks = Ranks::all();
    for (const auto& [name, mesh] : swept(ranks))
        for (const Ownership by : some_ownerships(ranks, name))
            expect_same(ranks, name, mesh, {MergeCriterion::dual_length, tolerance}, by);
}

TEST(DistributedMerging,
     are_those_of_one_process_where_defects_are_gathered_and_cells_split_up_again) {
    const auto ranks = Ranks::all();
    const std::vector<NamedMesh> hard = {{"uv_sphere", uv_sphere(64, 12)},
                                         {"thin_torus", torus(40, 6)},
                                         {"squares", perturbed(grid(6, 6), 1e-5, 3)},
                                         {"cubes", perturbed(kuhn(3, 3), 1e-5, 4)},
                                         {"tesseracts", perturbed(kuhn(4, 1), 1e-5, 5)},
                                         {"handle_and_cavity", handle_and_cavity()},
                                         {"spherical_ring", spherical_ring()},
                                         {"loose", perturbed(grid(8, 8), 2e-2, 6)}};
    for (const auto& [name, mesh] : hard)
        for (const double wide : {1e-4, 0.05, 0.2})
            expect_same(ranks, fmt::format("{} at {}", name, wide), mesh,
                        {MergeCriterion::dual_length, wide},
                        wide > 0.1 ? Ownership::random : Ownership::morton);
}

/// Solids with flat cells that become pieces of their neighbors, and some that do not.
std::vector<NamedMesh> with_flat_cells() {
    std::vector<NamedMesh> list;
    for (const double jitter : {1e-12, 1e-6, 3e-5, 1e-3})
        list.push_back({fmt::format("delaunay {}", jitter), delaunay_grid(3, jitter)});
    for (const double jitter : {0.0, 1e-12, 1e-5}) {
        list.push_back({fmt::format("five {}", jitter), perturbed(five_to_a_cube(2), jitter, 1)});
        list.push_back(
            {fmt::format("prisms {}", jitter), perturbed(hexagonal_prisms(), jitter, 1)});
    }
    list.push_back({"two", united(delaunay_grid(2, 1e-6), five_to_a_cube(2))});
    return list;
}

TEST(DistributedMerging, are_those_of_one_process_where_flat_cells_go_to_their_neighbors) {
    const auto ranks = Ranks::all();
    for (const auto& [name, mesh] : with_flat_cells())
        for (const Ownership by :
             {Ownership::file, Ownership::morton, Ownership::graph, Ownership::random})
            expect_same(ranks, name, mesh, {}, by);
}

/// Octahedra and tetrahedra whose inner vertices are moved: centers lie just beyond the boundary.
Mesh moved_inside() {
    const Mesh at_rest = fcc(2);
    Mesh mesh = perturbed(at_rest, 1e-6, 1);
    const double low = at_rest.points.minCoeff(), high = at_rest.points.maxCoeff();
    for (Index v = 0; v < mesh.points.rows(); ++v)
        if ((at_rest.points.row(v).array() == low || at_rest.points.row(v).array() == high).any())
            mesh.points.row(v) = at_rest.points.row(v);
    return mesh;
}

/// The mesh in a space with one dimension more.
Mesh with_constant(Mesh mesh, double height) {
    mesh.points.conservativeResize(Eigen::NoChange, mesh.points.cols() + 1);
    mesh.points.rightCols(1).setConstant(height);
    return mesh;
}

TEST(DistributedCells, have_the_duals_and_zeros_of_one_process) {
    const auto ranks = Ranks::all();
    const std::vector<NamedMesh> given = {
        {"without volume", five_to_a_cube(3)},
        {"moved_inside", moved_inside()},
        {"squares in a plane", with_constant(perturbed(grid(4, 4), 1e-6, 1), 0.3)},
        {"cubes in a solid", with_constant(perturbed(kuhn(3, 2), 1e-6, 1), 0)}};
    for (const auto& [name, input] : given) {
        const Discretization whole = circumcentric(input);
        const DistributedMesh mesh = discretized(ranks, input, Ownership::morton);
        for (int k = 0; k <= whole.dimension(); ++k) {
            const auto& cells = mesh.cells.degree(k);
            EXPECT_EQ(cells.count, whole.complex().size(k)) << name;
            const auto zeros = HodgeStar(mesh.cells.volumes, k).zeros();
            const auto of_whole = HodgeStar(whole.volumes(), k).zeros();
            EXPECT_EQ(ranks.sum(std::ssize(zeros)), std::ssize(of_whole)) << name << ' ' << k;
            for (Index i = 0; i < cells.own(); ++i) {
                const auto cell = static_cast<Index>(cells.number[i]);
                EXPECT_EQ(mesh.cells.volumes.dual(k)[i], whole.volumes().dual(k)[cell]) << name;
                EXPECT_EQ(std::binary_search(zeros.begin(), zeros.end(), i),
                          std::binary_search(of_whole.begin(), of_whole.end(), cell))
                    << name;
            }
        }
    }
}

TEST(DistributedCells, have_all_coordinates_of_the_input_where_one_is_constant) {
    const auto ranks = Ranks::all();
    const Mesh input = with_constant(grid(3, 3), 0.3);
    const DistributedMesh mesh = discretized(ranks, input, Ownership::random);
    EXPECT_EQ(mesh.local.points.cols(), 2);
    const Points centers = cell_centers(ranks, mesh, 2);
    ASSERT_EQ(centers.cols(), 3);
    for (const double height : centers.col(2))
        EXPECT_NEAR(height, 0.3, 1e-15);
}

TEST(DistributedMerging, without_volume_are_refused_where_they_lie_on_no_sphere) {
    const auto ranks = Ranks::all();
    // four points of a plane on no circle, between two pairs of tetrahedra
    const Mesh mesh =
        made_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 2, 0}, {0.4, 0.4, 1}, {0.4, 0.4, -1}},
                {{0, 1, 2, 4}, {0, 2, 3, 4}, {0, 1, 3, 5}, {1, 2, 3, 5}, {0, 1, 2, 3}});
    EXPECT_REFUSED(discretized(ranks, mesh, Ownership::random), "vertices 0 1 2 3", "volume",
                   "sphere");
}

TEST(DistributedMerging, warn_of_flat_cells_near_the_tolerance_like_one_process) {
    const auto ranks = Ranks::all();
    const Mesh mesh = delaunay_grid(4, 3e-4);
    const auto told = discretized(ranks, mesh, Ownership::morton).warnings;
    const auto expected = discretize(mesh).warnings();
    ASSERT_EQ(expected.size(), 1);
    EXPECT_EQ(told, expected);
}

TEST(BrokenTwin, flat_cells_that_stay_alone_are_seen) {
    const auto ranks = Ranks::all();
    const MergeOptions options = {};
    const Mesh mesh = delaunay_grid(3, 1e-6);
    const Merged whole = make_merged(mesh, options);
    const LocalComplex local = distributed(ranks, mesh, Ownership::morton);
    const auto volumes = circumcentric_volumes(local.complex, local.points);
    auto defects = measure_facets(ranks, local, volumes, options);
    const std::vector<std::uint8_t> none_is_kept(defects.defect.size(), 0);
    const auto differ = [&] {
        const auto classes =
            join_facets(ranks, local, volumes, defects, options.tolerance, none_is_kept);
        Index count = 0;
        for (Index f = 0; f < local.degree(2).size(); ++f) {
            const auto number = static_cast<Index>(local.degree(2).number[f]);
            const bool is_removed = whole.merging().carriers(2)[number].dimension == 3;
            count += (classes.removed[f] != 0) != is_removed ? 1 : 0;
        }
        return ranks.sum(count);
    };
    EXPECT_EQ(differ(), 0);
    defects.flat.clear();
    EXPECT_GT(differ(), 0);
}

/// How many random meshes are looked at: POLYDEC_TEST_SEEDS, or a few.
unsigned number_of_seeds() {
    const char* told = std::getenv("POLYDEC_TEST_SEEDS");
    constexpr unsigned few = 60;
    return told != nullptr ? static_cast<unsigned>(std::atoi(told)) : few;
}

/// Without some of its cells, so that what is left may branch, be pinched or fall apart.
Mesh with_holes(Mesh mesh, unsigned seed) {
    std::mt19937 random(seed);
    std::vector<Index> kept;
    for (Index t = 0; t < mesh.simplices.rows(); ++t)
        if (t == 0 || random() % 4 != 0)
            kept.push_back(t);
    mesh.simplices = Simplices(mesh.simplices(kept, Eigen::indexing::all));
    return mesh;
}

TEST(DistributedMerging, of_small_random_meshes_are_those_of_one_process) {
    const auto ranks = Ranks::all();
    for (unsigned seed = 1; seed <= number_of_seeds(); ++seed) {
        const int n = 1 + static_cast<int>(seed % 4);
        const double jitter = seed % 3 == 0 ? 0.1 : seed % 3 == 1 ? 1e-5 : 0;
        const Mesh whole = perturbed(kuhn(n, n < 3 ? 3 : 5 - n), jitter, seed);
        const Mesh mesh = seed % 5 < 2 ? with_holes(whole, seed) : whole;
        expect_same(ranks, fmt::format("seed {}", seed), mesh,
                    {MergeCriterion::dual_length, seed % 2 == 0 ? 1e-4 : 0.05}, Ownership::random);
    }
}

TEST(DistributedMerging, are_those_of_one_process_where_one_rank_has_everything) {
    const auto ranks = Ranks::all();
    const MergeOptions options{MergeCriterion::dual_length, tolerance};
    for (const char* name : {"kuhn3", "uv8", "grid4"}) {
        const Mesh& mesh = mesh_named(name);
        const MeshSlice slice = slice_of(ranks, mesh);
        const std::vector<int> last(static_cast<std::size_t>(slice.points.rows()),
                                    ranks.size() - 1);
        const LocalComplex local = local_complex(ranks, slice, last);
        EXPECT_EQ(local.complex.size(0) > 0, ranks.rank() == ranks.size() - 1);
        const DistributedMerging cells = merged_on(ranks, local, options);
        const Merged whole = make_merged(mesh, options);
        EXPECT_EQ(difference(local, cells, whole.result), "") << name;
        EXPECT_EQ(difference(distributed_cells(ranks, local, cells), whole), "") << name;
    }
}

TEST(BrokenTwin, a_sign_or_a_first_piece_that_is_another_is_seen) {
    const auto ranks = Ranks::all();
    const MergeOptions options{MergeCriterion::dual_length, tolerance};
    const Mesh mesh = kuhn(3, 2);
    const Merged whole = make_merged(mesh, options);
    const LocalComplex local = distributed(ranks, mesh, Ownership::morton);
    const DistributedMerging cells = merged_on(ranks, local, options);
    DistributedMerging turned = cells, renamed = cells, unsigned_labels = cells;
    bool has_minus = false;
    for (auto& carriers : unsigned_labels.carriers)
        for (auto& carrier : carriers) {
            has_minus = has_minus || carrier.sign < 0;
            carrier.sign = std::abs(carrier.sign);
        }
    EXPECT_TRUE(ranks.any(has_minus));
    EXPECT_EQ(difference(local, unsigned_labels, whole.result) != "", has_minus);
    if (local.degree(3).size() > 0) {
        turned.carriers[3][0].sign *= -1;
        renamed.carriers[3][0].first += 1;
        EXPECT_NE(difference(local, turned, whole.result), "");
        EXPECT_NE(difference(local, renamed, whole.result), "");
    }
}

} // namespace polydec::test::in_merged_cells
