// SPDX-License-Identifier: MIT
#include "shape/shape.h"

#include "python/bindings/calculus.h"
#include "python/bindings/convert.h"
#include "shape/flipped.h"
#include "shape/shape_spectrum.h"

namespace polydec::python {

namespace {

FlippedShape shape_from(const Discretization& mesh, const GivenConditions& conditions,
                        const CellData& conductivity, const CellData& density, bool flips) {
    const Shape shape =
        shape_of(mesh, conditions.value_or(BoundaryConditions{BoundaryCondition::natural}),
                 conductivity, density);
    return flips ? flipped(shape) : FlippedShape{shape};
}

py::dict shape_spectrum_of(const Discretization& mesh, const GivenConditions& conditions,
                           const CellData& conductivity, const CellData& density, bool flips,
                           int degree, Index count, int level, double width, Index max_triangles,
                           const std::string& linear_solver, const std::string& eigen_solver,
                           const py::object& progress) {
    ShapeSpectrumOptions options;
    options.degree = degree;
    options.count = count;
    options.level = level;
    options.width = width;
    options.max_triangles = max_triangles;
    options.linear_solver = linear_solver;
    options.eigen_solver = eigen_solver;
    options.progress = listener(progress);
    Index flip_count = 0;
    ShapeSpectrum found = unlocked([&] {
        const auto shape = shape_from(mesh, conditions, conductivity, density, flips);
        flip_count = shape.flips;
        return shape_spectrum(shape.shape, options);
    });
    warn(found.warnings);
    return py::dict(py::arg("lower") = array(std::move(found.lower)),
                    py::arg("upper") = array(std::move(found.upper)),
                    py::arg("zeros") = found.zeros, py::arg("count_at") = found.count_at,
                    py::arg("count") = py::make_tuple(found.count.at_least, found.count.at_most),
                    py::arg("modes") = array(std::move(found.modes)),
                    py::arg("simplices") = found.simplices, py::arg("flips") = flip_count,
                    py::arg("factorizations") = found.factorizations);
}

py::tuple count_of(const Discretization& mesh, const GivenConditions& conditions,
                   const CellData& conductivity, const CellData& density, bool flips, double s,
                   int degree, int level, const std::string& linear_solver) {
    const CountBelow count = unlocked([&] {
        const auto shape = shape_from(mesh, conditions, conductivity, density, flips);
        return count_below(shape.shape, s,
                           {.degree = degree, .level = level, .linear_solver = linear_solver});
    });
    warn(count.warnings);
    return py::make_tuple(count.at_least, count.at_most);
}

} // namespace

void add_shape(py::module_& module) {
    module.def("shape_spectrum", &shape_spectrum_of);
    module.def("count_below", &count_of);
}

} // namespace polydec::python
