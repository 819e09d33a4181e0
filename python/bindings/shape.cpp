// SPDX-License-Identifier: MIT
#include "shape/shape.h"

#include "dec/boundary/form_space.h"
#include "python/bindings/convert.h"
#include "shape/poisson_error.h"
#include "shape/shape_spectrum.h"

namespace polydec::python {

namespace {

FlippedShape shape_from(const Discretization& mesh, const FormSpace& space,
                        const CellData& conductivity, const CellData& density, bool flips) {
    const Shape shape = shape_of(mesh, space.conditions(), conductivity, density);
    return flips ? flipped(shape) : FlippedShape{shape};
}

py::dict shape_spectrum_of(const Discretization& mesh, const FormSpace& space,
                           const CellData& conductivity, const CellData& density, bool flips,
                           int degree, Index count, int level, double width, Index max_triangles,
                           const std::string& linear_solver, const std::string& eigen_solver,
                           const py::object& progress) {
    const ShapeSpectrumOptions options{
        degree,        count,         level,        width,
        max_triangles, linear_solver, eigen_solver, listener(progress)};
    Index flip_count = 0;
    ShapeSpectrum found = unlocked([&] {
        const auto shape = shape_from(mesh, space, conductivity, density, flips);
        flip_count = shape.flips;
        return shape_spectrum(shape.shape, options);
    });
    warn(found.warnings);
    return py::dict(
        py::arg("lower") = std::move(found.lower), py::arg("upper") = std::move(found.upper),
        py::arg("zeros") = found.zeros, py::arg("count_at") = found.count_at,
        py::arg("count") = py::make_tuple(found.count.at_least, found.count.at_most),
        py::arg("modes") = std::move(found.modes), py::arg("simplices") = found.simplices,
        py::arg("flips") = flip_count, py::arg("factorizations") = found.factorizations);
}

py::tuple count_of(const Discretization& mesh, const FormSpace& space, const CellData& conductivity,
                   const CellData& density, bool flips, double s, int degree, int level,
                   const std::string& linear_solver) {
    const CountBelow count = unlocked([&] {
        const auto shape = shape_from(mesh, space, conductivity, density, flips);
        return count_below(shape.shape, s,
                           {.degree = degree, .level = level, .linear_solver = linear_solver});
    });
    warn(count.warnings);
    return py::make_tuple(count.at_least, count.at_most);
}

py::dict error_of(const Discretization& mesh, const FormSpace& space, const CellData& conductivity,
                  const Vector& f, const Vector& flux, const Vector& u, Index l2_limit,
                  const std::string& linear_solver) {
    PoissonError error = unlocked([&] {
        return poisson_error(poisson_problem(mesh, space.conditions(), conductivity, f, flux), u,
                             {.l2_limit = l2_limit, .linear_solver = linear_solver});
    });
    warn(error.warnings);
    return py::dict(py::arg("energy") = error.energy,
                    py::arg("averaged_gradient") = error.averaged_gradient,
                    py::arg("size") = error.size, py::arg("oscillation") = error.oscillation,
                    py::arg("l2") = error.l2, py::arg("shares") = std::move(error.shares));
}

py::tuple goal_of(const Discretization& mesh, const FormSpace& space, const CellData& conductivity,
                  const Vector& f, const Vector& flux, const Vector& u, const Vector& goal,
                  const std::string& linear_solver) {
    const Enclosed found = unlocked([&] {
        const auto problem = poisson_problem(mesh, space.conditions(), conductivity, f, flux);
        const auto as_source =
            poisson_problem(mesh, space.conditions(), conductivity, goal, {}).source;
        return goal_interval(problem, u, as_source, {.linear_solver = linear_solver});
    });
    return py::make_tuple(found.lower, found.value, found.upper);
}

} // namespace

void add_shape(py::module_& module) {
    module.def("shape_spectrum", &shape_spectrum_of);
    module.def("count_below", &count_of);
    module.def("poisson_error", &error_of);
    module.def("goal_interval", &goal_of);
}

} // namespace polydec::python
