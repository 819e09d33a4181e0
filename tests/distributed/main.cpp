// SPDX-License-Identifier: MIT
#include "distributed/ranks.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <iostream>
#include <unistd.h>

namespace {

/// Fails on every rank where a test failed on one, so that all go on with the same one.
class SameEverywhere : public testing::EmptyTestEventListener {
    void OnTestStart(const testing::TestInfo&) override {
        if (std::getenv("POLYDEC_TEST_SEEDS") == nullptr) // many random meshes take their time
            alarm(watchdog);
    }
    void OnTestPartResult(const testing::TestPartResult& part) override {
        if (part.failed())
            std::cerr << fmt::format("rank {}: {}\n", polydec::Ranks::all().rank(), part.message());
    }
    void OnTestEnd(const testing::TestInfo& test) override {
        const bool failed = test.result()->Failed();
        if (polydec::Ranks::all().any(failed) && !failed)
            ADD_FAILURE() << "failed on another rank";
        alarm(0);
    }
    static constexpr unsigned watchdog = 60; // seconds, after which a test counts as hanging
};

} // namespace

int main(int count, char** words) {
    testing::InitGoogleTest(&count, words);
    const auto ranks = polydec::Ranks::all();
    std::signal(SIGALRM, SIG_DFL);
    auto& listeners = testing::UnitTest::GetInstance()->listeners();
    if (ranks.rank() != 0)
        delete listeners.Release(listeners.default_result_printer());
    listeners.Append(new SameEverywhere);
    const int result = RUN_ALL_TESTS();
    return ranks.any(result != 0) ? 1 : 0;
}
