// SPDX-License-Identifier: MIT
#include "base/checks.h"
#include "io/meshes/cell_lists.h"
#include "io/meshes/ply_header.h"
#include "io/meshes/readers.h"
#include "io/scanner.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>
#include <vector>

namespace polydec {

namespace {

/// The numbers of a body, text or binary. Every type of PLY fits into a double exactly.
class PlySource {
public:
    PlySource(const SourceFile& file, const PlyHeader& header)
        : file_(file), order_(header.order), scanner_(file.name, file.text) {
        scanner_.skip(header.body_begin - place());
        scanner_.set_line(header.body_line);
    }

    double value(NumberType type) {
        if (!order_)
            return scanner_.number("a number");
        const auto size = size_of(type);
        if (size > remaining())
            fail("the file ends here; expected more elements; export it again, it seems cut off");
        const char* const place = scanner_.rest().data();
        scanner_.skip(size);
        return value_at(place, type, *order_);
    }

    void end_record() {
        if (!order_)
            scanner_.end_line("an element");
    }
    std::size_t remaining() const { return scanner_.remaining(); }
    bool at_end() { return order_ ? remaining() == 0 : scanner_.at_end(); }

    [[noreturn]] void fail(const std::string& text) const {
        if (!order_)
            scanner_.fail(text);
        refuse_contents(file_.name, fmt::format("before byte {}: {}", place(), text));
    }

private:
    std::size_t place() const { return file_.text.size() - remaining(); }

    const SourceFile& file_;
    std::optional<std::endian> order_;
    Scanner scanner_;
};

class BodyReader {
public:
    BodyReader(const SourceFile& file, const PlyHeader& header)
        : file_(file), header_(header), source_(file, header) {
        for (const auto& element : header.elements)
            vertices_ = element.name == "vertex" ? element.count : vertices_;
    }

    Mesh read() {
        for (const auto& element : header_.elements)
            if (element.name == "vertex")
                read_vertices(element);
            else if (element.name == "face")
                read_faces(element);
            else if (element.name == "edge")
                read_edges(element);
            else
                pass_over(element);
        const bool is_rest = !source_.at_end();
        Mesh mesh = std::move(cells_).mesh(std::move(points_), file_);
        if (is_rest)
            mesh.warnings.push_back(
                fmt::format("left out {} bytes after the last element", source_.remaining()));
        return mesh;
    }

private:
    void read_vertices(const PlyElement& element) {
        std::vector<int> axis_of(element.properties.size(), -1);
        const int axes = element.find("z") == element.properties.size() ? 2 : 3;
        for (int axis = 0; axis < axes; ++axis) {
            const std::string name(1, "xyz"[axis]);
            const auto place = element.find(name);
            if (place == element.properties.size() || element.properties[place].is_list)
                source_.fail(
                    fmt::format("the element vertex has no property {}; expected x, y and, except "
                                "for a mesh of the plane, z; correct the header",
                                name));
            axis_of[place] = axis;
        }
        points_.resize(element.count, axes);
        for (Index vertex = 0; vertex < element.count; ++vertex)
            read_vertex(element, axis_of, vertex);
    }

    void read_vertex(const PlyElement& element, const std::vector<int>& axis_of, Index vertex) {
        for (std::size_t i = 0; i < axis_of.size(); ++i) {
            const auto& property = element.properties[i];
            if (axis_of[i] < 0) {
                pass_over(property);
                continue;
            }
            const double value = source_.value(property.type);
            if (!std::isfinite(value))
                source_.fail(fmt::format("vertex {} (counted from 0) has a coordinate that is NaN, "
                                         "infinite or outside the range of double precision; "
                                         "expected finite numbers; repair or remove the vertex",
                                         vertex));
            points_(vertex, axis_of[i]) = value;
        }
        source_.end_record();
    }

    void read_faces(const PlyElement& element) {
        const auto list = element.corners();
        if (list == element.properties.size() || !element.properties[list].is_list)
            source_.fail("the element face has no list vertex_indices; expected property list "
                         "uchar int vertex_indices; correct the header");
        for (Index face = 0; face < element.count; ++face) {
            for (std::size_t i = 0; i < element.properties.size(); ++i)
                if (i == list)
                    read_corners(element.properties[i], face);
                else
                    pass_over(element.properties[i]);
            end_cell(2);
        }
    }

    void read_corners(const PlyProperty& property, Index face) {
        const auto length = read_length(property);
        for (std::size_t i = 0; i < length; ++i)
            read_corner(property, "face", face);
    }

    void read_corner(const PlyProperty& property, const char* what, Index cell) {
        const double value = source_.value(property.type);
        if (!(value >= 0.0 && value < vertices_) || value != std::floor(value))
            source_.fail(fmt::format("{} {} has the vertex number {}; {}; correct the index or add "
                                     "the vertex",
                                     what, cell, value, expected_numbers(0, vertices_ - 1)));
        corners_.push_back(static_cast<Index>(value));
    }

    void end_cell(int dimension) {
        source_.end_record();
        cells_.add(dimension, corners_, 0);
        corners_.clear();
    }

    /// The cells of a curve, in a file without faces.
    void read_edges(const PlyElement& element) {
        for (Index edge = 0; edge < element.count; ++edge) {
            for (const auto& property : element.properties)
                if (!property.is_list && (property.name == "vertex1" || property.name == "vertex2"))
                    read_corner(property, "edge", edge);
                else
                    pass_over(property);
            end_cell(1);
        }
    }

    std::size_t read_length(const PlyProperty& list) {
        const double length = source_.value(list.length_type);
        const auto most = static_cast<double>(source_.remaining());
        if (!(length >= 0.0 && length <= most) || length != std::floor(length))
            source_.fail(fmt::format("a list of length {}, but {} bytes follow; expected a whole "
                                     "number that fits; export it again",
                                     length, source_.remaining()));
        return static_cast<std::size_t>(length);
    }

    void pass_over(const PlyProperty& property) {
        const auto values = property.is_list ? read_length(property) : 1;
        for (std::size_t i = 0; i < values; ++i)
            source_.value(property.type);
    }

    /// Elements without properties take no room.
    void pass_over(const PlyElement& element) {
        if (element.properties.empty())
            return;
        for (Index record = 0; record < element.count; ++record) {
            for (const auto& property : element.properties)
                pass_over(property);
            source_.end_record();
        }
    }

    const SourceFile& file_;
    const PlyHeader& header_;
    PlySource source_;
    Points points_;
    CellLists cells_;
    std::vector<Index> corners_; ///< of the cell that is being read
    Index vertices_ = 0;
};

} // namespace

Mesh read_ply(const SourceFile& file) {
    return BodyReader(file, read_ply_header(file)).read();
}

} // namespace polydec
