// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <csignal>

namespace polydec::tools {

/// During its lifetime, SIGINT (Ctrl-C) and SIGTERM request a stop instead of ending the program,
/// so that work can be saved first. A second signal ends it. Only one object may exist at a time.
class StopSignals {
public:
    StopSignals();
    ~StopSignals();
    StopSignals(const StopSignals&) = delete;
    StopSignals& operator=(const StopSignals&) = delete;

    /// Whether a signal has arrived.
    bool asked() const;

    /// Ends the program by this signal, as by default.
    void end() const;

private:
    static void ask(int signal);

    static constexpr std::array signals{SIGINT, SIGTERM};
};

} // namespace polydec::tools
