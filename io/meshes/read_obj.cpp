// SPDX-License-Identifier: MIT
#include "base/checks.h"
#include "base/listed.h"
#include "io/meshes/readers.h"
#include "io/scanner.h"

#include <fmt/format.h>

#include <cstdint>
#include <limits>
#include <string_view>
#include <utility>
#include <vector>

namespace polydec {

namespace {

class ObjReader {
public:
    /// The records of this keyword are the cells: "f" of faces, or "l" of lines.
    ObjReader(const SourceFile& file, const char* cells)
        : file_(file),
          scanner_(file.name, file.text, {.comment = '#', .continuation = '\\'}),
          cells_(cells) {}

    Mesh read() {
        while (!scanner_.at_end()) {
            read_line();
            scanner_.next_line();
        }
        if (farthest_ >= vertices())
            fail_range(farthest_place_, farthest_ + 1);
        polygons_.points = Eigen::Map<const Points>(coordinates_.data(), vertices(), axes_);
        Mesh mesh = cells_ == "f" ? split_polygons(std::move(polygons_)) : segments_of(polygons_);
        if (left_out_ > 0)
            mesh.warnings.push_back(
                fmt::format("left out {} of lines or points; the first is in line {}",
                            counted(left_out_, "record", "records"), first_left_out_));
        return mesh;
    }

private:
    void read_line() {
        const auto keyword = scanner_.word("a keyword");
        if (keyword == "v") {
            read_vertex();
        } else if (keyword == cells_) {
            read_cell();
        } else if (keyword == "l" || keyword == "p") {
            first_left_out_ = left_out_ == 0 ? scanner_.line() : first_left_out_;
            ++left_out_;
        }
    }

    /// Two coordinates are of the plane, if all vertices have so many. Behind three, a weight or a
    /// color may follow; it is left out with the rest of the line.
    void read_vertex() {
        const Index vertex = checked_count(static_cast<std::size_t>(vertices()), "vertices", file_);
        for (int axis = 0; axis < axes_; ++axis) {
            if (vertex == 0 && axis == 2 && scanner_.at_line_end()) {
                axes_ = 2;
                return;
            }
            scanner_.stay_on_line("three coordinates of a vertex, or two of every vertex");
            coordinates_.push_back(scanner_.coordinate(vertex));
        }
        if (axes_ == 2 && !scanner_.at_line_end())
            scanner_.fail("more than two coordinates, but the first vertex has two; expected two "
                          "of every vertex, or three; correct the line");
    }

    void read_cell() {
        while (!scanner_.at_line_end())
            polygons_.corners.push_back(read_corner());
        close_face(polygons_, file_);
    }

    /// a, a/b, a//c or a/b/c: the vertex a alone matters. It may come later in the file, so that
    /// the greatest one is remembered and checked at the end.
    Index read_corner() {
        const auto number = scanner_.integer("a vertex number", '/');
        const auto vertex = number > 0 ? number - 1 : vertices() + number;
        if (number == 0 || vertex < 0 || vertex > std::numeric_limits<Index>::max())
            fail_range(scanner_, number);
        if (vertex > farthest_) {
            farthest_ = vertex;
            farthest_place_ = scanner_;
        }
        if (scanner_.remaining() > 0 && scanner_.rest()[0] == '/')
            scanner_.word("a corner");
        return static_cast<Index>(vertex);
    }

    std::int64_t vertices() const { return std::ssize(coordinates_) / axes_; }

    [[noreturn]] void fail_range(const Scanner& place, std::int64_t number) const {
        const char* back = number < 0 ? " counted back from here" : "";
        place.fail(fmt::format("vertex number {} is out of range; {}{}; correct the index or add "
                               "the vertex",
                               number,
                               number < 0 ? expected_numbers(-vertices(), -1)
                                          : expected_numbers(1, vertices()),
                               back));
    }

    const SourceFile& file_;
    Scanner scanner_;
    std::string_view cells_;
    std::vector<double> coordinates_;
    int axes_ = 3;
    PolygonMesh polygons_;
    std::int64_t farthest_ = -1;
    Scanner farthest_place_ = scanner_;
    std::size_t left_out_ = 0;
    std::size_t first_left_out_ = 0;
};

} // namespace

Mesh read_obj(const SourceFile& file) {
    Mesh mesh = ObjReader(file, "f").read();
    return mesh.simplices.rows() > 0 ? mesh : ObjReader(file, "l").read();
}

} // namespace polydec
