// SPDX-License-Identifier: MIT
#include "python/bindings/convert.h"
#include "python/bindings/guarded.h"
#include "solvers/sources/hodge.h"
#include "solvers/sources/poisson.h"
#include "solvers/surfaces/geodesic_distance.h"
#include "solvers/surfaces/parallel_transport.h"

namespace polydec::python {

namespace {

void add_hodge(py::module_& module) {
    using Solver = Guarded<HodgeSolver>;
    py::class_<Solver>(module, "HodgeSolver")
        .def(py::init([](const FormSpace& space, const std::string& engine) {
            return guarded<HodgeSolver>(space, engine);
        }))
        .def("decompose",
             [](Solver& self, const Cochain& form) {
                 HodgeParts found =
                     self.use([&](const HodgeSolver& solver) { return solver.decompose(form); });
                 return py::make_tuple(std::move(found.exact), std::move(found.coexact),
                                       std::move(found.harmonic), std::move(found.potential),
                                       std::move(found.copotential));
             })
        .def("harmonic_forms", [](Solver& self) {
            return self.use([](const HodgeSolver& solver) { return solver.harmonic_forms(); });
        });
}

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

void add_distance(py::module_& module) {
    using Solver = Guarded<GeodesicDistance>;
    py::class_<Solver>(module, "GeodesicDistance")
        .def(py::init([](const Discretization& mesh, const std::string& method, double time_scale,
                         const std::string& engine) {
            const auto by =
                chosen<DistanceMethod>("method", method,
                                       {{name(DistanceMethod::exact), DistanceMethod::exact},
                                        {name(DistanceMethod::heat), DistanceMethod::heat}});
            return guarded<GeodesicDistance>(
                mesh, GeodesicOptions{by, time_scale, engine, listener(py::none())});
        }))
        .def("to", [](Solver& self, const std::vector<Index>& sources) {
            Distance found =
                self.use([&](const GeodesicDistance& distance) { return distance.to(sources); });
            warn(found.warnings);
            return std::move(found.values);
        });
}

/// Segments as pairs of points: rows of their beginnings, and of their ends.
std::pair<Points, Points> ends_of(const Mesh& lines) {
    const auto ends = [&](int which) {
        return lines.points(lines.simplices.col(which), Eigen::indexing::all);
    };
    return {ends(0), ends(1)};
}

void add_paths(py::module_& module) {
    using Paths = Guarded<SurfacePaths>;
    py::class_<Paths>(module, "SurfacePaths")
        .def(py::init([](const Discretization& mesh, const std::vector<Index>& sources) {
            return guarded<SurfacePaths>(mesh, sources, listener(py::none()));
        }))
        .def("path",
             [](Paths& self, Index vertex) {
                 const auto path =
                     self.use([&](const SurfacePaths& paths) { return paths.from(vertex); });
                 return py::make_tuple(path.source, path.length, ends_of(path.lines));
             })
        .def("isolines", [](Paths& self, const Vector& levels, Index divisions) {
            const auto lines = self.use(
                [&](const SurfacePaths& paths) { return paths.isolines(levels, divisions); });
            return py::make_tuple(ends_of(lines.mesh), lines.levels);
        });
}

/// The edge of each vertex from which angles are measured: the vertices that it leads from and to.
Simplices reference_edges(const GluedSurface& surface, const TangentFrames& frames) {
    Simplices ends(surface.vertices(), 2);
    for (Index v = 0; v < surface.vertices(); ++v)
        ends.row(v) << v, surface.head(frames.reference[v]);
    return ends;
}

void add_transport(py::module_& module) {
    using Solver = Guarded<ParallelTransport>;
    py::class_<Solver>(module, "ParallelTransport")
        .def(py::init([](const Discretization& mesh, double time_scale, const std::string& engine) {
            return guarded<ParallelTransport>(GluedSurface(mesh.pieces()),
                                              mesh.geometry().volumes().primal(1),
                                              TransportOptions{time_scale, engine});
        }))
        .def("reference",
             [](const Solver& self, const Discretization& mesh) {
                 return reference_edges(GluedSurface(mesh.pieces()), self.solver.frames());
             })
        .def("extend", [](Solver& self, const std::vector<Index>& sources, const Vector& real,
                          const Vector& imaginary) {
            TangentVectors given(real.size());
            given.real() = real;
            given.imag() = imaginary;
            const TangentVectors found = self.use([&](const ParallelTransport& transport) {
                return transport.extend(sources, given);
            });
            return std::pair(Vector(found.real()), Vector(found.imag()));
        });
}

} // namespace

void add_solvers(py::module_& module) {
    add_hodge(module);
    add_poisson(module);
    add_distance(module);
    add_paths(module);
    add_transport(module);
    module.def("outward_flow", &outward_flow, Unlocking());
}

} // namespace polydec::python
