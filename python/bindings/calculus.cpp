// SPDX-License-Identifier: MIT
#include "complex/homology.h"
#include "dec/boundary/form_space.h"
#include "dec/forms/cochain.h"
#include "dec/forms/input_units.h"
#include "dec/forms/laplacian.h"
#include "python/bindings/convert.h"

namespace polydec::python {

namespace {

/// Cells of one's own, by their coboundaries and volumes.
Cells own_cells(const std::vector<MatrixParts>& coboundaries, std::vector<Vector> primal,
                std::vector<Vector> dual) {
    std::vector<IncidenceMatrix> incidences;
    for (const MatrixParts& d : coboundaries)
        incidences.emplace_back(sparse(d).cast<std::int8_t>());
    return {CellComplex(std::move(incidences)), CellVolumes(std::move(primal), std::move(dual))};
}

SparseMatrix derivative_of(const Cells& of, Side side, int k) {
    return side == Side::primal ? derivative(of.complex(), k) : dual_derivative(of.complex(), k);
}

void add_matrices(py::class_<Cells>& calculus) {
    calculus
        .def("incidence",
             [](const py::object& self, int k) {
                 // the complex is shared with what C++ keeps, so lives as long as this does
                 return csr(self.cast<Cells&>().complex().coboundary(k), self);
             })
        .def("d", &derivative_of, Unlocking())
        .def(
            "boundary",
            [](const Cells& of, Side side, int k) {
                return SparseMatrix(derivative_of(of, side, k - 1).transpose());
            },
            Unlocking())
        .def(
            "codifferential",
            [](const Cells& of, Side side, int k) {
                return (side == Side::primal ? codifferential(of, k) : dual_codifferential(of, k))
                    .matrix();
            },
            Unlocking())
        .def(
            "laplacian",
            [](const Cells& of, Side side, int k) {
                return (side == Side::primal ? laplacian(of, k) : dual_laplacian(of, k)).matrix();
            },
            Unlocking())
        .def(
            "stiffness", [](const Cells& of, int k) { return symmetric_laplacian(of, k).matrix(); },
            Unlocking())
        .def(
            "dual_boundary_derivative",
            [](const Cells& of, int j) { return dual_boundary_derivative(of.complex(), j); },
            Unlocking())
        .def(
            "homology_generators",
            [](const Cells& of, int k) { return homology_generators(of.complex(), k); },
            Unlocking());
}

void add_stars(py::class_<Cells>& calculus) {
    calculus.def("is_diagonal", [](const Cells& of, int k) { return of.stars()[k].is_diagonal(); })
        .def("star",
             [](const Cells& of, int k) -> py::object {
                 const HodgeStar star = polydec::star(of, k);
                 if (star.is_diagonal())
                     return array(star.diagonal());
                 return csr(SparseMatrix(star.matrix()));
             })
        .def("inverse_star", [](const Cells& of, int k) { return star(of, k).inverse(); })
        .def(
            "solve_star",
            [](const Cells& of, int k, const Vector& values) { return star(of, k).solve(values); },
            Unlocking())
        .def("zeros", [](const Cells& of, int k) { return of.stars()[k].zeros(); })
        .def("negatives", [](const Cells& of, int k) { return of.stars()[k].negatives(); })
        .def("with_star", [](const Cells& of, int k,
                             const MatrixParts& star) { return of.with_star(k, sparse(star)); })
        .def("volumes", [](const py::object& self,
                           int k) { return shown(self.cast<Cells&>().input_volumes(k), self); })
        .def("dual_volumes", [](const py::object& self, int k) {
            return shown(self.cast<Cells&>().input_dual_volumes(k), self);
        });
}

void add_forms(py::class_<Cells>& calculus) {
    using Map = Cochain (*)(const Cells&, const Cochain&);
    calculus
        .def(
            "d_of", [](const Cells& of, const Cochain& form) { return d(of.complex(), form); },
            Unlocking())
        .def("star_of", static_cast<Map>(&star), Unlocking())
        .def("codifferential_of", static_cast<Map>(&codifferential), Unlocking())
        .def("laplacian_of", static_cast<Map>(&laplacian), Unlocking())
        .def("inner_product", &inner_product)
        .def("norm", &norm);
}

/// One mark for all facets of the boundary, or one for each (n-1)-cell. Those that are not
/// essential have Robin's condition where their coefficient, if there are any, is not 0. One mark
/// for each vertex at which values are given, or none.
BoundaryConditions conditions_of(const std::vector<bool>& essential, const Vector& robin,
                                 const std::vector<bool>& fixed) {
    const auto condition = [&](std::size_t i) {
        if (essential[essential.size() == 1 ? 0 : i])
            return BoundaryCondition::essential;
        return robin.size() > 0 && robin[i] != 0 ? BoundaryCondition::robin
                                                 : BoundaryCondition::natural;
    };
    BoundaryConditions conditions(BoundaryCondition::essential, {}, {robin.begin(), robin.end()},
                                  fixed);
    if (essential.size() == 1 && robin.size() == 0)
        conditions.everywhere = condition(0);
    else
        for (std::size_t i = 0; i < std::max<std::size_t>(essential.size(), robin.size()); ++i)
            conditions.facets.push_back(condition(i));
    return conditions;
}

void add_spaces(py::module_& module) {
    py::class_<FormSpace>(module, "FormSpace")
        .def(py::init([](const Cells& cells, Side side, int degree,
                         const std::vector<bool>& essential, const Vector& robin,
                         const std::vector<bool>& fixed) {
            return unlocked([&] {
                return FormSpace(cells, side, degree, conditions_of(essential, robin, fixed));
            });
        }))
        .def("cells", [](const FormSpace& space) { return space.relative().cells; })
        .def("inside", &FormSpace::inside, Unlocking())
        .def(
            "stiffness",
            [](const FormSpace& space) -> SparseMatrix {
                const double power = space.cells().dimension() - 2 * space.cell_degree() - 2;
                return in_input_units(space.stiffness().matrix(), space.cells().unit(), power,
                                      "the stiffness");
            },
            Unlocking())
        .def("require_use",
             [](const FormSpace& space, const std::string& values, const std::string& flow,
                const std::string& robin) {
                 space.require_use({values, flow, robin});
             })
        .def("in_words", [](const FormSpace& space) { return space.in_words(); });
}

} // namespace

void add_calculus(py::module_& module) {
    py::class_<Cells> calculus(module, "Cells");
    calculus.def(py::init(&own_cells))
        .def_property_readonly("dimension",
                               [](const Cells& of) { return of.complex().dimension(); })
        .def("size", [](const Cells& of, int k) { return of.complex().size(k); })
        .def("coface_counts",
             [](const Cells& of, int k) {
                 const auto& counts = of.complex().coface_counts(k);
                 return std::vector<Index>(counts.begin(), counts.end());
             })
        .def("betti_numbers",
             [](const Cells& of) { return unlocked([&] { return betti_numbers(of.complex()); }); });
    add_matrices(calculus);
    add_stars(calculus);
    add_forms(calculus);
    add_spaces(module);
}

} // namespace polydec::python
