// SPDX-License-Identifier: MIT
#include "backends/engine_module.h"
#include "backends/linear/adapt.h"

#include <Eigen/SparseCholesky>

namespace {

using ColumnMatrix = Eigen::SparseMatrix<double, Eigen::ColMajor, polydec::Index>;

} // namespace

int polydec_engine_module_version() {
    return polydec::engine_module_version;
}

void polydec_register_engines(polydec::EngineRegistrar& registrar) {
    registrar.add(
        {.name = "module.llt", .description = "an engine from a module", .how_to_get = "load it"},
        polydec::adapt<Eigen::SimplicialLLT<ColumnMatrix>>(
            "module.llt", {.symmetry = polydec::Symmetry::symmetric,
                           .definiteness = polydec::Definiteness::positive}));
}
