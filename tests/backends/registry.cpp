// SPDX-License-Identifier: MIT
#include "tests/backends/matrices.h"

#include <thread>

namespace polydec::test::in_registry {

EngineInfo info_of(const std::string& name) {
    for (const auto& engine : engines())
        if (engine.name == name)
            return engine;
    return {};
}

void make(EngineKind kind, const std::string& name) {
    if (kind == EngineKind::linear)
        make_linear_solver(name);
    else if (kind == EngineKind::eigen)
        make_eigen_solver(name);
    else
        make_integrator(name);
}

TEST(registry, the_engines_that_are_always_there_are_there) {
    for (const char* name : {"auto", "eigen.ldlt", "eigen.lu", "eigen.cg", "eigen.bicgstab"}) {
        EXPECT_TRUE(has_linear_solver(name));
        EXPECT_EQ(make_linear_solver(name)->name(), name);
        EXPECT_TRUE(info_of(name).available);
        EXPECT_FALSE(info_of(name).description.empty());
    }
    EXPECT_EQ(make_eigen_solver("spectra")->name(), "spectra");
    EXPECT_EQ(info_of("spectra").kind, EngineKind::eigen);
    EXPECT_EQ(make_eigen_solver("block-lanczos")->name(), "block-lanczos");
    for (const char* name : {"runge-kutta", "backward-euler", "implicit-midpoint"})
        EXPECT_EQ(make_integrator(name, {.fixed_step = 1})->name(), name);
    EXPECT_EQ(info_of("runge-kutta").kind, EngineKind::integrator);
}

TEST(registry, missing_engines_are_listed_with_how_to_get_them) {
    for (const auto& [name, package, option] :
         {std::tuple{"cholmod", "libsuitesparse-dev", "POLYDEC_CHOLMOD"},
          std::tuple{"mumps", "libmumps-seq-dev", "POLYDEC_MUMPS"},
          std::tuple{"petsc.cg-hypre", "petsc-dev", "POLYDEC_PETSC"},
          std::tuple{"petsc.cg-gamg", "petsc-dev", "POLYDEC_PETSC"},
          std::tuple{"slepc", "slepc-dev", "POLYDEC_SLEPC"},
          std::tuple{"cvode", "libsundials-dev", "POLYDEC_CVODE"}}) {
        const auto info = info_of(name);
        EXPECT_EQ(info.name, name);
        EXPECT_FALSE(info.description.empty()) << name;
        EXPECT_NE(info.how_to_get.find(package), std::string::npos) << name;
        EXPECT_NE(info.how_to_get.find(option), std::string::npos) << name;
        if (info.available)
            continue;
        EXPECT_SAYS(message_of<BackendUnavailable>(
                        [&, called = std::string(name)] { make(info.kind, called); }),
                    "program", name, package);
    }
}

TEST(registry, unknown_names_are_answered_with_the_known_ones) {
    EXPECT_REFUSED(make_linear_solver("eigen.llt"), "linear solver", "eigen.llt", "auto");
    const std::string with_slepc = info_of("slepc").available ? "slepc, " : "";
    EXPECT_REFUSED(make_eigen_solver("arpack"), "eigensolver", "arpack",
                   "block-lanczos, " + with_slepc + "spectra");
}

TEST(registry, names_are_taken_once) {
    const auto factory = adapt<DenseLu>("registry.lu");
    register_engine("registry.lu", factory);
    EXPECT_REFUSED(register_engine("registry.lu", factory), "engine", "registry.lu",
                   "known already");
    // those that a module may bring, there or not
    EXPECT_REFUSED(register_engine("mumps", factory), "mumps", "known already");
    EXPECT_REFUSED(register_engine("slepc", [] { return nullptr; }), "slepc", "known already");
    EXPECT_REFUSED(register_engine("cvode", [](const IntegratorOptions&) { return nullptr; }),
                   "cvode", "known already");
    EXPECT_THROW(register_engine("auto", factory), InvalidInput);
    EXPECT_THROW(register_engine("", factory), InvalidInput);
    EXPECT_THROW(register_engine("registry.empty", LinearSolverFactory()), InvalidInput);
    EXPECT_THROW(register_engine("registry.empty", EigenSolverFactory()), InvalidInput);
    EXPECT_THROW(register_engine("registry.empty", IntegratorFactory()), InvalidInput);
}

TEST(registry, factories_that_make_nothing_are_an_error) {
    register_engine("registry.none", [](const LinearSolverOptions&) { return nullptr; });
    EXPECT_THROW(make_linear_solver("registry.none"), BackendUnavailable);
    register_engine("registry.none", [](const IntegratorOptions&) { return nullptr; });
    EXPECT_THROW(make_integrator("registry.none"), BackendUnavailable);
}

TEST(registry, threads_may_register_and_make_at_once) {
    std::vector<std::thread> threads;
    for (int t = 0; t < 4; ++t)
        threads.emplace_back([t] {
            const std::string name = "registry.thread" + std::to_string(t);
            register_engine(name, adapt<DenseLu>(name));
            for (int i = 0; i < 50; ++i)
                make_linear_solver(name);
        });
    for (auto& thread : threads)
        thread.join();
    const auto known = engines();
    EXPECT_EQ(
        std::count_if(known.begin(), known.end(),
                      [](const auto& engine) { return engine.name.find("registry.thread") == 0; }),
        4);
}

} // namespace polydec::test::in_registry
