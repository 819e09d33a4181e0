// SPDX-License-Identifier: MIT
#include "backends/engine_module.h"

#include "base/errors.h"
#include "tests/backends/matrices.h"

#include <gtest/gtest.h>

namespace polydec::test {
namespace {

TEST(engine_module, a_module_registers_its_engines_once) {
    EXPECT_FALSE(has_linear_solver("module.llt"));
    load_engine_module(POLYDEC_TEST_GOOD_MODULE);
    load_engine_module(POLYDEC_TEST_GOOD_MODULE);
    ASSERT_TRUE(has_linear_solver("module.llt"));

    const auto solver = make_linear_solver("module.llt");
    const auto A = grid_laplacian(6);
    const DenseMatrix B = random_matrix(36, 2, 1);
    solver->factorize(A, positive());
    EXPECT_PRED3(solves, A, solver->solve(B), B);
    EXPECT_EQ(solver->report().engine, "module.llt");
}

TEST(engine_module, errors_cross_the_border_of_a_module) {
    load_engine_module(POLYDEC_TEST_GOOD_MODULE);
    const auto solver = make_linear_solver("module.llt");
    EXPECT_THROW(solver->factorize(grid_laplacian(3), general()), InvalidInput);
    EXPECT_THROW(solver->factorize(shifted(grid_laplacian(3), 9.0), positive()), SolverFailure);
}

TEST(engine_module, a_module_for_another_version_is_refused_before_it_runs) {
    const std::string path = POLYDEC_TEST_OLD_MODULE;
    EXPECT_EQ(message_of<BackendUnavailable>([&] { load_engine_module(path); }),
              path + ": is an engine module of version 0, and this polydec takes version 1\n"
                     "Build it against the headers of this polydec.");
}

TEST(engine_module, what_is_no_module_is_refused) {
    EXPECT_THROW(load_engine_module("/nowhere/module.so"), IoError);
    EXPECT_THROW(load_engine_module("."), IoError);
    EXPECT_THROW(load_engine_module(POLYDEC_TEST_FILES "/golden/uv8.off"), IoError);
    const auto message =
        message_of<IoError>([] { load_engine_module("/lib/x86_64-linux-gnu/libm.so.6"); });
    EXPECT_NE(message.find("libm.so.6"), std::string::npos);
}

} // namespace
} // namespace polydec::test
