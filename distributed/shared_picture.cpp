// SPDX-License-Identifier: MIT
#include "distributed/shared_picture.h"

#include "distributed/own_cells.h"
#include "distributed/piece_rows.h"
#include "distributed/shared_folder.h"
#include "io/pictures/draw_cells.h"
#include "io/pictures/vtu.h"

#include <fmt/format.h>

#include <algorithm>

namespace polydec {

namespace {

/// "3.vtu".
bool is_piece(std::string_view name) {
    const auto dot = name.find('.');
    return dot > 0 && name.substr(dot) == ".vtu" &&
           std::all_of(name.begin(), name.begin() + static_cast<std::ptrdiff_t>(dot),
                       [](char c) { return c >= '0' && c <= '9'; });
}

/// A column for the values of each function of vertices, at all local ones.
Points at_local_vertices(const Ranks& ranks, const DistributedMesh& mesh,
                         const std::vector<SharedValues>& values) {
    std::vector<const Vector*> functions;
    for (const SharedValues& each : values)
        if (each.degree == 0)
            functions.push_back(&each.values);
    Points own(std::ssize(mesh.cells.degree(0).first), std::ssize(functions));
    for (std::size_t i = 0; i < functions.size(); ++i)
        own.col(static_cast<Index>(i)) = *functions[i];
    return spread_to_pieces(ranks, mesh.cells.degree(0), own);
}

VtuGrid grid_of(const DistributedMesh& mesh, const OwnCells& cells,
                const std::vector<SharedValues>& values, int rank) {
    const CellComplex& complex = cells.merging.merged();
    const int n = complex.dimension();
    VtuGrid grid = draw_cells(complex, mesh.unit * cells.points, 0);
    Index column = 0;
    for (const auto& [name, degree, of_cells] : values)
        if (degree == 0)
            add_cochain(grid, complex, 0, name, cells.at_vertices.col(column++));
        else
            add_cochain(grid, complex, n, name, of_cells);
    grid.cell_data.push_back(
        {"rank", std::vector<Index>(static_cast<std::size_t>(complex.size(n)), rank)});
    return grid;
}

} // namespace

void write_pvtu(const Ranks& ranks, const std::filesystem::path& path, const DistributedMesh& mesh,
                const std::vector<SharedValues>& values, const VtuOptions& options) {
    std::filesystem::path folder_path = path;
    folder_path.replace_extension();
    ranks.together("picture", [&] {
        check_lists_files(path);
        check_drawable(mesh.dimension(), static_cast<int>(mesh.places.cols()));
    });
    SharedFolder folder(ranks, folder_path, is_piece);
    const auto cells = own_cells(ranks, mesh, at_local_vertices(ranks, mesh, values));
    VtuGrid grid;
    ranks.together("write", [&] {
        if (!cells)
            return;
        grid = grid_of(mesh, *cells, values, ranks.rank());
        write_vtu(folder.path() / fmt::format("{}.vtu", ranks.rank()), grid, options);
    });

    const auto with_cells =
        ranks.of_all(cells ? std::vector<int>{ranks.rank()} : std::vector<int>());
    folder.commit();
    // the list is that of the first rank with cells, which knows of what kinds they are
    ranks.together("write", [&] {
        std::vector<std::string> pieces;
        for (const int rank : with_cells)
            pieces.push_back(fmt::format("{}/{}.vtu", folder_path.filename().string(), rank));
        if (!with_cells.empty() && with_cells.front() == ranks.rank())
            write_pvtu(path, grid, pieces, options);
    });
}

} // namespace polydec
