// SPDX-License-Identifier: MIT
#include "base/checks.h"
#include "io/meshes/cell_lists.h"
#include "io/meshes/mesh_files.h"
#include "io/meshes/vtk_cells.h"
#include "meshes/generate.h"
#include "meshes/length_mesh.h"
#include "meshes/polygons.h"
#include "meshes/rearrange.h"
#include "meshes/tetrahedralize.h"
#include "meshes/tidy.h"
#include "meshes/weld.h"
#include "python/bindings/convert.h"

namespace polydec::python {

namespace {

/// A group as Python names it: dimension, tag and name.
using GivenGroup = std::tuple<int, Index, std::string>;

std::vector<GroupName> groups_of(const std::vector<GivenGroup>& given) {
    std::vector<GroupName> groups;
    for (const auto& [dimension, tag, name] : given)
        groups.push_back({dimension, tag, name});
    return groups;
}

Mesh mesh_of(Points points, Simplices simplices, std::vector<Index> tags, Simplices facets,
             std::vector<Index> facet_tags, const std::vector<GivenGroup>& groups,
             const std::vector<std::string>& warnings, std::vector<Index> input_cells,
             Index input_count) {
    return {std::move(points),
            std::move(simplices),
            warnings,
            std::move(tags),
            {std::move(facets), std::move(facet_tags)},
            groups_of(groups),
            {std::move(input_cells), input_count}};
}

/// Cells of one kind: dimension, corners, where those of each end, tags, other nodes of each.
using CellBlock =
    std::tuple<int, std::vector<Index>, std::vector<Index>, std::vector<Index>, std::size_t>;

Mesh mesh_of_cells(Points points, const std::vector<CellBlock>& blocks) {
    const SourceFile given{"the given mesh", ""};
    CellLists cells;
    for (const auto& [dimension, corners, ends, tags, nodes] : blocks)
        for (std::size_t cell = 0; cell < ends.size(); ++cell) {
            const Index begin = cell == 0 ? 0 : ends[cell - 1];
            const std::span own(corners.data() + begin,
                                static_cast<std::size_t>(ends[cell] - begin));
            for (const Index corner : own)
                if (corner < 0 || corner >= points.rows())
                    throw InvalidInput("cell " + std::to_string(cell) + " of dimension " +
                                           std::to_string(dimension) + " has the vertex " +
                                           std::to_string(corner) + "; " +
                                           expected_numbers(0, points.rows() - 1),
                                       {.degree = dimension,
                                        .cells = {static_cast<Index>(cell)},
                                        .vertices = {corner}});
            cells.add(dimension, own, tags[cell]);
            cells.leave_out_nodes(nodes);
        }
    return std::move(cells).mesh(std::move(points), given);
}

py::list names_of(const std::vector<GroupName>& groups) {
    py::list result;
    for (const auto& [dimension, tag, name] : groups)
        result.append(py::make_tuple(dimension, tag, name));
    return result;
}

void add_classes(py::module_& module) {
    py::class_<Mesh>(module, "Mesh")
        .def(py::init(&mesh_of))
        .def_property_readonly(
            "points", [](const py::object& self) { return shown(self.cast<Mesh&>().points, self); })
        .def_property_readonly(
            "simplices",
            [](const py::object& self) { return shown(self.cast<Mesh&>().simplices, self); })
        .def_property_readonly("facets",
                               [](const py::object& self) {
                                   return shown(self.cast<Mesh&>().facet_tags.simplices, self);
                               })
        .def_readonly("tags", &Mesh::tags)
        .def_property_readonly("facet_tags", [](const Mesh& mesh) { return mesh.facet_tags.tags; })
        .def_property_readonly("groups", [](const Mesh& mesh) { return names_of(mesh.groups); })
        .def_property_readonly("input_cells",
                               [](const Mesh& mesh) { return mesh.input_cells.of_simplices; })
        .def_property_readonly("input_count",
                               [](const Mesh& mesh) { return mesh.input_cells.count; })
        .def_readonly("warnings", &Mesh::warnings);
    py::class_<LengthMesh>(module, "LengthMesh")
        .def(py::init([](Simplices simplices, Index vertices, Simplices edges, Vector lengths) {
            LengthMesh mesh{std::move(simplices), vertices, std::move(edges), std::move(lengths)};
            check(mesh);
            return mesh;
        }))
        .def_readonly("vertices", &LengthMesh::vertices)
        .def_property_readonly(
            "simplices",
            [](const py::object& self) { return shown(self.cast<LengthMesh&>().simplices, self); })
        .def_property_readonly(
            "edges",
            [](const py::object& self) { return shown(self.cast<LengthMesh&>().edges, self); })
        .def_readonly("lengths", &LengthMesh::lengths);
}

void add_files(py::module_& module) {
    using Path = std::string;
    module.def("read_mesh",
               [](const Path& path) { return unlocked([&] { return read_mesh(path); }); });
    module.def("write_mesh", [](const Path& path, const Mesh& mesh) {
        unlocked([&] { write_mesh(path, mesh); });
    });
    module.def("read_lengths",
               [](const Path& path) { return unlocked([&] { return read_lengths(path); }); });
    module.def("write_lengths", [](const Path& path, const LengthMesh& mesh) {
        unlocked([&] { write_lengths(path, mesh); });
    });
    module.def("is_length_file", [](const Path& path) { return is_length_file(path); });
    module.def("is_tag_name", &is_tag_name);
}

void add_generators(py::module_& module) {
    using Counts = std::vector<int>;
    using Lengths = std::vector<double>;
    const Unlocking unlocking;
    module.def("grid", &grid, unlocking);
    module.def("hexagons", &hexagons, unlocking);
    module.def("well_centered", &well_centered, unlocking);
    module.def("uv_sphere", &uv_sphere, unlocking);
    module.def("icosphere", &icosphere, unlocking);
    module.def("goldberg", &goldberg, unlocking);
    module.def("torus", &torus, unlocking);
    module.def("moebius", &moebius, unlocking);
    module.def("flange", &flange, unlocking);
    module.def("kuhn", py::overload_cast<const Counts&, const Lengths&>(&kuhn), unlocking);
    module.def("split_boxes", &split_boxes, unlocking);
    module.def("bcc", py::overload_cast<int>(&bcc), unlocking);
    module.def("bcc", py::overload_cast<const Counts&, double>(&bcc), unlocking);
    module.def("fcc", py::overload_cast<int>(&fcc), unlocking);
    module.def("fcc", py::overload_cast<const Counts&, double>(&fcc), unlocking);
    module.def("d4", py::overload_cast<int>(&d4), unlocking);
    module.def("d4", py::overload_cast<const Counts&, double>(&d4), unlocking);
    module.def(
        "sphere_clusters",
        [](int dimension, int cells_per_side, int spheres, int points_on_sphere, double radius,
           std::uint64_t seed) {
            return sphere_clusters(
                {dimension, cells_per_side, spheres, points_on_sphere, radius, seed});
        },
        unlocking);
}

py::tuple parts_of(Renumbered changed) {
    return py::make_tuple(std::move(changed.mesh), std::move(changed.vertices),
                          std::move(changed.cells));
}

void add_changes(py::module_& module) {
    module.def("perturbed", &perturbed);
    module.def("shuffled",
               [](const Mesh& mesh, std::uint64_t seed) { return parts_of(shuffled(mesh, seed)); });
    module.def("along_morton_curve",
               [](const Mesh& mesh) { return parts_of(along_morton_curve(mesh)); });
    module.def("mesh_of_cells", &mesh_of_cells);
    module.def("split_polygons", [](Points points, std::vector<Index> corners,
                                    std::vector<Index> offsets, std::vector<Index> tags) {
        return split_polygons(
            {std::move(points), std::move(corners), std::move(offsets), std::move(tags)});
    });
    module.def("weld", [](const Mesh& mesh, std::optional<double> length) {
        return unlocked([&] { return weld(mesh, length).mesh; });
    });
    module.def("join_hanging", [](const Mesh& mesh, std::optional<double> length) {
        return unlocked([&] { return join_hanging(mesh, length).mesh; });
    });
    module.def("unjoined_boundary", [](const Mesh& mesh) {
        auto found = unlocked([&] { return unjoined_boundary(mesh); });
        return py::make_tuple(std::move(found.coincident), std::move(found.hanging), found.misfits);
    });
    module.def("length_mesh", &length_mesh);
    module.def("peeled", &peeled, Unlocking());
    module.def("tetrahedralize", [](const Mesh& surface, double largest_volume, double quality,
                                    const Points& holes) {
        const MesherOptions options{.quality = quality, .largest_volume = largest_volume};
        return unlocked([&] { return tetrahedralize(surface, options, holes); });
    });
}

} // namespace

void add_meshes(py::module_& module) {
    add_classes(module);
    add_files(module);
    add_generators(module);
    add_changes(module);
}

} // namespace polydec::python
