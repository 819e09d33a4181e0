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
        .def(py::init([](const Cells& of, const std::string& side, int degree,
                         const BoundaryConditions& conditions, const std::string& engine) {
            return guarded<PoissonSolver>(space_of(of, side, degree, conditions), engine);
        }))
        .def("solve",
             [](Solver& self, const std::string& side, int degree, const Numbers& f,
                const GivenBoundary& data, const Numbers& harmonic) {
                 PoissonSolution found =
                     self.use([&, given = form(side, degree, f), known = boundary_forms(data),
                               part = vector(harmonic)](const PoissonSolver& solver) {
                         return solver.solve(given, known, part);
                     });
                 warn(found.warnings);
                 return py::make_tuple(parts(std::move(found.form)), parts(std::move(found.flux)),
                                       parts(std::move(found.removed)),
                                       in_words(found.report, found.compatibility));
             })
        .def("solve_curl_curl",
             [](Solver& self, const std::string& side, int degree, const Numbers& current,
                const GivenBoundary& data) {
                 CurlCurlSolution found =
                     self.use([&, given = form(side, degree, current),
                               known = boundary_forms(data)](const PoissonSolver& solver) {
                         return solve_curl_curl(solver, given, known);
                     });
                 return py::make_tuple(parts(std::move(found.potential)),
                                       parts(std::move(found.removed)), report_of(found.report));
             })
        .def("harmonic_forms", [](Solver& self) {
            return array(
                self.use([](const PoissonSolver& solver) { return solver.harmonic_forms(); }));
        });
}

} // namespace

void add_sources(py::module_& module) {
    add_poisson(module);
    module.def("outward_flow",
               [](const Cells& cells, const std::string& side, const Numbers& derivatives) {
                   return array(unlocked([&, on = side_of(side), given = vector(derivatives)] {
                       return outward_flow(cells, on, given);
                   }));
               });
}

} // namespace polydec::python
