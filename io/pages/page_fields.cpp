// SPDX-License-Identifier: MIT
#include "io/pages/page_fields.h"

#include "base/checks.h"
#include "base/errors.h"
#include "dec/discretization/glued_box.h"
#include "io/pictures/color_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace polydec {

namespace {

std::array<double, 2> range_of(const VtuArray& array) {
    const Vector numbers = shown_numbers(array);
    if (numbers.size() == 0)
        return {0, 0};
    return {numbers.minCoeff(), numbers.maxCoeff()};
}

std::array<double, 2> both(const std::array<double, 2>& a, const std::array<double, 2>& b) {
    return {std::min(a[0], b[0]), std::max(a[1], b[1])};
}

bool varies(const VtuArray& array) {
    const auto [low, high] = range_of(array);
    return !color_range(low, high).is_constant;
}

bool is_in(const PageStep& step, const PageField& field) {
    const auto& arrays = step.*field.list;
    if (field.number >= arrays.size())
        return false;
    const VtuArray &first = *field.array, &later = arrays[field.number];
    return later.name == first.name && later.components == first.components &&
           later.size() == first.size();
}

void check_steps(const Page& page, const std::vector<PageField>& fields) {
    for (std::size_t s = 0; s < page.steps.size(); ++s) {
        const PageStep& step = page.steps[s];
        const std::size_t arrays =
            step.point_data.size() + step.cell_data.size() + step.field_data.size();
        if (arrays != fields.size() ||
            !std::all_of(fields.begin(), fields.end(),
                         [&](const PageField& field) { return is_in(step, field); }))
            throw InvalidInput(fmt::format("step {} of a page has other arrays than the first "
                                           "step: expected the same names and sizes",
                                           s));
        if (step.vectors.size() != page.steps[0].vectors.size() ||
            (!step.vectors.empty() && step.vectors.size() != page.arrows.size()))
            throw InvalidInput(fmt::format("step {} of a page has vectors for {} of its {} arrows: "
                                           "expected vectors for each",
                                           s, step.vectors.size(), page.arrows.size()));
    }
}

const PageField* first_field(const Page& page, const std::vector<PageField>& fields) {
    const PageField* asked = nullptr;
    for (const PageField& field : fields) {
        if (asked == nullptr && field.array->name == page.shown)
            asked = &field;
        if (asked != nullptr && (!page.steps.empty() || varies(*field.array)))
            return &field;
    }
    return asked;
}

std::size_t opening_step(const Page& page, const ShownField& shown) {
    std::size_t best = 0;
    double most = 0;
    for (std::size_t s = 0; s < page.steps.size(); ++s) {
        const auto [low, high] = range_of(shown.at(page, s));
        const double range = high / 2 - low / 2; // finite
        if (range > (1 + 1e-9) * most) {
            best = s;
            most = range;
        }
    }
    return best;
}

/// The vectors of arrows at every step, one row for each of so many cells that are drawn. Empty
/// unless the field has values on edges or faces, and each cell has a vector.
std::vector<Points> vectors_of_cells(const Page& page, const std::vector<PageField>& fields,
                                     const PageArrows& arrows, std::ptrdiff_t cells) {
    const auto found = std::find_if(fields.begin(), fields.end(), [&](const PageField& field) {
        return field.array->name == arrows.field;
    });
    if (found == fields.end() || found->place == "vertex" || found->place == "cell" ||
        arrows.vectors.rows() == 0 || arrows.vectors.rows() != cells ||
        (!page.steps.empty() && !has_moving_arrows(page)) ||
        (page.mesh && !page.mesh->passage().is_identity())) // cells between flipped edges
        return {};
    std::vector<Points> vectors;
    if (page.steps.empty())
        vectors.push_back(arrows.vectors);
    const auto number = static_cast<std::size_t>(&arrows - page.arrows.data());
    for (const PageStep& step : page.steps)
        vectors.push_back(step.vectors[number]);
    if (page.mesh)
        for (Points& each : vectors)
            each = Points(
                each(cells_of_places(*page.mesh, page.mesh->dimension()), Eigen::indexing::all));
    return vectors;
}

} // namespace

DenseMatrix rows_of(const VtuArray& array) {
    return std::visit(
        [&](const auto& values) {
            const auto width = array.components;
            DenseMatrix rows(static_cast<Eigen::Index>(values.size()) / width, width);
            for (Eigen::Index i = 0; i < rows.size(); ++i)
                rows(i / width, i % width) = static_cast<double>(values[i]);
            return rows;
        },
        array.values);
}

Vector shown_numbers(const VtuArray& array) {
    const DenseMatrix rows = rows_of(array);
    if (rows.cols() == 1)
        return rows;
    const Vector lengths = rows.rowwise().stableNorm();
    if (!lengths.allFinite())
        throw InvalidInput(fmt::format(
            "the lengths of the vectors `{}` are not finite: scale them down", array.name));
    return lengths;
}

std::array<double, 2> range_of(const std::vector<VtuArray>& arrays) {
    if (arrays.empty())
        return {0, 0};
    auto range = range_of(arrays.front());
    for (const VtuArray& array : arrays)
        range = both(range, range_of(array));
    return range;
}

std::array<double, 2> range_of(const Page& page, const PageField& field) {
    auto range = range_of(*field.array);
    for (std::size_t step = 0; step < page.steps.size(); ++step)
        range = both(range, range_of(field.at(page, step)));
    return range;
}

std::string unit_in(const std::string& about, const PageText& text) {
    constexpr std::string_view mark = "in units of ";
    const auto at = about.find(mark);
    if (at == std::string::npos)
        return "";
    const auto begin = at + mark.size();
    std::string unit = about.substr(begin, about.find_first_of(" ,;", begin) - begin);
    constexpr std::string_view length = "length";
    if (const auto place = unit.find(length); place < unit.size() && !text.length_unit.empty())
        unit.replace(place, length.size(), text.length_unit);
    return unit;
}

std::vector<PageField> page_fields(const Page& page, int dimension, const CellComplex* complex) {
    const std::array<std::string, 4> places{"vertex", "edge", "face", "cell"};
    const int degree = grid_dimension(page.grid);
    const std::string& of_cells = degree == dimension ? places.back() : places[degree];
    std::vector<PageField> fields;
    for (const VtuArray& array : page.grid.point_data)
        fields.push_back({&array, places[0], &VtuData::point_data, fields.size()});
    std::size_t number = 0;
    for (const VtuArray& array : page.grid.cell_data)
        fields.push_back({&array, of_cells, &VtuData::cell_data, number++});
    number = 0;
    for (const VtuArray& array : page.grid.field_data) {
        if (array.degree < 0)
            continue;
        if (complex == nullptr || array.degree < 1 || array.degree >= complex->dimension())
            throw InvalidInput(fmt::format("the array `{}` of a page is of cells of degree {}: "
                                           "expected edges or faces of its mesh",
                                           array.name, array.degree));
        check_as_many(fmt::format("entries of `{}`", array.name),
                      static_cast<std::int64_t>(array.size()) / array.components,
                      complex->size(array.degree));
        fields.push_back({&array, places[array.degree], &VtuData::field_data, number++});
    }
    check_steps(page, fields);
    return fields;
}

bool has_moving_arrows(const Page& page) {
    return !page.steps.empty() && !page.steps.front().vectors.empty();
}

std::vector<VtuArray> strengths(const Page& page, const std::vector<PageField>& fields,
                                const PageArrows& arrows, std::ptrdiff_t cells) {
    std::vector<VtuArray> lengths;
    for (const Points& vectors : vectors_of_cells(page, fields, arrows, cells))
        lengths.push_back(
            vtu_array(fmt::format("|{}|", arrows.field), vectors.rowwise().stableNorm()));
    return lengths;
}

ShownField shown_field(const Page& page, const std::vector<PageField>& fields,
                       std::ptrdiff_t cells) {
    ShownField shown{first_field(page, fields)};
    if (shown.field == nullptr)
        return shown;
    shown.place = shown.field->place;
    for (const PageArrows& arrows : page.arrows)
        if (shown.strengths.empty() && arrows.field == shown.field->array->name) {
            shown.strengths = strengths(page, fields, arrows, cells);
            shown.vectors = vectors_of_cells(page, fields, arrows, cells);
        }
    if (!shown.strengths.empty())
        shown.place = "cell";
    shown.step = opening_step(page, shown);
    return shown;
}

} // namespace polydec
