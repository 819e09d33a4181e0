// SPDX-License-Identifier: MIT
#pragma once

#include "backends/linear/petsc_session.h"

#include <slepceps.h>

namespace polydec::petsc {

inline void end_slepc() {
    if (is_running() && SlepcInitializeCalled)
        SlepcFinalize();
}

/// Starts SLEPc unless it is running; it ends at program exit, before PETSc.
inline void start_slepc(const Session& session) {
    if (SlepcInitializeCalled)
        return;
    session.require(SlepcInitialize(nullptr, nullptr, nullptr, nullptr), "starting SLEPc");
    at_exit(end_slepc);
}

} // namespace polydec::petsc
