// SPDX-License-Identifier: MIT
#include "base/checks.h"
#include "base/errors.h"
#include "dec/discretization/glued_box.h"
#include "dec/fields/de_rham.h"
#include "dec/fields/flat_and_sharp.h"
#include "dec/fields/lie_derivative.h"
#include "dec/fields/transfer.h"
#include "dec/fields/wedge.h"
#include "dec/fields/whitney_interpolation.h"
#include "python/bindings/convert.h"

#include <fmt/format.h>

namespace polydec::python {

namespace {

/// Integrates a form that is given at many points at once: the first time over, the points where it
/// is asked for are written down, and zeros stand for it; the second time its values there.
template <class Integrate>
auto integrated(Index width, int components, const py::function& form, Integrate integrate) {
    std::vector<double> places;
    const SmoothForm rehearsal = [&](const Vector& point) -> Vector {
        places.insert(places.end(), point.begin(), point.end());
        return Vector::Zero(components);
    };
    unlocked([&] { return integrate(rehearsal); });

    const auto count = static_cast<Index>(places.size()) / std::max<Index>(width, 1);
    Points points = Eigen::Map<const Points>(places.data(), count, width);
    const Numbers values = form(array(std::move(points))).cast<Numbers>();
    check_as_many("values of the form", static_cast<Index>(values.size()), count * components);
    const double* value = values.data();
    const SmoothForm known = [&](const Vector&) -> Vector {
        value += components;
        return Eigen::Map<const Eigen::VectorXd>(value - components, components);
    };
    return unlocked([&] { return integrate(known); });
}

int binomial(int n, int k) {
    int result = 1;
    for (int i = 1; i <= k; ++i)
        result = result * (n - k + i) / i;
    return k < 0 || k > n ? 0 : result;
}

/// How many numbers a k-form has at a point of a space of so many dimensions.
int components_of(Index width, int degree) {
    return binomial(static_cast<int>(width), degree);
}

Cochain de_rham_of(const Discretization& mesh, Side side, int degree, const py::function& function,
                   int quadrature_degree) {
    check_number("the degree of a form", degree, 0, mesh.dimension());
    const auto width = static_cast<Index>(mesh.ambient_dimension());
    const auto integrate = [&](const SmoothForm& form) {
        return side == Side::primal ? de_rham(mesh, degree, form, quadrature_degree)
                                    : dual_de_rham(mesh, degree, form, quadrature_degree);
    };
    return integrated(width, components_of(width, degree), function, integrate);
}

Vector boundary_de_rham_of(const Discretization& mesh, int degree, const py::function& function,
                           int quadrature_degree) {
    check_number("the degree of a form on the boundary", degree, 0, mesh.dimension() - 1);
    const auto width = static_cast<Index>(mesh.ambient_dimension());
    return integrated(width, components_of(width, degree), function, [&](const SmoothForm& form) {
        return boundary_de_rham(mesh, degree, form, quadrature_degree);
    });
}

void add_periodic(py::module_& module) {
    module.def("periodic", &periodic, Unlocking());
    module.def("glue", &glue_by_images, Unlocking());
    py::class_<PeriodicMesh>(module, "PeriodicMesh")
        .def(py::init([](const Mesh& box, const LengthMesh& quotient, std::vector<Index> vertices,
                         Points points) {
            return PeriodicMesh{box, quotient, std::move(vertices), std::move(points)};
        }))
        .def_readonly("box", &PeriodicMesh::box)
        .def_readonly("quotient", &PeriodicMesh::quotient)
        .def_readonly("vertices", &PeriodicMesh::vertices)
        .def_readonly("points", &PeriodicMesh::points);
}

void add_products(py::module_& module) {
    module.def("product", [](const Discretization& mesh, const std::string& named, const Cochain& a,
                             const Cochain& b) {
        const auto weights = chosen<WedgeWeights>(
            "weights", named,
            {{"uniform", WedgeWeights::uniform}, {"circumcentric", WedgeWeights::circumcentric}});
        const bool have_no_weights = a.side == Side::dual && weights == WedgeWeights::uniform;
        return unlocked(
            [&] { return have_no_weights ? dual_wedge(mesh, a, b) : wedge(mesh, a, b, weights); });
    });
    module.def("primal_dual_wedge",
               [](const Discretization& mesh, const Cochain& a, const Cochain& b) {
                   return primal_dual_wedge(mesh.complex(), a, b);
               });
}

void add_fields_of_vectors(py::module_& module) {
    module.def("flat",
               [](const Discretization& mesh, const std::string& kind, const Points& field) {
                   const auto flat_kind = chosen<Flat>("flat", kind,
                                                       {{"ppp", Flat::ppp},
                                                        {"pdp", Flat::pdp},
                                                        {"dpp", Flat::dpp},
                                                        {"ppd", Flat::ppd},
                                                        {"pdd", Flat::pdd},
                                                        {"dpd", Flat::dpd}});
                   return unlocked([&] { return flat(mesh, flat_kind, field); });
               });
    module.def("sharp_pp", &sharp_pp, Unlocking());
    module.def("sharp_pd", &sharp_pd, Unlocking());
    module.def("flux_sharp", &flux_sharp, Unlocking());
    module.def(
        "vectors_at_cells",
        [](const Discretization& mesh, const Cochain& form) {
            return vectors_at_cells(mesh, form);
        },
        Unlocking());
    module.def("whitney_at_centroids",
               py::overload_cast<const Discretization&, const Cochain&>(&whitney_at_centroids),
               Unlocking());
    module.def("whitney_form",
               py::overload_cast<const Discretization&, const Cochain&, Index, const Vector&>(
                   &whitney_form));
    module.def("interior_product", &interior_product, Unlocking());
    module.def("lie_derivative", &lie_derivative, Unlocking());
    module.def("inflow", &inflow, Unlocking());
}

void add_lie_derivative(py::module_& module) {
    py::class_<LieDerivative>(module, "LieDerivative")
        .def(py::init<const Discretization&, int, Sampling>(), Unlocking())
        .def("lie_derivative", &LieDerivative::operator(), Unlocking())
        .def("interior_product", &LieDerivative::interior_product, Unlocking())
        .def("inflow", &LieDerivative::inflow, Unlocking());
}

void add_transfer(py::module_& module) {
    module.def("to_merged", &to_merged, Unlocking());
    module.def("to_input", &to_input, Unlocking());
    module.def("lifted", &lifted, Unlocking());
    module.def("consistency", [](const Discretization& mesh, const Cochain& form) {
        const Consistency found = consistency(mesh, form);
        return py::dict(py::arg("worst") = found.worst, py::arg("cell") = found.cell,
                        py::arg("found") = found.found, py::arg("expected") = found.expected,
                        py::arg("description") = found.description);
    });
}

} // namespace

void add_fields(py::module_& module) {
    module.def("de_rham", &de_rham_of);
    module.def("boundary_de_rham", &boundary_de_rham_of);
    add_periodic(module);
    add_products(module);
    add_fields_of_vectors(module);
    add_lie_derivative(module);
    add_transfer(module);
}

} // namespace polydec::python
