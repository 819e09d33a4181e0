// SPDX-License-Identifier: MIT
#include "dec/discretization/discretization.h"

#include "base/checks.h"
#include "complex/merging.h"
#include "dec/discretization/advice.h"
#include "dec/discretization/cell_data.h"
#include "dec/discretization/diagnosis.h"
#include "dec/discretization/glued_box.h"
#include "dec/discretization/material_stars.h"
#include "dec/fields/cell_centers.h"
#include "dec/fields/chosen_cells.h"
#include "dec/forms/input_units.h"
#include "io/diagnosis_json.h"
#include "io/pictures/draw_cells.h"
#include "python/bindings/convert.h"

namespace polydec::python {

namespace {

StarKind star_kind(const std::string& name) {
    return chosen<StarKind>("star", name,
                            {{"circumcentric", StarKind::circumcentric},
                             {"galerkin", StarKind::galerkin},
                             {"hybrid", StarKind::hybrid},
                             {"barycentric", StarKind::barycentric},
                             {"automatic", StarKind::automatic}});
}

DiscretizeOptions options_of(const std::string& criterion, double tolerance,
                             const std::string& delaunay, const std::string& materials,
                             const std::string& star, const std::string& centers,
                             std::optional<double> refine) {
    return {.criterion = chosen<MergeCriterion>("criterion", criterion,
                                                {{"dual_length", MergeCriterion::dual_length},
                                                 {"angle", MergeCriterion::angle},
                                                 {"none", MergeCriterion::none}}),
            .tolerance = tolerance,
            .delaunay = chosen<Delaunay>("delaunay", delaunay,
                                         {{"off", Delaunay::off},
                                          {"flips", Delaunay::flips},
                                          {"flips_and_splits", Delaunay::flips_and_splits}}),
            .materials = chosen<Materials>(
                "materials", materials,
                {{"join", Materials::join}, {"keep_apart", Materials::keep_apart}}),
            .centers = chosen<Centers>(
                "centers", centers,
                {{"circumcenters", Centers()}, {"centroids", Centers::centroids()}}),
            .star = star_kind(star),
            .refine = refine};
}

template <class Given>
void add_discretize(py::module_& module) {
    module.def("discretize", [](const Given& mesh, const std::string& criterion, double tolerance,
                                const std::string& delaunay, const std::string& materials,
                                const std::string& star, const std::string& centers,
                                std::optional<double> refine, const py::object& progress) {
        const auto options =
            options_of(criterion, tolerance, delaunay, materials, star, centers, refine);
        const auto tell = listener(progress);
        return unlocked([&] { return discretize(mesh, options, tell); });
    });
}

/// The corners of all cells of a degree, and where each one's begin.
py::tuple cells(const Discretization& mesh, int k) {
    check_number("the list of cells of degree", k, 0, mesh.dimension());
    std::vector<Index> corners, begins{0};
    unlocked([&] {
        for (Index cell = 0; cell < mesh.complex().size(k); ++cell) {
            const std::vector<Index> own = k == 2 && mesh.dimension() >= 2
                                               ? polydec::corners(mesh.merging(), cell)
                                               : mesh.merging().vertices(k, cell);
            corners.insert(corners.end(), own.begin(), own.end());
            begins.push_back(static_cast<Index>(corners.size()));
        }
    });
    return py::make_tuple(std::move(begins), std::move(corners));
}

/// Of each k-simplex the merged cell that it is in: its dimension and number.
py::tuple carriers(const Discretization& mesh, int k) {
    std::vector<Index> dimensions, numbers;
    for (const auto& [dimension, cell] : mesh.merging().carriers(k)) {
        dimensions.push_back(dimension);
        numbers.push_back(cell);
    }
    return py::make_tuple(std::move(dimensions), std::move(numbers));
}

/// What the command says of a mesh, as JSON.
std::string report(const Discretization& mesh) {
    const Diagnosis found = unlocked([&] { return diagnose(mesh); });
    warn(found.warnings);
    std::vector<std::string> advice;
    for (const Advice& each : found.advice)
        advice.push_back(in_words(each, found.dimension));
    std::vector<std::string> warnings = mesh.warnings();
    warnings.insert(warnings.end(), found.warnings.begin(), found.warnings.end());
    JsonWriter json;
    json.object([&] {
        write_diagnosis(json, found, advice);
        write_stars(json, mesh.chosen_stars());
        json.member("warnings", warnings);
    });
    return std::string(json.view());
}

py::tuple polygons(const Discretization& mesh) {
    PolygonMesh found = unlocked([&] { return polygon_mesh(mesh); });
    return py::make_tuple(std::move(found.points), std::move(found.offsets),
                          std::move(found.corners));
}

std::vector<DenseMatrix> matrices(const Numbers& tensors) {
    std::vector<DenseMatrix> result;
    const auto rows_of = tensors.shape(1), columns_of = tensors.shape(2);
    for (py::ssize_t i = 0; i < tensors.shape(0); ++i)
        result.emplace_back(Eigen::Map<const Points>(tensors.data(i, 0, 0), rows_of, columns_of));
    return result;
}

void add_parts(py::class_<Discretization, Cells>& type) {
    type.def_property_readonly("points",
                               [](const py::object& self) {
                                   const auto& mesh = self.cast<Discretization&>();
                                   return mesh.box() ? array(cell_centers(mesh, 0))
                                                     : shown(mesh.points(), self);
                               })
        .def_property_readonly("input_cells",
                               [](const Discretization& mesh) {
                                   return Cells(mesh.input(), mesh.input_geometry().volumes(),
                                                mesh.unit());
                               })
        .def_property_readonly("pieces_cells",
                               [](const Discretization& mesh) {
                                   return Cells(mesh.pieces(), mesh.geometry().volumes(),
                                                mesh.unit());
                               })
        .def_property_readonly("warnings",
                               [](const Discretization& mesh) { return mesh.warnings(); })
        .def_property_readonly("tags", [](const Discretization& mesh) { return mesh.tags(); })
        .def_property_readonly("vertices", &vertices_of_cells)
        .def_property_readonly("vertex_count", &count_vertices)
        .def_property_readonly("isolated",
                               [](const Discretization& mesh) { return mesh.isolated(); })
        .def("cells_of_vertices", &cells_of_vertices)
        .def("boundary_vertices", &boundary_vertices)
        .def("vertices_on", &vertices_on)
        .def_property_readonly("facet_tags",
                               [](const Discretization& mesh) { return mesh.facet_tags(); })
        .def("facets_in", &facets_in)
        .def_property_readonly("unit", &Discretization::unit)
        .def_property_readonly(
            "star_kind", [](const Discretization& mesh) { return name(mesh.chosen_stars().kind); })
        .def_property_readonly("is_glued",
                               [](const Discretization& mesh) { return mesh.box() != nullptr; })
        .def("placed", [](const Discretization& mesh) { return placed(mesh); })
        .def("cells_of_places",
             [](const Discretization& mesh, int k) {
                 check_number("the cells of a box of degree", k, 0, mesh.dimension());
                 return cells_of_places(mesh, k);
             })
        .def("cells", &cells)
        .def("polygons", &polygons)
        .def("report", &report);
}

void add_merging(py::class_<Discretization, Cells>& type) {
    type.def_property_readonly(
            "is_identity", [](const Discretization& mesh) { return mesh.merging().is_identity(); })
        .def("carriers", &carriers)
        .def("diamond",
             [](const py::object& self, int k) {
                 return csr(self.cast<Discretization&>().merging().diamond(k), self);
             })
        .def(
            "lift",
            [](const Discretization& mesh, int k) {
                check_number("the lift of degree", k, 0, mesh.dimension());
                return SparseMatrix(mesh.merged().lift()[k]);
            },
            Unlocking());
}

void add_places(py::class_<Discretization, Cells>& type) {
    using Places = Points (*)(const Discretization&, int);
    type.def("centers", static_cast<Places>(&cell_centers), Unlocking())
        .def("centroids", static_cast<Places>(&cell_centroids), Unlocking())
        .def("dual_sites", &dual_sites)
        .def("facet_sites", &facet_sites);
}

void add_stars(py::class_<Discretization, Cells>& type) {
    type.def("with_stars",
             [](const Discretization& mesh, const std::string& kind) {
                 return unlocked([&, kind = star_kind(kind)] { return mesh.with_stars(kind); });
             })
        .def("with_star", [](const Discretization& mesh, int k,
                             const MatrixParts& star) { return mesh.with_star(k, sparse(star)); })
        .def("with_conductivity", &with_conductivity, Unlocking())
        .def("with_electric_material", &with_electric_material, Unlocking())
        .def("with_material", &with_material, Unlocking())
        .def("cell_means", &cell_means, Unlocking())
        .def(
            "material_star",
            [](const Discretization& mesh, int k, const CellData& weights) -> SparseMatrix {
                return in_input_units(material_star(mesh, k, weights), mesh.unit(),
                                      mesh.dimension() - 2 * k, "the star");
            },
            Unlocking())
        .def("tensor_star", [](const Discretization& mesh, const Numbers& tensors) {
            return unlocked([&, given = matrices(tensors)]() -> SparseMatrix {
                return in_input_units(material_star(mesh, given), mesh.unit(), 2 - mesh.dimension(),
                                      "the star");
            });
        });
}

} // namespace

void add_discretization(py::module_& module) {
    py::class_<CellData>(module, "CellData").def(py::init([](Vector values, bool are_on_cells) {
        return are_on_cells ? CellData::on_cells(std::move(values)) : CellData(std::move(values));
    }));
    py::class_<Discretization, Cells> type(module, "Discretization");
    add_parts(type);
    add_merging(type);
    add_places(type);
    add_stars(type);
    add_discretize<Mesh>(module);
    add_discretize<LengthMesh>(module);
    add_discretize<PeriodicMesh>(module);
}

} // namespace polydec::python
