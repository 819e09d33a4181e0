// SPDX-License-Identifier: MIT
#include "backends/registry.h"

#include "backends/builtin_engines.h"
#include "backends/engine_folder.h"
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

template <typename Factory>
struct Entry {
    EngineInfo info = {};
    Factory factory = {};       // empty: known, but not in this program
    std::string component = {}; // that it is from, where it is not in this program

    /// What there is to tell of it now.
    EngineInfo told() const {
        EngineInfo result = info;
        if (!component.empty())
            result.how_to_get += "; link polydec::" + component;
        return result;
    }
};

/// The engines of one kind, by name.
template <typename Factory>
struct KnownEngines {
    EngineKind kind;
    const char* title; // in messages
    std::map<std::string, Entry<Factory>> entries = {};

    void add_builtin(const char* name, const char* license, Factory factory,
                     const char* description) {
        entries[name] = {.info = {name, kind, true, description, "", license},
                         .factory = std::move(factory)};
    }

    // Of an optional component, so that who asks for it is told how to get it.
    void add_missing(const char* name, const char* license, const char* component, const char* from,
                     const char* description) {
        entries[name] = {.info = {name, kind, false, description, from, license},
                         .component = component};
    }
};

struct Registry {
    std::mutex mutex;
    KnownEngines<LinearSolverFactory> linear{EngineKind::linear, "linear solver"};
    KnownEngines<EigenSolverFactory> eigen{EngineKind::eigen, "eigensolver"};
    KnownEngines<IntegratorFactory> integrator{EngineKind::integrator, "integrator"};
};

void add_missing(Registry& registry) {
    registry.linear.add_missing(
        "cholmod", "LGPL-2.1-or-later AND GPL-2.0-or-later", "cholmod", POLYDEC_CHOLMOD_FROM,
        "SuiteSparse's CHOLMOD: symmetric, direct, supernodal where positive definite, counts "
        "by inertia");
    registry.linear.add_missing("mumps", "CECILL-C", "", POLYDEC_MUMPS_FROM,
                                "MUMPS: symmetric, direct, with pivoting, counts by inertia");
    registry.linear.add_missing(
        "petsc.cg-hypre", "BSD-2-Clause", "petsc", POLYDEC_PETSC_FROM,
        "PETSc's conjugate gradients with hypre's BoomerAMG: positive semidefinite, iterative, "
        "for large solids");
    registry.linear.add_missing(
        "petsc.cg-gamg", "BSD-2-Clause", "petsc", POLYDEC_PETSC_FROM,
        "PETSc's conjugate gradients with its own multigrid (GAMG): positive semidefinite, "
        "iterative");
    registry.eigen.add_missing("slepc", "BSD-2-Clause", "slepc", POLYDEC_SLEPC_FROM,
                               "SLEPc's Krylov-Schur method");
    registry.integrator.add_missing(
        "cvode", "BSD-3-Clause", "", POLYDEC_CVODE_FROM,
        "SUNDIALS' CVODE: multistep methods of varying order, BDF where something is stiff, else "
        "Adams");
}

void add_builtin(Registry& registry) {
    registry.linear.add_builtin(
        "auto", "MIT", builtin::make_auto,
        "chooses by the facts of the matrix, checks, falls back and says so");
    registry.linear.add_builtin(
        "eigen.ldlt", "MPL-2.0", builtin::make_eigen_ldlt,
        "Eigen's sparse L D L^T (AMD): symmetric, direct, counts by inertia");
    registry.linear.add_builtin("eigen.lu", "MPL-2.0", builtin::make_eigen_lu,
                                "Eigen's sparse LU (COLAMD): any regular matrix, direct");
    registry.linear.add_builtin(
        "eigen.cg", "MPL-2.0", builtin::make_eigen_cg,
        "Eigen's conjugate gradients (Jacobi): positive semidefinite, iterative");
    registry.linear.add_builtin("eigen.bicgstab", "MPL-2.0", builtin::make_eigen_bicgstab,
                                "Eigen's BiCGSTAB (ILUT): general, iterative");
    registry.eigen.add_builtin(
        "block-lanczos", "MIT", builtin::make_block_lanczos,
        "block Lanczos with thick restarts: several copies of an eigenvalue at once");
    registry.eigen.add_builtin("spectra", "MPL-2.0", builtin::make_spectra,
                               "Spectra's implicitly restarted Lanczos");
    registry.integrator.add_builtin(
        "runge-kutta", "MIT", builtin::make_runge_kutta,
        "additive Runge-Kutta: Kennedy and Carpenter's 4(3) with a stiff part, else Dormand and "
        "Prince's 5(4)");
    registry.integrator.add_builtin("backward-euler", "MIT", builtin::make_backward_euler,
                                    "backward Euler by fixed steps, of order 1: functions get no "
                                    "new extremes if their stars are "
                                    "diagonal and positive");
    registry.integrator.add_builtin(
        "implicit-midpoint", "MIT", builtin::make_implicit_midpoint,
        "the implicit midpoint rule by fixed steps, of order 2: Crank and Nicolson's scheme where "
        "rates are linear");
}

// Made at the first call, so nothing hangs on the order in which programs start.
Registry& registry() {
    struct Filled : Registry {
        Filled() {
            add_builtin(*this);
            add_missing(*this);
        }
    };
    static Filled instance;
    return instance;
}

template <typename Factory>
std::vector<std::string> available_names(const KnownEngines<Factory>& known) {
    std::vector<std::string> names;
    for (const auto& [name, entry] : known.entries)
        if (entry.factory)
            names.push_back(name);
    return names;
}

/// The factory of that name that is there now, or an empty one.
template <typename Factory>
Factory found_now(const KnownEngines<Factory>& known, const std::string& name) {
    const std::lock_guard lock(registry().mutex);
    const auto found = known.entries.find(name);
    return found == known.entries.end() ? Factory{} : found->second.factory;
}

/// The same, from a module if it is not there yet. Modules register by themselves, so nothing is
/// locked while they do.
template <typename Factory>
Factory found_anywhere(const KnownEngines<Factory>& known, const std::string& name) {
    if (auto factory = found_now(known, name))
        return factory;
    load_module_of(name);
    return found_now(known, name);
}

// The reason is asked for while the registry is not locked, which modules lock when they register.
void add_reason(EngineInfo& engine) {
    if (const auto reason = engine.available ? std::string{} : why_missing(engine.name);
        !reason.empty())
        engine.how_to_get += "; " + reason;
}

template <typename Factory>
[[noreturn]] void refuse(const KnownEngines<Factory>& known, const std::string& name) {
    const auto reason = why_missing(name);
    std::unique_lock lock(registry().mutex);
    const auto found = known.entries.find(name);
    if (found == known.entries.end() && !reason.empty())
        throw BackendUnavailable(
            fmt::format("the {} `{}` is not available: {}", known.title, name, reason));
    if (found == known.entries.end())
        throw InvalidInput(fmt::format("there is no {} called `{}`{}\nAvailable: {}.", known.title,
                                       name, did_you_mean(name, available_names(known)),
                                       fmt::join(available_names(known), ", ")));
    EngineInfo engine = found->second.told();
    lock.unlock();
    add_reason(engine);
    throw BackendUnavailable(fmt::format("this program does not contain the {} `{}`\n"
                                         "To get it: {}.",
                                         known.title, name, engine.how_to_get));
}

template <typename Factory, typename... Options>
auto make(const KnownEngines<Factory>& known, const std::string& name, const Options&... options) {
    const auto factory = found_anywhere(known, name);
    if (!factory) {
        load_all_modules(); // all names are to be told
        refuse(known, name);
    }
    auto engine = factory(options...);
    if (!engine)
        throw BackendUnavailable(
            fmt::format("the factory of the {} `{}` returned nothing", known.title, name));
    return engine;
}

template <typename Factory>
void enroll(KnownEngines<Factory>& known, EngineInfo info, Factory factory) {
    if (info.name.empty() || !factory)
        throw InvalidInput("a registered engine needs a name and a factory");
    const std::lock_guard lock(registry().mutex);
    auto& entry = known.entries[info.name];
    if (entry.factory)
        throw InvalidInput(fmt::format("an engine called `{}` is registered already", info.name));
    info.kind = known.kind;
    info.available = true;
    if (info.description.empty())
        info.description = entry.info.description;
    if (info.how_to_get.empty())
        info.how_to_get = entry.info.how_to_get;
    if (info.license.empty())
        info.license = entry.info.license;
    entry = {.info = std::move(info), .factory = std::move(factory)};
}

/// An engine from outside has no name of one that may be loaded yet.
template <typename Factory>
void enroll_new(KnownEngines<Factory>& known, const std::string& name, Factory factory) {
    {
        const std::lock_guard lock(registry().mutex);
        if (known.entries.contains(name))
            throw InvalidInput(
                fmt::format("an engine called `{}` is known already: choose another name", name));
    }
    enroll(known, EngineInfo{.name = name}, std::move(factory));
}

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
    if (options.max_iterations < 0 || options.blas_threads < 0)
        throw InvalidInput(fmt::format(
            "linear solver: {} iterations on {} threads: expected numbers of at least 0",
            options.max_iterations, options.blas_threads));
}

} // namespace

std::unique_ptr<LinearSolver> make_linear_solver(const std::string& name,
                                                 const LinearSolverOptions& options) {
    check(options);
    return make(registry().linear, name, options);
}

std::unique_ptr<EigenSolver> make_eigen_solver(const std::string& name) {
    return make(registry().eigen, name);
}

std::unique_ptr<Integrator> make_integrator(const std::string& name,
                                            const IntegratorOptions& options) {
    return make(registry().integrator, name, options);
}

void register_linear_solver(const EngineInfo& info, LinearSolverFactory factory) {
    enroll(registry().linear, info, std::move(factory));
}

void register_linear_solver(const std::string& name, LinearSolverFactory factory) {
    enroll_new(registry().linear, name, std::move(factory));
}

void register_eigen_solver(const EngineInfo& info, EigenSolverFactory factory) {
    enroll(registry().eigen, info, std::move(factory));
}

void register_eigen_solver(const std::string& name, EigenSolverFactory factory) {
    enroll_new(registry().eigen, name, std::move(factory));
}

void register_integrator(const EngineInfo& info, IntegratorFactory factory) {
    enroll(registry().integrator, info, std::move(factory));
}

void register_integrator(const std::string& name, IntegratorFactory factory) {
    enroll_new(registry().integrator, name, std::move(factory));
}

std::string how_to_get_linear_solver(const std::string& name) {
    EngineInfo engine;
    {
        const std::lock_guard lock(registry().mutex);
        const auto& known = registry().linear.entries;
        const auto found = known.find(name);
        if (found == known.end() || found->second.factory)
            return {};
        engine = found->second.told();
    }
    add_reason(engine);
    return engine.how_to_get;
}

std::vector<EngineInfo> engines() {
    std::vector<EngineInfo> result;
    for (const auto kind :
         {EngineKind::linear, EngineKind::eigen, EngineKind::integrator, EngineKind::mesher})
        for (auto& engine : engines(kind))
            result.push_back(std::move(engine));
    return result;
}

std::vector<EngineInfo> engines(EngineKind kind) {
    if (kind == EngineKind::mesher)
        return {tetgen()};
    load_all_modules();
    std::vector<EngineInfo> result;
    const auto list = [&](const auto& known) {
        if (known.kind == kind)
            for (const auto& [name, entry] : known.entries)
                result.push_back(entry.told());
    };
    {
        const std::lock_guard lock(registry().mutex);
        list(registry().linear);
        list(registry().eigen);
        list(registry().integrator);
    }
    for (auto& engine : result)
        add_reason(engine);
    return result;
}

bool has_linear_solver(const std::string& name) {
    return static_cast<bool>(found_anywhere(registry().linear, name));
}

bool has_eigen_solver(const std::string& name) {
    return static_cast<bool>(found_anywhere(registry().eigen, name));
}

bool has_integrator(const std::string& name) {
    return static_cast<bool>(found_anywhere(registry().integrator, name));
}

} // namespace polydec
