// SPDX-License-Identifier: MIT
#include "distributed/own_cells.h"

#include "tests/distributed/compare.h"

namespace polydec::test::in_own_cells {

/// A face of a cell by its vertices, and with which sign it has it.
using Face = std::pair<std::vector<Index>, int>;

/// The faces of k-cell c, of which vertices are renamed.
template <class Rename>
std::vector<Face> faces_of(const Merging& merging, int k, Index c, Rename rename) {
    std::vector<Face> faces;
    for (const auto& [face, sign] : merging.merged().incidences(k - 1)[c]) {
        auto vertices = merging.vertices(k - 1, face);
        std::transform(vertices.begin(), vertices.end(), vertices.begin(), rename);
        std::sort(vertices.begin(), vertices.end());
        faces.emplace_back(std::move(vertices), sign);
    }
    std::sort(faces.begin(), faces.end());
    return faces;
}

/// What differs between own cells and those of one process; empty if nothing does.
std::string difference(const DistributedMesh& mesh, const OwnCells& own,
                       const Discretization& whole) {
    const int n = whole.dimension();
    const auto& numbers = mesh.cells.degree(n).number;
    if (own.merging.merged().size(n) != std::ssize(numbers))
        return fmt::format("{} cells for {}", own.merging.merged().size(n), numbers.size());
    const auto in_file = [&](Index v) { return static_cast<Index>(own.at_vertices(v, 0)); };
    const auto in_whole = [&](Index v) { return whole.pieces().vertex_number(v); };
    for (Index c = 0; c < std::ssize(numbers); ++c) {
        const auto number = static_cast<Index>(numbers[static_cast<std::size_t>(c)]);
        if (faces_of(own.merging, n, c, in_file) != faces_of(whole.merging(), n, number, in_whole))
            return fmt::format("cell {} has other faces", number);
    }
    return "";
}

TEST(OwnCells, have_the_faces_of_one_process_wherever_their_pieces_are) {
    const auto ranks = Ranks::all();
    for (const auto& [name, given] : swept(ranks)) {
        const Discretization whole = circumcentric(given);
        for (const Ownership by : some_ownerships(ranks, name)) {
            const DistributedMesh mesh = discretized(ranks, given, by);
            Points numbers(std::ssize(mesh.local.vertices), 1);
            for (Index v = 0; v < numbers.rows(); ++v)
                numbers(v, 0) = static_cast<double>(mesh.local.vertices[v]);
            const auto own = own_cells(ranks, mesh, numbers);
            EXPECT_EQ(own.has_value(), !mesh.cells.degrees.back().number.empty()) << name;
            if (own) {
                EXPECT_EQ(difference(mesh, *own, whole), "") << name;
                OwnCells twin = *own;
                twin.at_vertices.array() += 1;
                const int n = whole.dimension();
                const bool has_faces = own->merging.merged().coboundary(n - 1).nonZeros() > 0;
                EXPECT_EQ(difference(mesh, twin, whole) != "", has_faces) << name;
            }
        }
    }
}

} // namespace polydec::test::in_own_cells
