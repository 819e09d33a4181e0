// SPDX-License-Identifier: MIT
#include "python/bindings/calculus.h"
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
        .def(py::init([](const Cells& of, const std::string& side, int degree,
                         const GivenConditions& conditions, const std::string& engine) {
            return guarded<HodgeSolver>(space_of(of, side, degree, conditions), engine);
        }))
        .def("decompose",
             [](Solver& self, const std::string& side, int degree, const Numbers& values) {
                 const Cochain given = form(side, degree, values);
                 HodgeParts found =
                     self.use([&](const HodgeSolver& solver) { return solver.decompose(given); });
                 return py::make_tuple(
                     parts(std::move(found.exact)), parts(std::move(found.coexact)),
                     parts(std::move(found.harmonic)), parts(std::move(found.potential)),
                     parts(std::move(found.copotential)));
             })
        .def("harmonic_forms", [](Solver& self) {
            return array(
                self.use([](const HodgeSolver& solver) { return solver.harmonic_forms(); }));
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
            return guarded<GeodesicDistance>(mesh, GeodesicOptions{by, time_scale, engine});
        }))
        .def("to", [](Solver& self, const Integers& sources) {
            Distance found =
                self.use([&, given = indices(sources)](const GeodesicDistance& distance) {
                    return distance.to(given);
                });
            warn(found.warnings);
            return py::make_tuple(array(std::move(found.values)), found.raised);
        });
}

/// Segments as pairs of points: rows of their beginnings, and of their ends.
py::tuple ends_of(const Mesh& lines) {
    std::array<Points, 2> ends;
    for (int end = 0; end < 2; ++end) {
        ends[end].resize(lines.simplices.rows(), lines.points.cols());
        for (Index i = 0; i < lines.simplices.rows(); ++i)
            ends[end].row(i) = lines.points.row(lines.simplices(i, end));
    }
    return py::make_tuple(array(std::move(ends[0])), array(std::move(ends[1])));
}

void add_paths(py::module_& module) {
    using Paths = Guarded<SurfacePaths>;
    py::class_<Paths>(module, "SurfacePaths")
        .def(py::init([](const Discretization& mesh, const Integers& sources) {
            return guarded<SurfacePaths>(mesh, indices(sources));
        }))
        .def("path",
             [](Paths& self, Index vertex) {
                 const auto path =
                     self.use([&](const SurfacePaths& paths) { return paths.from(vertex); });
                 return py::make_tuple(path.source, path.length, ends_of(path.lines));
             })
        .def("isolines", [](Paths& self, const Numbers& levels, Index divisions) {
            const auto lines = self.use([&, given = vector(levels)](const SurfacePaths& paths) {
                return paths.isolines(given, divisions);
            });
            return py::make_tuple(ends_of(lines.mesh), array(lines.levels));
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
                 return array(reference_edges(GluedSurface(mesh.pieces()), self.solver.frames()));
             })
        .def("extend", [](Solver& self, const Integers& sources, const Numbers& real,
                          const Numbers& imaginary) {
            TangentVectors given(static_cast<Eigen::Index>(real.size()));
            given.real() = vector(real);
            given.imag() = vector(imaginary);
            const TangentVectors found =
                self.use([&, from = indices(sources)](const ParallelTransport& transport) {
                    return transport.extend(from, given);
                });
            return py::make_tuple(array(Vector(found.real())), array(Vector(found.imag())));
        });
}

} // namespace

void add_solvers(py::module_& module) {
    add_hodge(module);
    add_distance(module);
    add_paths(module);
    add_transport(module);
}

} // namespace polydec::python
