// SPDX-License-Identifier: MIT
#include "io/meshes/readers.h"
#include "io/meshes/vtu_file.h"
#include "io/pages/page.h"
#include "io/pictures/vtu_solids.h"
#include "io/scanner.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <span>

namespace polydec {

namespace {

/// The faces of the solids that become polyhedra, by their corners.
using FaceList = std::vector<std::vector<int>>;
const FaceList voxel_faces{{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4},
                           {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}};
const FaceList wedge_faces{{0, 1, 2}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}};
const FaceList pyramid_faces{{0, 1, 2, 3}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};

/// Appends the cells of a file to a grid. Points that both have stay two.
class GridReader {
public:
    GridReader(const SourceFile& source, VtuGrid& grid)
        : vtu_(source), grid_(grid), first_(static_cast<Index>(grid.points.rows())) {
        if (vtu_.pieces() > 1)
            vtu_.fail(fmt::format("the grid has {} pieces; expected one; merge them, for instance "
                                  "with ParaView's filters Merge Blocks and Clean to Grid",
                                  vtu_.pieces()));
        vtu_.check();
        const Points points = points_from(vtu_.values(vtu_.points()));
        grid_.points.conservativeResize(first_ + points.rows(), points.cols());
        grid_.points.bottomRows(points.rows()) = points;
        const auto ends = vtu_.values(vtu_.cells("offsets"));
        ends_ = whole(ends);
        corners_ = whole(vtu_.lists(vtu_.cells("connectivity"), ends));
        types_ = whole(vtu_.values(vtu_.cells("types")));
        if (ends_.size() != types_.size())
            vtu_.fail("the numbers of offsets and types differ; export it again");
        const auto* const faces = vtu_.find("Cells", "faces");
        const auto* const face_ends = vtu_.find("Cells", "faceoffsets");
        if (faces != nullptr && face_ends != nullptr) {
            const auto where = vtu_.values(*face_ends);
            face_ends_ = whole(where);
            faces_ = whole(vtu_.lists(*faces, where));
        }
    }

    /// Gives the arrays of the file.
    VtuData read() {
        Index begin = 0, faces_begin = 0;
        for (std::size_t cell = 0; cell < types_.size(); begin = ends_[cell++]) {
            if (ends_[cell] < begin || ends_[cell] > static_cast<Index>(corners_.size()))
                refuse(cell, "has corners that do not exist");
            const auto corners = points_of(std::span(corners_).subspan(begin, ends_[cell] - begin));
            if (types_[cell] == 42)
                faces_begin = add_faces(cell, faces_begin);
            else
                add(cell, corners);
        }
        VtuData data;
        for (const auto& [section, array, piece] : vtu_.arrays())
            if (section == "PointData" || section == "CellData")
                add_array(section == "PointData" ? data.point_data : data.cell_data, array);
        return data;
    }

private:
    [[noreturn]] void refuse(std::size_t cell, const std::string& what) const {
        vtu_.fail(
            fmt::format("cell {} of VTK's type {} {}; export it again", cell, types_[cell], what));
    }

    std::vector<Index> whole(const std::vector<double>& numbers) const {
        std::vector<Index> result;
        result.reserve(numbers.size());
        for (const double number : numbers) {
            if (!(std::abs(number) <= std::numeric_limits<Index>::max()) ||
                number != std::floor(number))
                vtu_.fail(
                    fmt::format("found {} among numbers of cells; expected whole numbers", number));
            result.push_back(static_cast<Index>(number));
        }
        return result;
    }

    /// Corners by their numbers in the grid.
    std::vector<Index> points_of(std::span<const Index> own) const {
        std::vector<Index> corners(own.begin(), own.end());
        for (Index& corner : corners)
            corner += first_;
        return corners;
    }

    void add(std::size_t cell, const std::vector<Index>& corners) {
        constexpr std::array<Index, 7> of_grids{1, 3, 5, 7, 9, 10, 12};
        const Index type = types_[cell];
        if (std::find(of_grids.begin(), of_grids.end(), type) != of_grids.end())
            return add_cell(grid_, static_cast<VtuCell>(type), corners);
        if (type == 8 && corners.size() == 4)
            return add_cell(grid_, VtuCell::quad,
                            std::array{corners[0], corners[1], corners[3], corners[2]});
        if (type == 11)
            return add_solid(cell, corners, voxel_faces, 8);
        if (type == 13)
            return add_solid(cell, corners, wedge_faces, 6);
        if (type == 14)
            return add_solid(cell, corners, pyramid_faces, 5);
        refuse(cell, "is not supported by pages");
    }

    void add_solid(std::size_t cell, const std::vector<Index>& corners, const FaceList& list,
                   std::size_t expected) {
        if (corners.size() != expected)
            refuse(cell, fmt::format("has {} corners", corners.size()));
        std::vector<std::vector<Index>> faces;
        for (const auto& face : list) {
            faces.emplace_back();
            for (const int corner : face)
                faces.back().push_back(corners[corner]);
        }
        add_polyhedron(grid_, faces);
    }

    /// Returns where the faces of the cell end.
    Index add_faces(std::size_t cell, Index begin) {
        const Index end = cell < face_ends_.size() ? face_ends_[cell] : -1;
        const auto own = polyhedron_faces(faces_, begin, end);
        if (!own)
            refuse(cell, "has faces that do not exist");
        std::vector<std::vector<Index>> faces;
        for (const auto& face : *own)
            faces.push_back(points_of(face));
        add_polyhedron(grid_, faces);
        return end;
    }

    /// Vectors of the plane get a third number; of tensors each component is an array of its own.
    void add_array(std::vector<VtuArray>& list, const VtuText& array) const {
        const std::string name = array.name();
        const std::string count = array.tag.attribute("NumberOfComponents", "1");
        const std::vector<double> values = vtu_.values(array);
        Eigen::Index width = 0;
        std::from_chars(count.data(), count.data() + count.size(), width);
        const auto size = static_cast<Eigen::Index>(values.size());
        if (width < 1 || width > 9 || size % width != 0)
            vtu_.fail(fmt::format("{} numbers of {} components in the array {}; expected 1 to 9 "
                                  "components of each point or cell",
                                  size, quote_word(count), quote_word(name)));
        const Eigen::Map<const DenseMatrix> rows(values.data(), width, size / width);
        if (width <= 3)
            return list.push_back(vtu_array(name, rows.transpose()));
        for (Eigen::Index i = 0; i < width; ++i)
            list.push_back(vtu_array(fmt::format("{} {}", name, i), rows.row(i).transpose()));
    }

    VtuFile vtu_;
    VtuGrid& grid_;
    Index first_; ///< point
    std::vector<Index> corners_, ends_, types_, faces_, face_ends_;
};

/// The files that a series lists, with their times.
std::vector<std::pair<std::string, std::string>> listed(const SourceFile& source) {
    XmlReader reader(source);
    XmlTag tag;
    std::vector<std::pair<std::string, std::string>> files;
    while (reader.next(tag))
        if (tag.opens && tag.name == "DataSet") {
            files.emplace_back(tag.attribute("timestep", std::to_string(files.size())),
                               tag.attribute("file"));
            if (tag.attribute("part", "0") != "0")
                reader.fail("a step has a second part; expected one; merge the parts");
        }
    if (files.empty())
        reader.fail("the series lists no files; expected elements DataSet");
    return files;
}

/// The files of the pieces that a .pvtu file lists.
std::vector<std::string> pieces_of(const SourceFile& source) {
    XmlReader reader(source);
    XmlTag tag;
    std::vector<std::string> files;
    while (reader.next(tag))
        if (tag.opens && tag.name == "Piece")
            files.push_back(tag.attribute("Source"));
    if (files.empty())
        reader.fail("the grid lists no files; expected elements Piece with a Source");
    for (const auto& file : files)
        if (lower_extension(file) != ".vtu")
            reader.fail(fmt::format("the piece {} is no .vtu file", quote_word(file)));
    return files;
}

bool are_alike(const VtuData& a, const VtuData& b) {
    return std::all_of(vtu_lists.begin(), vtu_lists.end(), [&](auto list) {
        return std::equal((a.*list).begin(), (a.*list).end(), (b.*list).begin(), (b.*list).end(),
                          [](const auto& one, const auto& other) { return one.is_like(other); });
    });
}

/// The entries of arrays that are alike, behind those that are there.
void append(VtuData& data, const VtuData& more) {
    for (const auto list : vtu_lists)
        for (std::size_t i = 0; i < (data.*list).size(); ++i)
            std::visit(
                [&](auto& values) {
                    const auto& other =
                        std::get<std::decay_t<decltype(values)>>((more.*list)[i].values);
                    values.insert(values.end(), other.begin(), other.end());
                },
                (data.*list)[i].values);
}

} // namespace

VtuGrid read_grid(const std::filesystem::path& path) {
    const SourceFile source = read_source_file(path);
    VtuGrid grid;
    if (lower_extension(path) != ".pvtu") {
        static_cast<VtuData&>(grid) = GridReader(source, grid).read();
        return grid;
    }
    const auto files = pieces_of(source);
    for (const std::string& file : files) {
        const SourceFile piece = read_source_file(path.parent_path() / file);
        VtuData data = GridReader(piece, grid).read();
        if (&file == &files.front())
            static_cast<VtuData&>(grid) = std::move(data);
        else if (are_alike(grid, data))
            append(grid, data);
        else
            refuse_contents(
                path.string(),
                fmt::format("the arrays of {} are not those of {}; expected the same in all pieces",
                            file, files.front()));
    }
    return grid;
}

Page read_series(const std::filesystem::path& path) {
    Page page;
    for (const auto& [time, file] : listed(read_source_file(path))) {
        VtuGrid grid = read_grid(path.parent_path() / file);
        page.steps.push_back({grid, time});
        if (page.steps.size() == 1)
            page.grid = std::move(grid);
        else if (grid.corners != page.grid.corners || grid.points != page.grid.points)
            refuse_contents(path.string(), fmt::format("the cells or points of {} differ from the "
                                                       "first file; expected the same in all files",
                                                       file));
    }
    return page;
}

} // namespace polydec
