// SPDX-License-Identifier: MIT
#include "system/held_signals.h"

#include "system/unfinished.h"

#include <pthread.h>

namespace polydec {

namespace {

/// A signal that is ignored would wait all the same once it is blocked.
bool is_ignored(int signal) {
    struct sigaction action {};
    return ::sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

} // namespace

HeldSignals::HeldSignals() noexcept {
    sigemptyset(&held_);
    for (const int signal : ending_signals)
        if (!is_ignored(signal))
            sigaddset(&held_, signal);
    ::pthread_sigmask(SIG_BLOCK, &held_, &before_);
}

HeldSignals::~HeldSignals() {
    ::pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

bool HeldSignals::arrived() const noexcept {
    sigset_t waiting;
    sigemptyset(&waiting);
    ::sigpending(&waiting);
    for (const int signal : ending_signals)
        if (sigismember(&held_, signal) == 1 && sigismember(&waiting, signal) == 1)
            return true;
    return false;
}

} // namespace polydec
