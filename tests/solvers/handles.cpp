// SPDX-License-Identifier: MIT
#include "tests/support/test.h"

namespace polydec::test::in_handles {

/// use(handle) is a number that needs the handle's data.
template <class Handle, class Use>
void expect_kept(Handle handle, Use use) {
    const auto number = use(handle);
    Handle other = std::move(handle);
    EXPECT_EQ(use(handle), number);
    other = std::move(handle);
    EXPECT_EQ(use(handle), number);
    EXPECT_EQ(use(other), number);
}

const Discretization& squares() {
    static const Discretization mesh = circumcentric(grid(3, 3));
    return mesh;
}

const Vector flux = Vector::Zero(24); // through the edges of the squares
constexpr std::array<Index, 1> corner{0};

TEST(HandlesThatWereMoved, are_still_cells) {
    const Discretization& mesh = squares();
    expect_kept(mesh, [](auto& of) { return of.input_points().rows() + of.stars()[1].size(); });
    expect_kept(Cells(mesh), [](auto& of) { return of.name(1, 3); });
    expect_kept(mesh.complex(), [](auto& of) { return of.size(1); });
    expect_kept(mesh.complex().incidences(0), [](auto& of) { return of.matrix().nonZeros(); });
    expect_kept(mesh.input(), [](auto& of) { return of.input_row(2) + of.size(1); });
    expect_kept(mesh.passage(), [](auto& of) { return of.input().size(1); });
    expect_kept(mesh.merging(), [](auto& of) { return of.diamond(2).nonZeros(); });
    expect_kept(mesh.merged(), [](auto& of) { return of.lift()[1].nonZeros(); });
    expect_kept(mesh.geometry(), [](auto& of) { return of.metric().points()->rows(); });
    expect_kept(mesh.volumes(), [](auto& of) { return of.primal(1).sum(); });
    expect_kept(HodgeStar(mesh.volumes(), 1, mesh.stars()[1].matrix()),
                [](auto& of) { return of.is_diagonal() ? 0 : of.matrix().sum(); });
    expect_kept(FormSpace(mesh, Side::primal, 1), [](auto& of) { return of.size(); });
    expect_kept(LieDerivative(mesh, 1, Sampling::upwind), [&](auto& of) {
        return of(mesh.points(), {Side::primal, 1, Vector::Ones(mesh.size(1))}).values.sum();
    });
}

TEST(HandlesThatWereMoved, still_solve) {
    const Discretization& mesh = squares();
    const FormSpace space(mesh, Side::primal, 1);
    expect_kept(HodgeSolver(space), [](auto& of) {
        return of.decompose({Side::primal, 1, flux}).exact.values.size();
    });
    expect_kept(PoissonSolver(space), [](auto& of) { return of.harmonic_forms().rows(); });
    expect_kept(Diffusion(space), [](auto& of) { return of.size(); });
    const SparseMatrix A = FormSpace(mesh, Side::primal, 0).stiffness();
    expect_kept(CertifiedEigensolver(A, Vector::Ones(A.rows())),
                [](auto& of) { return of.smallest(1).values.size(); });
    expect_kept(StokesSolver(mesh), [](auto& of) {
        return of.solve({Side::primal, 1, flux}).flux.values.size();
    });
    expect_kept(Advection(mesh), [](auto& of) { return of.exchange_rate(flux); });
    expect_kept(ShallowWater(mesh), [&](auto& of) {
        return of.mass({Vector::Ones(mesh.size(2)), flux});
    });
    const IncompressibleFlow flow(mesh);
    expect_kept(flow, [](auto& of) { return of.energy(flux); });
    expect_kept(flow.implicit_part(0), [](auto& of) { return of.solve(flux).flux.sum(); });
}

TEST(HandlesThatWereMoved, still_measure_distances) {
    const GluedSurface surface(squares().pieces());
    const Vector lengths = edge_lengths(squares().pieces(), squares().points());
    for (const auto method : {DistanceMethod::exact, DistanceMethod::heat})
        expect_kept(GeodesicDistance(surface, lengths, {.method = method}),
                    [](auto& of) { return of.to(corner).values.sum(); });
    expect_kept(ShortestPaths(surface, lengths, corner),
                [](auto& of) { return of.distances().sum(); });
    expect_kept(SurfacePaths(squares(), corner), [](auto& of) { return of.from(5).length; });
    expect_kept(ParallelTransport(surface, lengths),
                [](auto& of) { return of.frames().reference.size(); });
}

/// What an accessor of a temporary gives is no reference into it.
template <class... Given>
constexpr bool are_values = (!std::is_reference_v<Given> && ...);

template <class Handle>
Handle&& of() noexcept;

static_assert(
    are_values<decltype(of<Cells>().input_volumes(0)), decltype(of<Cells>().input_dual_volumes(0)),
               decltype(of<HodgeStars>().volumes()), decltype(of<MergedCells>().complex()),
               decltype(of<MergedCells>().lift()), decltype(of<MergedCells>().volumes()),
               decltype(of<Geometry>().pieces()), decltype(of<MergedCells>().merging()),
               decltype(of<Geometry>().metric()), decltype(of<MergedCells>().geometry()),
               decltype(of<Geometry>().flat()), decltype(of<Geometry>().volumes()),
               decltype(of<Geometry>().centers())>);
static_assert(are_values<decltype(of<Incidences>().matrix()), decltype(of<Values>().vector()),
                         decltype(of<CellVolumes>().degree(0)), decltype(of<Passage>().flips()),
                         decltype(of<Discretization>().measured_points()),
                         decltype(of<Discretization>().measured_input_points()),
                         decltype(of<GluedBox>().mesh()), decltype(of<GluedBox>().vertices()),
                         decltype(of<GluedBox>().map(0))>);
static_assert(
    are_values<decltype(of<IncompressibleFlow>().mesh()), decltype(of<Flow>().flux()),
               decltype(of<IncompressibleFlow>().options()),
               decltype(of<ShortestPaths>().distances()),
               decltype(of<ParallelTransport>().frames()), decltype(of<Diffusion>().kept())>);

} // namespace polydec::test::in_handles
