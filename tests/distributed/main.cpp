// SPDX-License-Identifier: MIT
#include "distributed/ranks.h"
#include "tests/support/test.h"

#include <iostream>
#include <unistd.h>

namespace {

/// Ends this rank, naming the test, when a test exceeds its time limit; mpirun then ends all ranks.
class Watchdog {
public:
    Watchdog() {
        if (const char* told = std::getenv("POLYDEC_TEST_PATIENCE"))
            seconds_ *= std::atof(told);
        if (std::getenv("POLYDEC_TEST_SEEDS") != nullptr) // many random meshes take their time
            seconds_ *= 60;
        std::signal(SIGALRM, bark);
    }

    void watch(const testing::TestInfo& test) {
        message_ = fmt::format("rank {}: {}.{} exceeds its time limit of {} s\n",
                               polydec::Ranks::all().rank(), test.test_suite_name(), test.name(),
                               seconds_);
        alarm(static_cast<unsigned>(seconds_) + 1);
    }

    void rest() { alarm(0); }

private:
    /// Calls only async-signal-safe functions.
    static void bark(int) {
        if (write(STDERR_FILENO, message_.data(), message_.size()) >= 0)
            _exit(1);
        _exit(2);
    }

    double seconds_ = 60;
    static inline std::string message_;
};

/// Fails on every rank where a test failed on one, so that all go on with the same one.
class SameEverywhere : public testing::EmptyTestEventListener {
    void OnTestStart(const testing::TestInfo& test) override { watchdog_.watch(test); }
    void OnTestPartResult(const testing::TestPartResult& part) override {
        if (part.failed())
            std::cerr << fmt::format("rank {}: {}\n", polydec::Ranks::all().rank(), part.message());
    }
    void OnTestEnd(const testing::TestInfo& test) override {
        const bool failed = test.result()->Failed();
        if (polydec::Ranks::all().any(failed) && !failed) {
            ADD_FAILURE() << "failed on another rank";
        }
        watchdog_.rest();
    }
    Watchdog watchdog_;
};

} // namespace

int main(int count, char** words) {
    testing::InitGoogleTest(&count, words);
    const auto ranks = polydec::Ranks::all();
    auto& listeners = testing::UnitTest::GetInstance()->listeners();
    if (ranks.rank() != 0)
        delete listeners.Release(listeners.default_result_printer());
    listeners.Append(new SameEverywhere);
    const int result = RUN_ALL_TESTS();
    return ranks.any(result != 0) ? 1 : 0;
}
