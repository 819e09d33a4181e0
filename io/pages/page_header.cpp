// SPDX-License-Identifier: MIT
#include "io/pages/page_header.h"

#include "base/errors.h"
#include "dec/discretization/glued_box.h"
#include "dec/fields/cell_centers.h"
#include "io/pages/page_content.h"
#include "io/pages/page_data.h"
#include "io/pages/page_fields.h"
#include "io/pages/page_text.h"
#include "io/pages/still.h"
#include "io/pictures/draw_cells.h"
#include "io/pictures/draw_solid.h"
#include "io/pictures/upright_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

namespace polydec {

namespace {

constexpr Index most_dual_cells = 200000;
constexpr Index most_arrows = 4000;
constexpr Index most_triangles = 8000000; ///< what textures hold everywhere
constexpr std::size_t most_exact_values = 600000;
constexpr Eigen::Index most_exact_points = 100000;

/// Rows of three numbers, as many as sites; every stride-th one.
Points some_vectors(const PageArrows& arrows, const Points& vectors, Index stride) {
    if (arrows.sites.rows() != vectors.rows())
        throw InvalidInput(fmt::format(
            "{} vectors are given for {} sites of the arrows `{}`: expected equal numbers",
            vectors.rows(), arrows.sites.rows(), arrows.field));
    const auto some = Eigen::seqN(0, (vectors.rows() + stride - 1) / stride, stride);
    return in_space(vectors)(some, Eigen::indexing::all);
}

/// The rule of color_range, in JSON.
std::string color_scale(const std::array<double, 2>& ends) {
    const ColorRange range = color_range(ends[0], ends[1]);
    return fmt::format("{{\"map\":\"{}\",\"ends\":[{},{}],\"constant\":{}}}",
                       range.map == ColorMap::diverging ? "diverging" : "sequential", range.low,
                       range.high, range.is_constant);
}

/// Makes the header, part after part.
class Maker {
public:
    explicit Maker(const Page& page) : page_(page), up_(upward_axis(page)), content_(page) {
        if (page.mesh && grid_dimension(page.grid) < page.mesh->dimension())
            own_ = draw_cells(*page.mesh, 0);
    }

    PageHeader make() {
        if (faces_.size() > most_triangles || page_.grid.points.rows() > most_triangles)
            throw InvalidInput(fmt::format("a page cannot show {} triangles and {} points: "
                                           "expected at most {} of each; write a .vtu file",
                                           faces_.size(), page_.grid.points.rows(),
                                           most_triangles));
        add_points();
        add_faces();
        add_fields();
        add_arrows_of_fields();
        add_dual();
        PageHeader header;
        header.json = fmt::format(
            "{{\"dimension\":{},\"flat\":{},\"up\":{},\"eyes\":{},\"unit\":{},\"cells\":{},"
            "\"cut\":{},\"points\":{},\"origin\":{},\"maps\":{},\"fields\":{},\"shown\":{},"
            "\"steps\":{},"
            "\"step\":{},\"arrows\":{},\"arrays\":{}}}",
            faces_.dimension, is_flat(page_.grid.points), up_, eyes(),
            json_text(page_.text.length_unit), cells().types.size(), cut(),
            page_.grid.points.rows(),
            json_array({json_number(origin_[0]), json_number(origin_[1]), json_number(origin_[2])}),
            maps(), json_array(fields_), number_, steps(), shown_.step, json_array(arrows_),
            data_.directory());
        header.data = data_.text();
        if (faces_.size() > 0)
            header.still = still_view(content_);
        header.notes = std::move(notes_);
        return header;
    }

private:
    const VtuGrid& cells() const { return own_ ? *own_ : page_.grid; }

    bool has_place(std::string_view place) const {
        return std::any_of(all_.begin(), all_.end(),
                           [&](const PageField& field) { return field.place == place; });
    }

    /// For each axis upwards, the direction to the eye; of flat points, for their heights.
    std::string eyes() const {
        std::vector<std::string> all;
        for (const int axis : {0, 1, 2}) {
            const bool is_opening = axis == up_ && !is_flat(page_.grid.points);
            const Vector eye = is_opening ? opening_.view.eye : upright_view(axis).eye;
            all.push_back(fmt::format("[{},{},{}]", eye[0], eye[1], eye[2]));
        }
        return json_array(all);
    }

    std::string cut() const {
        return opening_.percent < 100 ? fmt::format("[{},{}]", opening_.side, opening_.percent)
                                      : "null";
    }

    static std::string maps() {
        constexpr int steps = 30; // of which both maps have their corners among them
        const auto colors = [](ColorMap map) {
            std::vector<std::string> all;
            for (int i = 0; i <= steps; ++i)
                all.push_back(json_text(color_at(map, static_cast<double>(i) / steps)));
            return json_array(all);
        };
        return fmt::format("{{\"sequential\":{},\"diverging\":{}}}", colors(ColorMap::sequential),
                           colors(ColorMap::diverging));
    }

    /// Rows of three coordinates around the middle of the extent.
    Points centered(const Points& points) const {
        Points result = Points::Zero(points.rows(), 3);
        for (Eigen::Index c = 0; c < points.cols(); ++c)
            result.col(c) = points.col(c).array() - origin_[c];
        return result;
    }

    void add_points() {
        const auto& points = page_.grid.points;
        for (Eigen::Index c = 0; c < points.cols() && points.rows() > 0; ++c)
            origin_[c] = points.col(c).minCoeff() / 2 + points.col(c).maxCoeff() / 2;
        const bool many = points.rows() > most_exact_points;
        data_.add_rounded("points", centered(points), many ? 18 : 24);
    }

    void add_faces() {
        std::vector<Index> owners;
        for (const auto& [cell, other] : faces_.owners) {
            owners.push_back(cell);
            if (faces_.dimension > 2)
                owners.push_back(other);
        }
        if (faces_.dimension < 2) {
            data_.add("lines", faces_.lines, 2);
            data_.add("line_cells", owners, 1);
            return;
        }
        data_.add("corners", faces_.corners, 3);
        data_.add("owners", owners, faces_.dimension > 2 ? 2 : 1);
        data_.add("sides", faces_.sides, 1);
        if (has_place("edge"))
            data_.add("edges", faces_.edges, 3);
        if (has_place("face"))
            data_.add("faces", faces_.faces, 1);
    }

    void add_fields() {
        std::size_t values = 0;
        for (const PageField& field : all_)
            values += field.array->size();
        is_rounded_ = values * std::max<std::size_t>(1, page_.steps.size()) > most_exact_values;
        for (std::size_t i = 0; i < all_.size(); ++i) {
            const VtuArray& array = *all_[i].array;
            if (&all_[i] == shown_.field)
                number_ = static_cast<int>(i);
            fields_.push_back(fmt::format("{{\"name\":{},\"about\":{},\"unit\":{},\"place\":\"{}\","
                                          "\"components\":{},\"scale\":{}}}",
                                          json_text(array.name), json_text(array.about),
                                          json_text(unit_in(array.about, page_.text)),
                                          all_[i].place, array.components,
                                          color_scale(range_of(page_, all_[i]))));
            for (std::size_t s = 0; s < std::max<std::size_t>(1, page_.steps.size()); ++s)
                add_values(at_step(fmt::format("f{}", i), s), all_[i].at(page_, s));
        }
        if (is_rounded_ && !fields_.empty())
            notes_.push_back("values are rounded to 1/65535 of their range, since there are many");
    }

    /// The name of an array at a step.
    std::string at_step(const std::string& name, std::size_t step) const {
        return page_.steps.empty() ? name : fmt::format("{}.{}", name, step);
    }

    void add_values(const std::string& name, const VtuArray& array) {
        if (const auto* whole = std::get_if<std::vector<Index>>(&array.values))
            return data_.add(name, *whole, array.components);
        add_reals(name, rows_of(array));
    }

    void add_reals(const std::string& name, const DenseMatrix& rows) {
        if (is_rounded_)
            data_.add_rounded(name, rows, 16);
        else
            data_.add_floats(name, rows);
    }

    std::string steps() const {
        std::vector<std::string> times;
        for (const auto& step : page_.steps)
            times.push_back(json_text(step.time));
        return json_array(times);
    }

    void add_arrows_of_fields() {
        for (std::size_t i = 0; i < page_.arrows.size(); ++i) {
            const auto& arrows = page_.arrows[i];
            const Index rows = static_cast<Index>(arrows.sites.rows());
            const Index stride = 1 + (rows - 1) / most_arrows;
            data_.add_floats(fmt::format("sites{}", i),
                             centered(some_vectors(arrows, arrows.sites, stride)));
            const bool moves = has_moving_arrows(page_);
            if (!moves)
                add_reals(fmt::format("vectors{}", i),
                          some_vectors(arrows, arrows.vectors, stride));
            for (std::size_t s = 0; s < page_.steps.size() && moves; ++s)
                add_reals(at_step(fmt::format("vectors{}", i), s),
                          some_vectors(arrows, page_.steps[s].vectors[i], stride));
            arrows_.push_back(fmt::format("{{\"field\":{},\"stride\":{}{}{}}}",
                                          json_text(arrows.field), stride, add_sizes(i),
                                          arrows.is_path() ? ",\"lines_alone\":true" : ""));
            if (arrows.lines.simplices.rows() > 0)
                add_lines(fmt::format("flow{}", i), arrows.lines);
        }
    }

    /// Where each cell has a vector of a form on edges or faces, its length as a value of the cell,
    /// at every step; returns its colors.
    std::string add_sizes(std::size_t i) {
        const auto& arrows = page_.arrows[i];
        const auto lengths = strengths(page_, all_, arrows, std::ssize(cells().types));
        if (lengths.empty())
            return "";
        for (std::size_t s = 0; s < lengths.size(); ++s)
            add_values(at_step(fmt::format("sizes{}", i), s), lengths[s]);
        return fmt::format(",\"scale\":{}", color_scale(range_of(lengths)));
    }

    void add_lines(const std::string& name, const Mesh& lines) {
        std::vector<Index> ends;
        for (Index i = 0; i < lines.simplices.rows(); ++i)
            for (int end = 0; end < 2; ++end)
                ends.push_back(lines.simplices(i, end));
        data_.add_floats(name + "_points", centered(lines.points));
        data_.add(name, ends, 2);
    }

    /// From the center of each cell to those of its facets.
    void add_dual() {
        if (!page_.mesh)
            return;
        const auto& mesh = placed(*page_.mesh);
        const int n = mesh.dimension();
        if (!mesh.passage().is_identity() || mesh.complex().size(n) > most_dual_cells) {
            notes_.push_back(mesh.passage().is_identity()
                                 ? fmt::format("the dual mesh is left out: there are more than {} "
                                               "cells",
                                               most_dual_cells)
                                 : "edges were flipped: fields are shown on the input's cells, and "
                                   "the dual mesh is left out");
            return;
        }
        const Points cells = cell_centers(mesh, n), facets = cell_centers(mesh, n - 1);
        Points both(cells.rows() + facets.rows(), cells.cols());
        both << cells, facets;
        std::vector<Index> lines;
        for (Index cell = 0; cell < mesh.complex().size(n); ++cell)
            for (const SignedFace& f : mesh.complex().incidences(n - 1)[cell]) {
                lines.push_back(cell);
                lines.push_back(static_cast<Index>(cells.rows()) + f.face);
            }
        data_.add_floats("dual_points", centered(both));
        data_.add("dual_lines", lines, 2);
    }

    const Page& page_;
    int up_;
    PageContent content_;
    const PageFaces& faces_ = content_.faces;
    const std::vector<PageField>& all_ = content_.fields;
    const ShownField& shown_ = content_.shown;
    const Opening& opening_ = content_.opening;
    std::optional<VtuGrid> own_; ///< top cells, if the grid has others
    std::array<double, 3> origin_{};
    PageData data_;
    std::vector<std::string> fields_, arrows_, notes_;
    int number_ = -1; ///< of the field that is shown
    bool is_rounded_ = false;
};

} // namespace

PageHeader page_header(const Page& page) {
    return Maker(page).make();
}

} // namespace polydec
