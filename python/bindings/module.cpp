// SPDX-License-Identifier: MIT
#include "python/bindings/convert.h"

PYBIND11_MODULE(_core, module) {
    using namespace polydec::python;
    module.doc() = "Implementation of the package polydec; use the package.";
    module.attr("__version__") = POLYDEC_VERSION;
    add_errors(module);
    add_meshes(module);
    add_calculus(module);
    add_discretization(module);
    add_fields(module);
    add_pages(module);
    add_solvers(module);
    add_in_time(module);
    add_flows(module);
    add_shape(module);
    add_spectra(module);
    add_engines(module);
}
