// SPDX-License-Identifier: MIT
#include "backends/registry.h"

#include "backends/builtin_engines.h"
#include "backends/engine_folder.h"
#include "backends/engine_module.h"
#include "base/checks.h"
#include "base/did_you_mean.h"
#include "base/errors.h"
#include "system/child_process.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <mutex>
#include <utility>

namespace polydec {

namespace {

/// A kind in messages.
const char* title(EngineKind kind) {
    return kind == EngineKind::linear  ? "linear solver"
           : kind == EngineKind::eigen ? "eigensolver"
                                       : "integrator";
}

struct Entry {
    EngineInfo info = {.available = false};
    EngineFactory factory = {};
    std::string component = {}; // that it is from, where it is not in this program
};

using Key = std::pair<EngineKind, std::string>;

struct Registry {
    std::mutex mutex;
    std::map<Key, Entry> entries = {};

    Registry();

    void add_builtin(const char* name, const char* license, EngineFactory factory,
                     const char* description) {
        const EngineKind kind = kind_of(factory);
        entries[{kind, name}] = {.info = {name, kind, true, description, "", license},
                                 .factory = std::move(factory)};
    }

    // Of an optional component, so that who asks for it is told how to get it.
    void add_missing(EngineKind kind, const char* name, const char* license, const char* component,
                     const char* from, const char* description) {
        entries[{kind, name}] = {.info = {name, kind, false, description, from, license},
                                 .component = component};
    }
};

Registry::Registry() {
    add_builtin("auto", "MIT", builtin::make_auto,
                "chooses by the facts of the matrix, checks, falls back and says so");
    add_builtin("eigen.ldlt", "MPL-2.0", builtin::make_eigen_ldlt,
                "Eigen's sparse L D L^T (AMD): symmetric, direct, counts by inertia");
    add_builtin("eigen.lu", "MPL-2.0", builtin::make_eigen_lu,
                "Eigen's sparse LU (COLAMD): any regular matrix, direct");
    add_builtin("eigen.cg", "MPL-2.0", builtin::make_eigen_cg,
                "Eigen's conjugate gradients (Jacobi): positive semidefinite, iterative");
    add_builtin("eigen.bicgstab", "MPL-2.0", builtin::make_eigen_bicgstab,
                "Eigen's BiCGSTAB (ILUT): general, iterative");
    add_builtin("block-lanczos", "MIT", builtin::make_block_lanczos,
                "block Lanczos with thick restarts: several copies of an eigenvalue at once");
    add_builtin("spectra", "MPL-2.0", builtin::make_spectra,
                "Spectra's implicitly restarted Lanczos");
    add_builtin(
        "runge-kutta", "MIT", builtin::make_runge_kutta,
        "additive Runge-Kutta: Kennedy and Carpenter's 4(3) with a stiff part, else Dormand and "
        "Prince's 5(4)");
    add_builtin("backward-euler", "MIT", builtin::make_backward_euler,
                "backward Euler by fixed steps, of order 1: functions get no new extremes if their "
                "stars are diagonal and positive");
    add_builtin(
        "implicit-midpoint", "MIT", builtin::make_implicit_midpoint,
        "the implicit midpoint rule by fixed steps, of order 2: Crank and Nicolson's scheme where "
        "rates are linear");
    add_missing(
        EngineKind::linear, "cholmod", "LGPL-2.1-or-later AND GPL-2.0-or-later", "cholmod",
        POLYDEC_CHOLMOD_FROM,
        "SuiteSparse's CHOLMOD: symmetric, direct, supernodal where positive definite, counts "
        "by inertia");
    add_missing(EngineKind::linear, "mumps", "CECILL-C", "", POLYDEC_MUMPS_FROM,
                "MUMPS: symmetric, direct, with pivoting, counts by inertia");
    add_missing(
        EngineKind::linear, "petsc.cg-hypre", "BSD-2-Clause", "petsc", POLYDEC_PETSC_FROM,
        "PETSc's conjugate gradients with hypre's BoomerAMG: positive semidefinite, iterative, "
        "for large solids");
    add_missing(EngineKind::linear, "petsc.cg-gamg", "BSD-2-Clause", "petsc", POLYDEC_PETSC_FROM,
                "PETSc's conjugate gradients with its own multigrid (GAMG): positive semidefinite, "
                "iterative");
    add_missing(EngineKind::eigen, "slepc", "BSD-2-Clause", "slepc", POLYDEC_SLEPC_FROM,
                "SLEPc's Krylov-Schur method");
    add_missing(
        EngineKind::integrator, "cvode", "BSD-3-Clause", "", POLYDEC_CVODE_FROM,
        "SUNDIALS' CVODE: multistep methods of varying order, BDF where something is stiff, else "
        "Adams");
}

// Made at the first call, so nothing hangs on the order in which programs start.
Registry& registry() {
    static Registry instance;
    return instance;
}

/// What the registry knows of it now.
Entry found_now(const Key& key) {
    const std::lock_guard lock(registry().mutex);
    const auto found = registry().entries.find(key);
    return found == registry().entries.end() ? Entry{} : found->second;
}

/// The same, from a module if it is not there yet. Modules register by themselves, so nothing is
/// locked while they do.
Entry found_anywhere(const Key& key) {
    if (auto entry = found_now(key); entry.info.available)
        return entry;
    load_module_of(key.second);
    return found_now(key);
}

/// What there is to tell of it. The registry is not locked here: the reason waits for modules,
/// which lock it when they register.
EngineInfo told(const Entry& entry) {
    EngineInfo engine = entry.info;
    if (!entry.component.empty())
        engine.how_to_get += "; link polydec::" + entry.component;
    if (const auto reason = engine.available ? std::string{} : why_missing(engine.name);
        !reason.empty())
        engine.how_to_get += "; " + reason;
    return engine;
}

[[noreturn]] void refuse(EngineKind kind, const std::string& name) {
    std::vector<std::string> available;
    for (const auto& engine : engines()) {
        if (engine.kind == kind && engine.name == name)
            throw BackendUnavailable(fmt::format("this program does not contain the {} `{}`\n"
                                                 "To get it: {}.",
                                                 title(kind), name, engine.how_to_get));
        if (engine.kind == kind && engine.available)
            available.push_back(engine.name);
    }
    if (const auto reason = why_missing(name); !reason.empty())
        throw BackendUnavailable(
            fmt::format("the {} `{}` is not available: {}", title(kind), name, reason));
    throw InvalidInput(fmt::format("there is no {} called `{}`{}\nAvailable: {}.", title(kind),
                                   name, did_you_mean(name, available),
                                   fmt::join(available, ", ")));
}

template <typename Factory, typename... Options>
auto make(const std::string& name, const Options&... options) {
    const EngineKind kind = kind_of(Factory());
    const Entry entry = found_anywhere({kind, name});
    if (!entry.info.available)
        refuse(kind, name);
    auto engine = std::get<Factory>(entry.factory)(options...);
    if (!engine)
        throw BackendUnavailable(
            fmt::format("the factory of the {} `{}` returned nothing", title(kind), name));
    return engine;
}

enum class IfTaken { refuse, pass_over };

class ProgramRegistrar final : public EngineRegistrar {
public:
    explicit ProgramRegistrar(IfTaken if_taken) : if_taken_(if_taken) {}

    void add(EngineInfo info, EngineFactory factory) override {
        const bool is_empty = std::visit([](const auto& make) { return !make; }, factory);
        if (info.name.empty() || is_empty)
            throw InvalidInput("a registered engine needs a name and a factory");
        info.kind = kind_of(factory);
        info.available = true;
        const std::lock_guard lock(registry().mutex);
        auto& entry = registry().entries[{info.kind, info.name}];
        if (entry.info.available && if_taken_ == IfTaken::pass_over)
            return;
        if (entry.info.available)
            throw InvalidInput(
                fmt::format("an engine called `{}` is registered already", info.name));
        if (info.description.empty())
            info.description = entry.info.description;
        if (info.how_to_get.empty())
            info.how_to_get = entry.info.how_to_get;
        if (info.license.empty())
            info.license = entry.info.license;
        entry = {.info = std::move(info), .factory = std::move(factory)};
    }

private:
    IfTaken if_taken_;
};

/// A program of its own, which is found and not made.
EngineInfo tetgen() {
    return {
        "tetgen",
        EngineKind::mesher,
        find_program("tetgen").has_value(),
        "TetGen: Delaunay tetrahedra in closed surfaces, with bounds of quality and volume; run "
        "as a program",
        "apt-get install tetgen",
        "AGPL-3.0-or-later"};
}

void check(const LinearSolverOptions& options) {
    check_positive("linear solver: the tolerance", options.tolerance);
    if (options.max_iterations < 0)
        throw InvalidInput(fmt::format("linear solver: {} iterations: expected at least 0",
                                       options.max_iterations));
}

} // namespace

EngineRegistrar& program_registrar() {
    static ProgramRegistrar instance(IfTaken::refuse);
    return instance;
}

EngineRegistrar& registrar_of_missing() {
    static ProgramRegistrar instance(IfTaken::pass_over);
    return instance;
}

std::unique_ptr<LinearSolver> make_linear_solver(const std::string& name,
                                                 const LinearSolverOptions& options) {
    check(options);
    return make<LinearSolverFactory>(name, options);
}

std::unique_ptr<EigenSolver> make_eigen_solver(const std::string& name) {
    return make<EigenSolverFactory>(name);
}

std::unique_ptr<Integrator> make_integrator(const std::string& name,
                                            const IntegratorOptions& options) {
    return make<IntegratorFactory>(name, options);
}

void register_engine(const std::string& name, EngineFactory factory) {
    if (!found_now({kind_of(factory), name}).info.name.empty())
        throw InvalidInput(
            fmt::format("an engine called `{}` is known already: choose another name", name));
    program_registrar().add({.name = name}, std::move(factory));
}

bool has_linear_solver(const std::string& name) {
    return found_anywhere({EngineKind::linear, name}).info.available;
}

std::string how_to_get_linear_solver(const std::string& name) {
    const Entry entry = found_now({EngineKind::linear, name});
    return entry.info.available ? "" : told(entry).how_to_get;
}

std::vector<EngineInfo> engines() {
    load_all_modules();
    std::unique_lock lock(registry().mutex);
    const auto entries = registry().entries;
    lock.unlock();
    std::vector<EngineInfo> result;
    for (const auto& [key, entry] : entries)
        result.push_back(told(entry));
    result.push_back(tetgen());
    return result;
}

} // namespace polydec
