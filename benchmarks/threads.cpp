// SPDX-License-Identifier: MIT
#include "benchmarks/threads.h"

#ifdef POLYDEC_HAS_OPENMP
#include <omp.h>
#endif

namespace polydec::benchmarks {

#ifdef POLYDEC_HAS_OPENMP

bool has_threads() {
    return true;
}

void set_threads(int count) {
    omp_set_dynamic(0);
    omp_set_num_threads(count);
}

#else

bool has_threads() {
    return false;
}

void set_threads(int) {}

#endif

} // namespace polydec::benchmarks
