// SPDX-License-Identifier: MIT
#include "distributed/merged_cells.h"

#include "base/errors.h"
#include "dec/metric/circumcentric_volumes.h"
#include "meshes/generate.h"
#include "meshes/rearrange.h"
#include "tests/distributed/compare.h"
#include "tests/support/merged.h"

namespace polydec::test {

namespace {

MergedCells merged_on(const Ranks& ranks, const LocalComplex& local, const MergeOptions& options) {
    const auto volumes = circumcentric_volumes(local.complex, local.points);
    return merge_cospherical(ranks, local, volumes, options);
}

/// What differs from the carriers, signs and volumes of pieces of one process.
std::string difference(const LocalComplex& local, const MergedCells& cells,
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
                cells.of_pieces.dual(k)[s] != whole.volumes.dual(k)[number])
                return fmt::format("dual of {}-simplex {}: {} for {}", k, number,
                                   cells.of_pieces.dual(k)[s], whole.volumes.dual(k)[number]);
        }
    return "";
}

void expect_same(const Ranks& ranks, const std::string& name, const Mesh& mesh,
                 const MergeOptions& options, Ownership by) {
    const Merged whole = make_merged(mesh, options);
    const LocalComplex local = distributed(ranks, mesh, by);
    EXPECT_EQ(difference(local, merged_on(ranks, local, options), whole.result), "")
        << name << " by " << static_cast<int>(by);
}

TEST(MergedCells, are_those_of_one_process) {
    const auto ranks = Ranks::all();
    for (const auto& [name, mesh] : meshes())
        for (const Ownership by : some_ownerships(ranks, name))
            expect_same(ranks, name, mesh, {MergeCriterion::dual_length, tolerance}, by);
}

TEST(MergedCells, are_those_of_one_process_where_defects_are_gathered_and_cells_split_up_again) {
    const auto ranks = Ranks::all();
    const std::vector<NamedMesh> hard = {{"uv_sphere", uv_sphere(64, 12)},
                                         {"thin_torus", torus(40, 6)},
                                         {"squares", perturbed(grid(6, 6), 1e-5, 3)},
                                         {"cubes", perturbed(kuhn(3, 3), 1e-5, 4)},
                                         {"tesseracts", perturbed(kuhn(4, 1), 1e-5, 5)},
                                         {"loose", perturbed(grid(8, 8), 2e-2, 6)}};
    for (const auto& [name, mesh] : hard)
        for (const double wide : {1e-4, 0.05, 0.2})
            expect_same(ranks, fmt::format("{} at {}", name, wide), mesh,
                        {MergeCriterion::dual_length, wide},
                        wide > 0.1 ? Ownership::random : Ownership::morton);
}

TEST(BrokenTwin, a_sign_or_a_first_piece_that_is_another_is_seen) {
    const auto ranks = Ranks::all();
    const MergeOptions options{MergeCriterion::dual_length, tolerance};
    const Mesh mesh = kuhn(3, 2);
    const Merged whole = make_merged(mesh, options);
    const LocalComplex local = distributed(ranks, mesh, Ownership::morton);
    const MergedCells cells = merged_on(ranks, local, options);
    MergedCells turned = cells, renamed = cells;
    if (local.degree(3).size() > 0) {
        turned.carriers[3][0].sign *= -1;
        renamed.carriers[3][0].first += 1;
        EXPECT_NE(difference(local, turned, whole.result), "");
        EXPECT_NE(difference(local, renamed, whole.result), "");
    }
}

} // namespace

} // namespace polydec::test
