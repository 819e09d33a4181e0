// SPDX-License-Identifier: MIT
#pragma once

#include "distributed/ranks.h"

#include <mpi.h>

namespace polydec {

struct Ranks::State {
    MPI_Comm communicator;
    int rank, size;
    std::function<void(std::string_view)> listener = {};
};

} // namespace polydec
