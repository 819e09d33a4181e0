// SPDX-License-Identifier: MIT
#include "distributed/shared_lanczos.h"

#include "base/errors.h"
#include "distributed/petsc_calls.h"

#ifdef POLYDEC_WITH_SLEPC
#include "backends/eigen/slepc_run.h"

namespace polydec {

DenseMatrix largest_eigenvectors(const Ranks& ranks, const SymmetricOperator& own, Index count,
                                 const Vector& start, double tolerance) {
    const petsc::Session session("slepc");
    petsc::start_slepc(session);
    // with few vectors more than wanted the last copies take many restarts
    constexpr GlobalIndex room = 40;
    constexpr Index most_restarts = 300;
    const auto columns = static_cast<Index>(
        std::min(ranks.sum(own.size), std::max<GlobalIndex>(2 * count, count + room)));
    petsc::SlepcRun run(communicator(ranks), own, count, {columns, tolerance, most_restarts, start},
                        require);
    const auto done = run.solve();
    ranks.together("iteration", [&] { session.require(done, "the iteration"); });
    return run.pairs(count).vectors;
}

} // namespace polydec

#else

namespace polydec {

DenseMatrix largest_eigenvectors(const Ranks&, const SymmetricOperator&, Index, const Vector&,
                                 double) {
    throw BackendUnavailable(
        "slepc: spectra over several ranks need SLEPc, which was missing when polydec was built\n"
        "Install slepc-dev and build polydec again.");
}

} // namespace polydec

#endif
