// SPDX-License-Identifier: MIT
#include "python/bindings/calculus.h"
#include "python/bindings/convert.h"
#include "python/bindings/guarded.h"
#include "solvers/hodge_laplace.h"

namespace polydec::python {

namespace {

/// A solver of Delta u = f, and the cells that it is for.
struct FormSolver {
    CellComplex complex;
    HodgeLaplaceSolver solver;
};

std::unique_ptr<Guarded<FormSolver>> form_solver(const Cells& of, const std::string& side,
                                                 int degree, const BoundaryConditions& conditions,
                                                 const std::string& engine) {
    const HodgeLaplaceOptions options{side_of(side), degree, conditions, engine};
    return unlocked([&] {
        return std::make_unique<Guarded<FormSolver>>(
            FormSolver{of.complex(), HodgeLaplaceSolver(of, options)});
    });
}

void add_forms_with_sources(py::module_& module) {
    using Solver = Guarded<FormSolver>;
    py::class_<Solver>(module, "HodgeLaplaceSolver")
        .def(py::init(&form_solver))
        .def("solve",
             [](Solver& self, const std::string& side, int degree, const Numbers& f,
                const GivenBoundary& data, const Numbers& harmonic) {
                 FormSolution found =
                     self.use([&, given = form(side, degree, f), known = boundary_forms(data),
                               part = vector(harmonic)](const FormSolver& of) {
                         return of.solver.solve(given, known, part);
                     });
                 return py::make_tuple(parts(std::move(found.form)), parts(std::move(found.beside)),
                                       parts(std::move(found.removed)), report_of(found.report));
             })
        .def("solve_curl_curl",
             [](Solver& self, const std::string& side, int degree, const Numbers& current,
                const GivenBoundary& data) {
                 CurlCurlSolution found =
                     self.use([&, given = form(side, degree, current),
                               known = boundary_forms(data)](const FormSolver& of) {
                         return solve_curl_curl(of.solver, of.complex, given, known);
                     });
                 return py::make_tuple(parts(std::move(found.potential)),
                                       parts(std::move(found.removed)), report_of(found.report));
             })
        .def("harmonic_forms", [](Solver& self) {
            return array(self.use([](const FormSolver& of) { return of.solver.harmonic_forms(); }));
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
