// SPDX-License-Identifier: MIT
#include "distributed/ksp.h"

#include "backends/linear/petsc_options.h"
#include "base/did_you_mean.h"
#include "base/errors.h"
#include "distributed/petsc_calls.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <petscksp.h>

namespace polydec {

namespace {

struct EngineMethod {
    const char* engine;
    std::string options;
};

/// Symmetric factors without a root on several ranks, whose negative pivots nobody would count; a
/// null pivot is told.
const std::string mumps =
    "-ksp_type preonly -pc_type cholesky -pc_factor_mat_solver_type mumps -mat_mumps_icntl_13 1 "
    "-mat_mumps_icntl_24 1 ";

const std::vector<EngineMethod>& methods() {
    static const std::vector<EngineMethod> all = {
#ifdef PETSC_HAVE_HYPRE
        {"petsc.cg-hypre", petsc::conjugate_gradients + petsc::boomeramg},
#endif
        {"petsc.cg-gamg", petsc::conjugate_gradients + petsc::gamg},
#ifdef PETSC_HAVE_MUMPS
        {"petsc.mumps", mumps},
#endif
    };
    return all;
}

const EngineMethod& method(const std::string& engine) {
    std::vector<std::string> names{"auto"};
    for (const EngineMethod& known : methods()) {
        if (engine == known.engine)
            return known;
        names.emplace_back(known.engine);
    }
    throw InvalidInput(fmt::format("there is no engine '{}' over several ranks{}\nAvailable: {}.",
                                   engine, did_you_mean(engine, names), fmt::join(names, ", ")));
}

bool is_direct(const std::string& engine) {
    return engine == "petsc.mumps";
}

/// Of a direct engine.
Mat factor_of(KSP ksp) {
    PC pc = nullptr;
    Mat factor = nullptr;
    require(KSPGetPC(ksp, &pc), "looking at a factor");
    require(PCFactorGetMatrix(pc, &factor), "looking at a factor");
    return factor;
}

constexpr double first_room = 50; // percent of memory above MUMPS' estimate
constexpr double most_room = 1000;
constexpr int mumps_lacks_room = -9, mumps_lacks_memory = -13, mumps_may_not_have_more = -19;
constexpr PetscInt most_iterations = 1000;
constexpr double ksp_tolerance = 1e-12;

} // namespace

struct Ksp::Solver {
    petsc::Owned<KSP, KSPDestroy> ksp;
};

std::vector<std::string> Ksp::engines(Definiteness definiteness) {
    std::vector<std::string> names;
    for (const EngineMethod& known : methods())
        if (definiteness != Definiteness::indefinite || is_direct(known.engine))
            names.emplace_back(known.engine);
    return names;
}

Ksp::Ksp(const Ranks& ranks, Mat matrix, const SharedEngine& engine, Definiteness definiteness)
    : ranks_(ranks), engine_(engine), matrix_(matrix), solver_(std::make_unique<Solver>()) {
    ranks.together("engine", [&] { petsc::check_options(engine.name, engine.options); });
    const EngineMethod& found = method(engine.name);
    require(MatSetOption(matrix, MAT_SYMMETRIC, PETSC_TRUE), "taking over a matrix");
    if (definiteness == Definiteness::positive)
        require(MatSetOption(matrix, MAT_SPD, PETSC_TRUE), "taking over a matrix");
    set_up(found.options, first_room);
}

Ksp::~Ksp() = default;

void Ksp::set_up(const std::string& own_options, double room) {
    const petsc::Session session(engine_.name);
    const std::string roomy =
        is_direct(engine_.name) ? fmt::format(" -mat_mumps_icntl_14 {:.0f} ", room) : "";
    // a user's own room is where MUMPS begins; the last word counts
    const petsc::SetOptions set(session, room == first_room
                                             ? own_options + roomy + engine_.options
                                             : own_options + engine_.options + roomy);
    require(KSPCreate(communicator(ranks_), solver_->ksp.put()), "making a solver");
    KSP ksp = solver_->ksp.get();
    require(KSPSetOptionsPrefix(ksp, petsc::prefix), "making a solver");
    require(KSPSetOperators(ksp, matrix_, matrix_), "making a solver");
    require(KSPSetTolerances(ksp, ksp_tolerance, 0, PETSC_MAX_REAL, most_iterations),
            "making a solver");
    // errors of these are the same on all ranks: a text that says nothing, a method without a setup
    const auto options_read = KSPSetFromOptions(ksp);
    ranks_.together("options", [&] { session.require(options_read, "reading the options"); });
    const auto done = KSPSetUp(ksp);
    ranks_.together("setup", [&] {
        session.require(done, "the setup");
        petsc::require_read(engine_.name, engine_.options);
    });
    if (is_direct(engine_.name)) {
        PetscInt info = 0;
#ifdef PETSC_HAVE_MUMPS
        require(MatMumpsGetInfog(factor_of(ksp), 1, &info), "looking at a factor");
#endif
        if (info == mumps_lacks_room && 2 * room <= most_room)
            return set_up(own_options, 2 * room);
        if (info < 0)
            fail(fmt::format("MUMPS could not factorize the matrix: MUMPS error {}{}", info,
                             info == mumps_lacks_room || info == mumps_lacks_memory ||
                                     info == mumps_may_not_have_more
                                 ? ", not enough memory: use more ranks"
                                 : ""));
    }
    check_setup();
}

void Ksp::check_setup() const {
    PC pc = nullptr;
    PCFailedReason reason = PC_NOERROR;
    require(KSPGetPC(solver_->ksp.get(), &pc), "looking at a solver");
    require(PCGetFailedReason(pc, &reason), "looking at a solver");
    if (ranks_.any(reason != PC_NOERROR))
        fail("the matrix cannot be factorized, or multigrid fails for it");
}

void Ksp::fail(const std::string& why) const {
    throw SolverFailure(fmt::format("{}: {}", engine_.name, why),
                        SolveReport::failed(engine_.name));
}

GlobalIndex Ksp::negative_pivots() const {
    PetscInt negative = 0;
    require(MatGetInertia(factor_of(solver_->ksp.get()), &negative, nullptr, nullptr),
            "looking at a factor");
    return negative;
}

Vector Ksp::solve(const Vector& b, Index& iterations) {
    const petsc::Session session(engine_.name);
    const OwnedVec right = vector_of(ranks_, b), x = vector_of(ranks_, Vector::Zero(b.size()));
    const auto done = KSPSolve(solver_->ksp.get(), right.get(), x.get());
    ranks_.together("solve", [&] { session.require(done, "the solution"); });
    PetscInt steps = 0;
    KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
    require(KSPGetIterationNumber(solver_->ksp.get(), &steps), "looking at a solution");
    require(KSPGetConvergedReason(solver_->ksp.get(), &reason), "looking at a solution");
    iterations += is_direct(engine_.name) ? 0 : static_cast<Index>(steps);
    Vector result = own_entries(x.get());
    if (ranks_.any(reason <= 0 || !result.allFinite())) {
        const char* text = nullptr;
        KSPGetConvergedReasonString(solver_->ksp.get(), &text);
        fail(fmt::format("no convergence after {} iterations ({})", steps,
                         text != nullptr ? text : "unknown reason"));
    }
    return result;
}

} // namespace polydec
