// SPDX-License-Identifier: MIT
#include "examples/paper/process.h"

#include "system/held_signals.h"
#include "tests/support/test.h"

#include <pthread.h>
#include <thread>
#include <unistd.h>

namespace polydec::paper::in_process {

constexpr int was_held = 42;

/// A signal comes to another thread, as the system may choose; one of those that are there before
/// the main thread holds signals.
void signal_to_another_thread() {
    std::thread([] {
        sigset_t none;
        sigemptyset(&none);
        ::pthread_sigmask(SIG_SETMASK, &none, nullptr);
        ::pthread_kill(::pthread_self(), SIGTERM);
    }).join();
}

int work_that_holds_signals(int, char**) {
    const HeldSignals held;
    signal_to_another_thread();
    ::_exit(held.arrived() ? was_held : 0);
}

int work_that_goes_on(int, char**) {
    for (;;)
        signal_to_another_thread();
}

TEST(Process, SignalsToOtherThreadsWaitWhileTheMainThreadHoldsThem) {
    EXPECT_EXIT(run_process("test", work_that_holds_signals, 0, nullptr),
                testing::ExitedWithCode(was_held), "");
}

TEST(Process, SignalsToOtherThreadsEndTheProgram) {
    EXPECT_EXIT(run_process("test", work_that_goes_on, 0, nullptr),
                testing::KilledBySignal(SIGTERM), "");
}

} // namespace polydec::paper::in_process
