// SPDX-License-Identifier: MIT
#include "python/bindings/calculus.h"
#include "python/bindings/convert.h"
#include "python/bindings/guarded.h"
#include "solvers/sources/poisson.h"

namespace polydec::python {

namespace {

py::dict in_words(const SolveReport& report, const Compatibility& compatibility) {
    py::dict result = report_of(report);
    result["free_components"] = compatibility.free_components;
    result["incompatible"] = compatibility.worst;
    return result;
}

void add_poisson(py::module_& module) {
    using Solver = Guarded<PoissonSolver>;
    py::class_<Solver>(module, "PoissonSolver")
        .def(py::init([](const FormSpace& space, const std::string& engine) {
            return guarded<PoissonSolver>(space, engine);
        }))
        .def("solve",
             [](Solver& self, const Cochain& f, const BoundaryForms& data, const Vector& harmonic) {
                 PoissonSolution found = self.use(
                     [&](const PoissonSolver& solver) { return solver.solve(f, data, harmonic); });
                 warn(found.warnings);
                 return py::make_tuple(std::move(found.form), std::move(found.flux),
                                       std::move(found.removed),
                                       in_words(found.report, found.compatibility));
             })
        .def("solve_curl_curl",
             [](Solver& self, const Cochain& current, const BoundaryForms& data) {
                 CurlCurlSolution found = self.use([&](const PoissonSolver& solver) {
                     return solve_curl_curl(solver, current, data);
                 });
                 return py::make_tuple(std::move(found.potential), std::move(found.removed),
                                       report_of(found.report));
             })
        .def("harmonic_forms", [](Solver& self) {
            return self.use([](const PoissonSolver& solver) { return solver.harmonic_forms(); });
        });
}

} // namespace

void add_sources(py::module_& module) {
    add_poisson(module);
    module.def("outward_flow", &outward_flow, Unlocking());
}

} // namespace polydec::python
