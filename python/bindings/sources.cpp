// SPDX-License-Identifier: MIT
#include "python/bindings/calculus.h"
#include "python/bindings/convert.h"
#include "python/bindings/guarded.h"
#include "solvers/hodge_laplace.h"

namespace polydec::python {

namespace {

void add_forms_with_sources(py::module_& module) {
    using Solver = Guarded<HodgeLaplaceSolver>;
    py::class_<Solver>(module, "HodgeLaplaceSolver")
        .def(py::init([](const Cells& of, const std::string& side, int degree,
                         const BoundaryConditions& conditions, const std::string& engine) {
            return guarded<HodgeLaplaceSolver>(space_of(of, side, degree, conditions), engine);
        }))
        .def("solve",
             [](Solver& self, const std::string& side, int degree, const Numbers& f,
                const GivenBoundary& data, const Numbers& harmonic) {
                 FormSolution found =
                     self.use([&, given = form(side, degree, f), known = boundary_forms(data),
                               part = vector(harmonic)](const HodgeLaplaceSolver& solver) {
                         return solver.solve(given, known, part);
                     });
                 return py::make_tuple(parts(std::move(found.form)), parts(std::move(found.beside)),
                                       parts(std::move(found.removed)), report_of(found.report));
             })
        .def("solve_curl_curl",
             [](Solver& self, const std::string& side, int degree, const Numbers& current,
                const GivenBoundary& data) {
                 CurlCurlSolution found =
                     self.use([&, given = form(side, degree, current),
                               known = boundary_forms(data)](const HodgeLaplaceSolver& solver) {
                         return solve_curl_curl(solver, given, known);
                     });
                 return py::make_tuple(parts(std::move(found.potential)),
                                       parts(std::move(found.removed)), report_of(found.report));
             })
        .def("harmonic_forms", [](Solver& self) {
            return array(
                self.use([](const HodgeLaplaceSolver& solver) { return solver.harmonic_forms(); }));
        });
}

} // namespace

void add_sources(py::module_& module) {
    add_forms_with_sources(module);
    module.def("outward_flow",
               [](const Discretization& mesh, const std::string& side, const Numbers& derivatives) {
                   return array(unlocked([&, on = side_of(side), given = vector(derivatives)] {
                       return outward_flow(mesh, on, given);
                   }));
               });
}

} // namespace polydec::python
