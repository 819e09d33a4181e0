// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <csignal>

namespace polydec::tools {

/// While it lives, SIGINT (Ctrl-C) and SIGTERM do not end the program but ask it to: for work that
/// has something to keep first. Given again, they end it. There is one at a time.
class StopSignals {
public:
    StopSignals();
    ~StopSignals();
    StopSignals(const StopSignals&) = delete;
    StopSignals& operator=(const StopSignals&) = delete;

    /// Whether one has come.
    bool asked() const;

    /// Ends the program by it, as it would have.
    void end() const;

private:
    static void ask(int signal);

    static constexpr std::array signals{SIGINT, SIGTERM};
};

} // namespace polydec::tools
