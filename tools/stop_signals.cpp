// SPDX-License-Identifier: MIT
#include "tools/stop_signals.h"

#include <atomic>

namespace polydec::tools {

namespace {

std::atomic<int> came{0};
static_assert(std::atomic<int>::is_always_lock_free, "needed in signal handlers");

struct sigaction before[2];

} // namespace

void StopSignals::ask(int signal) {
    came = signal;
    for (std::size_t i = 0; i < signals.size(); ++i)
        ::sigaction(signals[i], &before[i], nullptr);
}

StopSignals::StopSignals() {
    came = 0;
    struct sigaction action {};
    action.sa_handler = &ask;
    action.sa_flags = SA_RESTART;
    sigfillset(&action.sa_mask);
    for (std::size_t i = 0; i < signals.size(); ++i) {
        ::sigaction(signals[i], nullptr, &before[i]);
        if (before[i].sa_handler != SIG_IGN)
            ::sigaction(signals[i], &action, nullptr);
    }
}

StopSignals::~StopSignals() {
    for (std::size_t i = 0; i < signals.size(); ++i)
        ::sigaction(signals[i], &before[i], nullptr);
}

bool StopSignals::asked() const {
    return came != 0;
}

void StopSignals::end() const {
    ::raise(came);
}

} // namespace polydec::tools
