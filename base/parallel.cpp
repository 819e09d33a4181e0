// SPDX-License-Identifier: MIT
#include "base/parallel.h"

#ifdef _OPENMP
#include <omp.h>
#endif

#include <algorithm>
#include <exception>
#include <vector>

namespace polydec {

void for_each_part(Index count, Index size, const std::function<void(Index, Index)>& work) {
    const Index parts = count / size + (count % size > 0 ? 1 : 0);
    if (parts == 1)
        return work(0, count);
    std::vector<std::exception_ptr> thrown(static_cast<std::size_t>(parts));
#ifdef _OPENMP
#pragma omp parallel for schedule(dynamic)
#endif
    for (Index part = 0; part < parts; ++part) {
        try {
            const Index begin = part * size;
            work(begin, begin + std::min(size, count - begin));
        } catch (...) {
            thrown[static_cast<std::size_t>(part)] = std::current_exception();
        }
    }
    for (const auto& exception : thrown)
        if (exception)
            std::rethrow_exception(exception);
}

void use_one_thread() {
#ifdef _OPENMP
    omp_set_num_threads(1);
#endif
}

} // namespace polydec
