// SPDX-License-Identifier: MIT
#include "backends/registry.h"

#include "backends/adapt.h"
#include "base/errors.h"
#include "tests/backends/matrices.h"

#include <Eigen/SparseLU>
#include <gtest/gtest.h>

#include <algorithm>
#include <thread>

namespace polydec::test {
namespace {

using ColumnMatrix = Eigen::SparseMatrix<double, Eigen::ColMajor, Index>;

EngineInfo info_of(const std::string& name) {
    for (const auto& engine : engines())
        if (engine.name == name)
            return engine;
    return {};
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
}

TEST(registry, missing_engines_are_listed_with_how_to_get_them) {
    const auto cholmod = info_of("cholmod");
    EXPECT_EQ(cholmod.name, "cholmod");
    EXPECT_EQ(cholmod.available, has_linear_solver("cholmod"));
    EXPECT_FALSE(cholmod.description.empty());
    EXPECT_NE(cholmod.how_to_get.find("libsuitesparse-dev"), std::string::npos);
    EXPECT_NE(cholmod.how_to_get.find("POLYDEC_CHOLMOD"), std::string::npos);
    if (cholmod.available)
        return;
    const auto message = message_of<BackendUnavailable>([] { make_linear_solver("cholmod"); });
    EXPECT_EQ(message.find("the linear solver `cholmod` is not part of this program\nTo get it: "),
              0u);
}

TEST(registry, unknown_names_are_answered_with_the_known_ones) {
    const auto message = message_of<InvalidInput>([] { make_linear_solver("eigen.llt"); });
    EXPECT_EQ(message.find("there is no linear solver called `eigen.llt`\nKnown are: auto, "), 0u)
        << message;
    EXPECT_EQ(message_of<InvalidInput>([] { make_eigen_solver("arpack"); }),
              "there is no eigensolver called `arpack`\nKnown are: spectra.");
}

TEST(registry, names_are_taken_once) {
    const auto factory = adapt<Eigen::SparseLU<ColumnMatrix>>("registry.lu");
    register_linear_solver("registry.lu", factory);
    EXPECT_EQ(message_of<InvalidInput>([&] { register_linear_solver("registry.lu", factory); }),
              "an engine called `registry.lu` is registered already");
    EXPECT_THROW(register_linear_solver("auto", factory), InvalidInput);
    EXPECT_THROW(register_linear_solver("", factory), InvalidInput);
    EXPECT_THROW(register_linear_solver("registry.empty", {}), InvalidInput);
    EXPECT_THROW(register_eigen_solver("registry.empty", {}), InvalidInput);
}

TEST(registry, factories_that_make_nothing_are_an_error) {
    register_linear_solver("registry.none", [](const LinearSolverOptions&) { return nullptr; });
    EXPECT_THROW(make_linear_solver("registry.none"), BackendUnavailable);
}

TEST(registry, threads_may_register_and_make_at_once) {
    std::vector<std::thread> threads;
    for (int t = 0; t < 4; ++t)
        threads.emplace_back([t] {
            const std::string name = "registry.thread" + std::to_string(t);
            register_linear_solver(name, adapt<Eigen::SparseLU<ColumnMatrix>>(name));
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

} // namespace
} // namespace polydec::test
