// SPDX-License-Identifier: MIT
#include "backends/engine_module.h"
#include "backends/linear/adapt.h"
#include "backends/registry.h"

#include <Eigen/SparseCholesky>

#include <cstdlib>

namespace {

using ColumnMatrix = Eigen::SparseMatrix<double, Eigen::ColMajor, polydec::Index>;

/// Registered as the file is loaded, like the engines of a linked component.
[[maybe_unused]] const bool is_registered = [] {
    polydec::register_engine(
        "registered-as-loaded",
        polydec::adapt<Eigen::SimplicialLLT<ColumnMatrix>>(
            "registered-as-loaded", {.symmetry = polydec::Symmetry::symmetric,
                                     .definiteness = polydec::Definiteness::positive}));
    return true;
}();

} // namespace

int polydec_engine_module_version() {
    return 0;
}

void polydec_register_engines(polydec::EngineRegistrar&) {
    std::abort();
}
