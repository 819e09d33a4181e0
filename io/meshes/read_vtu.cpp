// SPDX-License-Identifier: MIT
#include "base/checks.h"
#include "io/meshes/readers.h"
#include "io/meshes/vtk_cells.h"
#include "io/meshes/vtu_file.h"
#include "io/scanner.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace polydec {

namespace {

/// Puts the pieces of a grid one behind the other.
class PieceReader {
public:
    PieceReader(const VtuFile& vtu, const SourceFile& file) : vtu_(vtu), file_(file) {}

    Mesh read() {
        // Without any piece the arrays that are missing are told of the first.
        for (int piece = 0; piece < std::max(1, vtu_.pieces()); ++piece)
            read_piece(piece);
        take_tags();
        const std::size_t joined = vtu_.pieces() > 1 ? join() : 0;
        Mesh mesh = vtk_mesh(arrays_, place_of(vtu_.cells("connectivity")), file_);
        if (joined > 0)
            mesh.warnings.push_back(fmt::format(
                "joined {} vertices to coincident vertices of other pieces of the grid", joined));
        return mesh;
    }

private:
    Scanner place_of(const VtuText& array) const {
        Scanner place(file_.name, array.text);
        place.set_line(array.tag.line);
        return place;
    }

    void read_piece(int piece) {
        vtu_.check(piece);
        const auto before = static_cast<double>(arrays_.points.size() / 3);
        const VtuText& places = vtu_.points(piece);
        const auto points = vtu_.values(places);
        const VtuText& text = vtu_.cells("connectivity", piece);
        const auto ends = vtu_.values(vtu_.cells("offsets", piece));
        const auto corners = vtu_.lists(text, ends);
        const auto corners_before = static_cast<double>(arrays_.corners.size());
        arrays_.points.insert(arrays_.points.end(), points.begin(), points.end());
        check_points(arrays_.points, arrays_.points.size() - points.size(), place_of(places));
        piece_of_.resize(arrays_.points.size() / 3, piece);
        const auto most = static_cast<double>(points.size() / 3);
        for (const double corner : corners) {
            if (vtu_.pieces() > 1 && !(corner >= 0 && corner < most))
                place_of(text).fail(fmt::format(
                    "a cell of piece {} has the vertex number {}; {}; correct the index or add the "
                    "vertex",
                    piece, corner, expected_numbers(0, std::ssize(points) / 3 - 1)));
            arrays_.corners.push_back(before + corner);
        }
        for (const double end : ends)
            arrays_.ends.push_back(corners_before + end);
        const auto types = vtu_.values(vtu_.cells("types", piece));
        arrays_.types.insert(arrays_.types.end(), types.begin(), types.end());
        cells_in_.push_back(types.size());
    }

    /// The first array that names groups; cells of pieces without it have the tag 0.
    void take_tags() {
        for (const auto& [section, array, first_piece] : vtu_.arrays()) {
            if (section != "CellData" || !is_tag_name(array.name()))
                continue;
            for (int piece = 0; piece < vtu_.pieces(); ++piece) {
                const auto* const tags = vtu_.find("CellData", array.name(), piece);
                const auto values =
                    tags == nullptr
                        ? std::vector<double>(cells_in_[static_cast<std::size_t>(piece)])
                        : vtu_.values(*tags);
                arrays_.tags.insert(arrays_.tags.end(), values.begin(), values.end());
            }
            return;
        }
    }

    /// Gives cells the first of the points at one place, unless one piece has two of them there: it
    /// may have a slit. The others stay, so that vertices keep their numbers. How many there are.
    std::size_t join() {
        std::vector<std::size_t> order(arrays_.points.size() / 3);
        std::iota(order.begin(), order.end(), 0);
        const auto at = [this](std::size_t v) {
            return std::array{arrays_.points[3 * v], arrays_.points[3 * v + 1],
                              arrays_.points[3 * v + 2]};
        };
        std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
            return at(a) != at(b) ? at(a) < at(b) : a < b;
        });
        std::vector<double> first(order.size());
        std::size_t joined = 0;
        for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
            while (end < order.size() && at(order[end]) == at(order[begin]))
                ++end;
            bool joins = true;
            for (std::size_t i = begin + 1; i < end; ++i)
                joins = joins && piece_of_[order[i]] != piece_of_[order[i - 1]];
            for (std::size_t i = begin; i < end; ++i)
                first[order[i]] = static_cast<double>(order[joins ? begin : i]);
            joined += joins ? end - begin - 1 : 0;
        }
        for (double& corner : arrays_.corners)
            corner =
                corner == std::floor(corner) ? first[static_cast<std::size_t>(corner)] : corner;
        return joined;
    }

    const VtuFile& vtu_;
    const SourceFile& file_;
    VtkArrays arrays_;
    std::vector<int> piece_of_;         ///< of each vertex
    std::vector<std::size_t> cells_in_; ///< of each piece
};

} // namespace

Mesh read_vtu(const SourceFile& file) {
    const VtuFile vtu(file);
    return PieceReader(vtu, file).read();
}

} // namespace polydec
