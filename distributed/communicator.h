// SPDX-License-Identifier: MIT
#pragma once

#include "base/progress.h"
#include "distributed/ranks.h"

#include <mpi.h>

namespace polydec {

struct Ranks::State {
    MPI_Comm communicator;
    MPI_Comm after_errors; ///< free of pending operations that an error has skipped
    int rank, size;
    std::int64_t bytes_sent = 0;
    Progress listener = {};
};

} // namespace polydec
