// SPDX-License-Identifier: MIT
#include "backends/component.h"
#include "backends/eigen/dense_pairs.h"
#include "backends/eigen/slepc_run.h"

namespace polydec {

namespace {

class SlepcSolver final : public EigenSolver {
public:
    std::string name() const override { return "slepc"; }

protected:
    EigenPairs compute(const SymmetricOperator& A, Index count,
                       const EigenOptions& options) const override {
        if (A.size <= builtin::dense_size || options.krylov_dimension >= A.size)
            return builtin::dense_pairs(A, count, name());
        const petsc::Session session(name());
        petsc::start_slepc(session);
        const auto require = [&](PetscErrorCode error, const char* what) {
            session.require(error, what);
        };
        petsc::SlepcRun run(PETSC_COMM_SELF, A, count, options, require);
        require(run.solve(), "the iteration");
        return run.pairs(count);
    }
};

} // namespace

void component::add_slepc(EngineRegistrar& registrar) {
    registrar.add({.name = "slepc"}, [] { return std::make_unique<SlepcSolver>(); });
}

} // namespace polydec
