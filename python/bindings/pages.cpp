// SPDX-License-Identifier: MIT
#include "io/meshes/mesh_files.h"
#include "io/pages/page.h"
#include "io/pages/series.h"
#include "io/pictures/color_map.h"
#include "io/pictures/draw_fields.h"
#include "io/pictures/draw_structure.h"
#include "io/pictures/lighting.h"
#include "io/pictures/svg_drawing.h"
#include "io/pictures/upright_view.h"
#include "python/bindings/convert.h"

#include <cmath>

namespace polydec::python {

namespace {

/// Fields as Python names them: name, side, degree, values, and what they are in words. Values with
/// a row for each vertex or n-cell are vectors.
using Given = std::vector<std::tuple<std::string, Side, int, Numbers, std::string>>;

std::vector<NamedForm> fields_of(const Given& given) {
    std::vector<NamedForm> fields;
    for (const auto& [name, side, degree, values, about] : given)
        if (values.ndim() == 2)
            fields.emplace_back(name, side, table<Points>(values), about);
        else
            fields.emplace_back(name, Cochain{side, degree, vector(values)}, about);
    return fields;
}

void write_picture(const std::string& path, const Discretization& mesh, const Given& given,
                   bool float32) {
    const VtuGrid grid = draw_fields(mesh, fields_of(given));
    const VtuOptions options{float32 ? VtuNumbers::float32 : VtuNumbers::float64};
    unlocked([&] { write_vtu(path, grid, options); });
}

/// Mesh file, upward axis and unit of length; or empty.
using Conventions = std::tuple<std::string, std::optional<int>, std::string>;

std::string text_of(Page page, const Discretization& mesh, const std::vector<std::string>& facts,
                    const Conventions& conventions) {
    std::tie(page.text.file, page.text.up, page.text.length_unit) = conventions;
    page.text.facts.insert(page.text.facts.begin(), facts.begin(), facts.end());
    page.text.warnings = mesh.warnings();
    return unlocked([&] { return to_html(page); });
}

/// The page of these fields, or of cells alone; of several times those of each step.
std::string page(const Discretization& mesh, const Given& given,
                 const std::vector<std::pair<std::string, Given>>& steps, const std::string& title,
                 const std::vector<std::string>& facts, const Conventions& conventions) {
    Page drawn = given.empty() ? draw_page(mesh, title) : draw_page(mesh, fields_of(given), title);
    for (const auto& [time, at_time] : steps)
        drawn.steps.push_back(draw_step(drawn, time, fields_of(at_time)));
    if (!steps.empty())
        for (PageArrows& arrows : drawn.arrows)
            arrows.lines = {}; // they would stand still
    return text_of(std::move(drawn), mesh, facts, conventions);
}

/// The page of the modes of a Spectrum of Python's.
std::string page_of_modes(const Discretization& mesh, const py::object& given,
                          const std::string& title, const std::vector<std::string>& facts,
                          const Conventions& conventions) {
    const auto take = [](const py::object& from, const char* name, auto& value) {
        value = py::object(from.attr(name)).cast<std::decay_t<decltype(value)>>();
    };
    Spectrum found;
    take(given, "side", found.side);
    take(given, "degree", found.degree);
    take(given, "eigenvalues", found.eigenvalues);
    take(given, "modes", found.modes);
    take(given, "radii", found.radii);
    take(given, "residuals", found.residuals);
    const py::object proof = given.attr("certificate");
    take(proof, "shift", found.certificate.shift);
    take(proof, "below_shift", found.certificate.below_shift);
    take(proof, "returned_below_shift", found.certificate.returned_below_shift);
    take(proof, "complete", found.certificate.complete);
    return text_of(draw_page(mesh, found, title), mesh, facts, conventions);
}

/// The text of a drawing for lessons.
std::string drawing(const Discretization& mesh, bool duals, bool dual_orientations, bool both_duals,
                    std::optional<Index> cell, std::optional<int> matrix, double explode,
                    bool numbers, bool orientations, bool circumcircles, const std::string& title,
                    double width, const std::vector<double>& eye) {
    LessonOptions options{.both_duals = both_duals, .matrix = matrix, .explode = explode};
    options.structure = {.duals = duals,
                         .dual_orientations = dual_orientations,
                         .cell = cell,
                         .numbers = numbers,
                         .orientations = orientations,
                         .circumcircles = circumcircles};
    SolidView& view = options.structure.view;
    view.eye = Eigen::Map<const Vector>(eye.data(), static_cast<Eigen::Index>(eye.size()));
    view.title = title;
    view.width = width;
    return unlocked([&] { return to_svg(draw_lesson(mesh, options)); });
}

/// The map of values between these, as colors at equal distances, and the values at its ends.
std::tuple<std::vector<std::string>, double, double> colors(double low, double high) {
    constexpr int steps = 30; // of which both maps have their corners among them
    const ColorRange range = color_range(low, high);
    std::vector<std::string> map;
    for (int i = 0; i <= steps; ++i)
        map.push_back(color_at(range.map, static_cast<double>(i) / steps));
    return {map, range.low, range.high};
}

/// For each normal, in parts to the right, up and to the eye.
Vector lights(const Points& normals) {
    Vector result(normals.rows());
    for (Eigen::Index i = 0; i < normals.rows(); ++i)
        result[i] = brightness(normals.row(i).transpose());
    return result;
}

/// The upward axis, this one or that of the mesh file, and the direction to the eye.
std::pair<int, Vector> first_view(const std::string& file, std::optional<int> up) {
    const int axis = up.value_or(up_axis(file));
    return {axis, upright_view(axis).eye};
}

void add_series(py::module_& module) {
    py::class_<Series>(module, "Series")
        .def(py::init([](const std::string& path, const Discretization& mesh,
                         const std::string& title, const std::vector<double>& times) {
            return std::make_unique<Series>(path, mesh, PageText{.title = title}, times);
        }))
        .def("add",
             [](Series& self, double time, const Given& given) {
                 unlocked([&, fields = fields_of(given)] { self.add(time, fields); });
             })
        .def("close", [](Series& self) { unlocked([&] { self.close(); }); });
}

} // namespace

void add_pages(py::module_& module) {
    module.def("write_vtu", &write_picture);
    module.def("brightness", &lights);
    module.def("colors", &colors);
    module.def("first_view", &first_view);
    module.def("page", &page);
    module.def("page_of_modes", &page_of_modes);
    module.def("draw", &drawing);
    module.def("write_drawing", [](const std::string& path, const std::string& svg) {
        unlocked([&] { write_drawing(path, svg); });
    });
    add_series(module);
}

} // namespace polydec::python
