// SPDX-License-Identifier: MIT
#include "backends/registry.h"

#include "backends/builtin_engines.h"
#include "backends/engine_folder.h"
#include "base/did_you_mean.h"
#include "base/errors.h"
#include "system/child_process.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
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

struct Registry {
    std::mutex mutex;
    std::map<std::string, Entry<LinearSolverFactory>> linear;
    std::map<std::string, Entry<EigenSolverFactory>> eigen;
    std::map<std::string, Entry<IntegratorFactory>> integrator;
};

template <typename Factory>
void add(std::map<std::string, Entry<Factory>>& known, EngineInfo info, Factory factory) {
    info.available = static_cast<bool>(factory);
    const std::string name = info.name;
    known.insert_or_assign(name,
                           Entry<Factory>{.info = std::move(info), .factory = std::move(factory)});
}

// Engines of optional components, so that who asks for one is told how to get it.
void add_missing(Registry& registry) {
    const auto linear = [&](const char* component, const char* from, const char* name,
                            const char* license, const char* description) {
        registry.linear[name] = {
            .info = {name, EngineKind::linear, false, description, from, license},
            .component = component};
    };
    linear("cholmod", POLYDEC_CHOLMOD_FROM, "cholmod", "LGPL-2.1-or-later AND GPL-2.0-or-later",
           "SuiteSparse's CHOLMOD: symmetric, direct, supernodal where positive definite, counts "
           "by inertia");
    linear("", POLYDEC_MUMPS_FROM, "mumps", "CECILL-C",
           "MUMPS: symmetric, direct, with pivoting, counts by inertia");
    linear("petsc", POLYDEC_PETSC_FROM, "petsc.cg-hypre", "BSD-2-Clause",
           "PETSc's conjugate gradients with hypre's BoomerAMG: positive semidefinite, iterative, "
           "for large solids");
    linear("petsc", POLYDEC_PETSC_FROM, "petsc.cg-gamg", "BSD-2-Clause",
           "PETSc's conjugate gradients with its own multigrid (GAMG): positive semidefinite, "
           "iterative");
    registry.eigen["slepc"] = {.info = {"slepc", EngineKind::eigen, false,
                                        "SLEPc's Krylov-Schur method", POLYDEC_SLEPC_FROM,
                                        "BSD-2-Clause"},
                               .component = "slepc"};
    registry.integrator["cvode"] = {
        .info = {"cvode", EngineKind::integrator, false,
                 "SUNDIALS' CVODE: multistep methods of varying order, BDF where something is "
                 "stiff, else Adams",
                 POLYDEC_CVODE_FROM, "BSD-3-Clause"}};
}

void add_builtin(Registry& registry) {
    const auto linear = [&](const char* name, const char* description, LinearSolverFactory factory,
                            const char* license = "MPL-2.0") {
        add(registry.linear, {name, EngineKind::linear, true, description, "", license},
            std::move(factory));
    };
    linear("auto", "chooses by the facts of the matrix, checks, falls back and says so",
           builtin::make_auto, "MIT");
    linear("eigen.ldlt", "Eigen's sparse L D L^T (AMD): symmetric, direct, counts by inertia",
           builtin::make_eigen_ldlt);
    linear("eigen.lu", "Eigen's sparse LU (COLAMD): any regular matrix, direct",
           builtin::make_eigen_lu);
    linear("eigen.cg", "Eigen's conjugate gradients (Jacobi): positive semidefinite, iterative",
           builtin::make_eigen_cg);
    linear("eigen.bicgstab", "Eigen's BiCGSTAB (ILUT): general, iterative",
           builtin::make_eigen_bicgstab);
    add(registry.eigen,
        {"block-lanczos", EngineKind::eigen, true,
         "block Lanczos with thick restarts: several copies of an eigenvalue at once", "", "MIT"},
        EigenSolverFactory(builtin::make_block_lanczos));
    add(registry.eigen,
        {"spectra", EngineKind::eigen, true, "Spectra's implicitly restarted Lanczos", "",
         "MPL-2.0"},
        EigenSolverFactory(builtin::make_spectra));
    add(registry.integrator,
        {"runge-kutta", EngineKind::integrator, true,
         "additive Runge-Kutta: Kennedy and Carpenter's 4(3) with a stiff part, else Dormand and "
         "Prince's 5(4)",
         "", "MIT"},
        IntegratorFactory(builtin::make_runge_kutta));
    add(registry.integrator,
        {"backward-euler", EngineKind::integrator, true,
         "backward Euler by fixed steps, of order 1: functions get no new extremes", "", "MIT"},
        IntegratorFactory(builtin::make_backward_euler));
    add(registry.integrator,
        {"implicit-midpoint", EngineKind::integrator, true,
         "the implicit midpoint rule by fixed steps, of order 2: Crank and Nicolson's scheme where "
         "rates are linear",
         "", "MIT"},
        IntegratorFactory(builtin::make_implicit_midpoint));
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
std::vector<std::string> available_names(const std::map<std::string, Entry<Factory>>& known) {
    std::vector<std::string> names;
    for (const auto& [name, entry] : known)
        if (entry.factory)
            names.push_back(name);
    return names;
}

/// The factory of that name that is there now, or an empty one.
template <typename Factory>
Factory found_now(const std::map<std::string, Entry<Factory>>& known, const std::string& name) {
    const std::lock_guard lock(registry().mutex);
    const auto found = known.find(name);
    return found == known.end() ? Factory{} : found->second.factory;
}

/// The same, from a module if it is not there yet. Modules register by themselves, so nothing is
/// locked while they do.
template <typename Factory>
Factory found_anywhere(const std::map<std::string, Entry<Factory>>& known,
                       const std::string& name) {
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
[[noreturn]] void refuse(const std::map<std::string, Entry<Factory>>& known,
                         const std::string& name, const char* kind) {
    const auto reason = why_missing(name);
    std::unique_lock lock(registry().mutex);
    const auto found = known.find(name);
    if (found == known.end() && !reason.empty())
        throw BackendUnavailable(
            fmt::format("the {} `{}` is not available: {}", kind, name, reason));
    if (found == known.end())
        throw InvalidInput(fmt::format("there is no {} called `{}`{}\nAvailable: {}.", kind, name,
                                       did_you_mean(name, available_names(known)),
                                       fmt::join(available_names(known), ", ")));
    EngineInfo engine = found->second.told();
    lock.unlock();
    add_reason(engine);
    throw BackendUnavailable(fmt::format("this program does not contain the {} `{}`\n"
                                         "To get it: {}.",
                                         kind, name, engine.how_to_get));
}

template <typename Factory>
Factory find(const std::map<std::string, Entry<Factory>>& known, const std::string& name,
             const char* kind) {
    if (auto factory = found_anywhere(known, name))
        return factory;
    load_all_modules(); // all names are to be told
    refuse(known, name, kind);
}

template <typename Factory>
void enroll(std::map<std::string, Entry<Factory>>& known, EngineInfo info, EngineKind kind,
            Factory factory) {
    if (info.name.empty() || !factory)
        throw InvalidInput("a registered engine needs a name and a factory");
    info.kind = kind;

    const std::lock_guard lock(registry().mutex);
    const auto found = known.find(info.name);
    if (found != known.end() && found->second.factory)
        throw InvalidInput(fmt::format("an engine called `{}` is registered already", info.name));
    if (found != known.end() && info.description.empty())
        info.description = found->second.info.description;
    if (found != known.end() && info.how_to_get.empty())
        info.how_to_get = found->second.info.how_to_get;
    if (found != known.end() && info.license.empty())
        info.license = found->second.info.license;
    add(known, std::move(info), std::move(factory));
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
    if (!(options.tolerance > 0.0) || !std::isfinite(options.tolerance))
        throw InvalidInput(
            fmt::format("linear solver: the tolerance {} is not positive", options.tolerance));
    if (options.max_iterations < 0 || options.blas_threads < 0)
        throw InvalidInput(fmt::format(
            "linear solver: {} iterations on {} threads: expected numbers of at least 0",
            options.max_iterations, options.blas_threads));
}

} // namespace

std::unique_ptr<LinearSolver> make_linear_solver(const std::string& name,
                                                 const LinearSolverOptions& options) {
    check(options);
    auto solver = find(registry().linear, name, "linear solver")(options);
    if (!solver)
        throw BackendUnavailable(
            fmt::format("the factory of the linear solver `{}` returned nothing", name));
    return solver;
}

std::unique_ptr<EigenSolver> make_eigen_solver(const std::string& name) {
    auto solver = find(registry().eigen, name, "eigensolver")();
    if (!solver)
        throw BackendUnavailable(
            fmt::format("the factory of the eigensolver `{}` returned nothing", name));
    return solver;
}

std::unique_ptr<Integrator> make_integrator(const std::string& name,
                                            const IntegratorOptions& options) {
    auto integrator = find(registry().integrator, name, "integrator")(options);
    if (!integrator)
        throw BackendUnavailable(
            fmt::format("the factory of the integrator `{}` returned nothing", name));
    return integrator;
}

void register_linear_solver(const EngineInfo& info, LinearSolverFactory factory) {
    enroll(registry().linear, info, EngineKind::linear, std::move(factory));
}

void register_linear_solver(const std::string& name, LinearSolverFactory factory) {
    register_linear_solver(EngineInfo{.name = name}, std::move(factory));
}

void register_eigen_solver(const EngineInfo& info, EigenSolverFactory factory) {
    enroll(registry().eigen, info, EngineKind::eigen, std::move(factory));
}

void register_eigen_solver(const std::string& name, EigenSolverFactory factory) {
    register_eigen_solver(EngineInfo{.name = name, .kind = EngineKind::eigen}, std::move(factory));
}

void register_integrator(const EngineInfo& info, IntegratorFactory factory) {
    enroll(registry().integrator, info, EngineKind::integrator, std::move(factory));
}

void register_integrator(const std::string& name, IntegratorFactory factory) {
    register_integrator(EngineInfo{.name = name, .kind = EngineKind::integrator},
                        std::move(factory));
}

std::string how_to_get_linear_solver(const std::string& name) {
    EngineInfo engine;
    {
        const std::lock_guard lock(registry().mutex);
        const auto found = registry().linear.find(name);
        if (found == registry().linear.end() || found->second.factory)
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
        for (const auto& [name, entry] : known)
            result.push_back(entry.told());
    };
    {
        const std::lock_guard lock(registry().mutex);
        if (kind == EngineKind::linear)
            list(registry().linear);
        else if (kind == EngineKind::eigen)
            list(registry().eigen);
        else
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
