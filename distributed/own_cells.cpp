// SPDX-License-Identifier: MIT
#include "distributed/own_cells.h"

#include "base/lists.h"
#include "complex/blocks.h"
#include "dec/metric/simplex_geometry.h"
#include "dec/metric/subsets.h"
#include "distributed/piece_rows.h"

namespace polydec {

namespace {

/// What is told of one simplex: its number, and its carrier.
constexpr int face_width = 4;

/// How n-simplices travel: places, numbers and data of their corners, their orientation, then what
/// is told of all their faces, of every degree, themselves last. Whole numbers are far below 2^53.
struct Row {
    Row(int n_, Eigen::Index N_, Eigen::Index data_) : n(n_), N(N_), data(data_) {
        for (int k = 0; k <= n; ++k)
            faces.push_back(subsets(n + 1, k + 1));
        width = orientation() + 1;
        for (const auto& lists : faces)
            width += face_width * std::ssize(lists);
    }

    Eigen::Index corner(int i) const { return i * (N + 1 + data); }
    Eigen::Index orientation() const { return corner(n + 1); }

    int n;
    Eigen::Index N, data, width;
    std::vector<std::vector<std::vector<int>>> faces; ///< by degree: their corners
};

Points rows_of(const DistributedMesh& mesh, const Points& of_vertices, const Row& row) {
    const LocalComplex& local = mesh.local;
    const Pieces& complex = local.complex;
    const Simplices& tops = complex.simplices(row.n);
    Points rows(tops.rows(), row.width);
    for (Index t = 0; t < tops.rows(); ++t) {
        for (int i = 0; i <= row.n; ++i) {
            const Index v = tops(t, i);
            auto corner = rows.row(t).segment(row.corner(i), row.N + 1 + row.data);
            corner << mesh.places.row(v), static_cast<double>(local.vertices[v]),
                of_vertices.row(v);
        }
        Eigen::Index place = row.orientation();
        rows(t, place++) = complex.orientation(t);
        for (int k = 0; k <= row.n; ++k)
            for (const auto& corners : row.faces[k]) {
                const Index face = face_at(complex, row.n, t, corners);
                const Carrier& carrier = mesh.merged.carriers[k][face];
                for (const double told :
                     {static_cast<double>(local.degree(k).number[face]),
                      static_cast<double>(carrier.dimension), static_cast<double>(carrier.first),
                      static_cast<double>(carrier.sign)})
                    rows(t, place++) = told;
            }
    }
    return rows;
}

/// Simplices with what is known of their vertices.
struct Known {
    SimplicialComplex complex;
    Points points, at_vertices;
};

Known simplices_of(const Points& rows, const Row& row) {
    std::vector<double> numbers;
    for (int i = 0; i <= row.n; ++i)
        numbers.insert(numbers.end(), rows.col(row.corner(i) + row.N).begin(),
                       rows.col(row.corner(i) + row.N).end());
    sort_unique(numbers);
    Points points(std::ssize(numbers), row.N), at_vertices(std::ssize(numbers), row.data);
    Simplices tops(rows.rows(), row.n + 1);
    for (Index t = 0; t < rows.rows(); ++t)
        for (int i = 0; i <= row.n; ++i) {
            const auto corner = rows.row(t).segment(row.corner(i), row.N + 1 + row.data);
            tops(t, i) = place_in(numbers, corner[row.N]);
            points.row(tops(t, i)) = corner.head(row.N);
            at_vertices.row(tops(t, i)) = corner.tail(row.data);
        }
    const SimplicialComplex complex(tops);
    std::vector<std::int8_t> orientations;
    for (Index s = 0; s < complex.size(row.n); ++s)
        orientations.push_back(
            static_cast<std::int8_t>(rows(complex.input_row(s), row.orientation())));
    return {complex.oriented(std::move(orientations), true), std::move(points),
            std::move(at_vertices)};
}

/// The blocks that they are pieces of, as the whole mesh has them.
Blocks blocks_of(const SimplicialComplex& complex, const Points& rows, const Row& row) {
    const auto degrees = static_cast<std::size_t>(row.n) + 1;
    std::vector<std::vector<double>> numbers(degrees);
    struct Told {
        int dimension = 0;
        double first = 0;
        std::int8_t sign = 0;
    };
    std::vector<std::vector<Told>> told(degrees);
    for (int k = 0; k <= row.n; ++k) {
        numbers[k].resize(complex.size(k));
        told[k].resize(complex.size(k));
    }
    for (Index s = 0; s < complex.size(row.n); ++s) {
        const auto of_simplex = rows.row(complex.input_row(s));
        Eigen::Index place = row.orientation() + 1;
        for (int k = 0; k <= row.n; ++k)
            for (const auto& corners : row.faces[k]) {
                const Index face = face_at(complex, row.n, s, corners);
                numbers[k][face] = of_simplex[place];
                told[k][face] = {static_cast<int>(of_simplex[place + 1]), of_simplex[place + 2],
                                 static_cast<std::int8_t>(of_simplex[place + 3])};
                place += face_width;
            }
    }
    Blocks blocks;
    for (int k = 0; k <= row.n; ++k) {
        auto& carriers = blocks.carriers.emplace_back();
        auto& signs = blocks.signs.emplace_back();
        for (const auto& [dimension, first, sign] : told[k]) {
            // numbers ascend: both orders are lexicographic
            carriers.push_back({dimension, place_in(numbers[dimension], first)});
            signs.push_back(dimension == k ? sign : std::int8_t{0});
        }
        blocks.active_cofaces.push_back(complex.coface_counts(k));
        blocks.twisted.emplace_back();
    }
    return blocks;
}

} // namespace

std::optional<OwnCells> own_cells(const Ranks& ranks, const DistributedMesh& mesh,
                                  const Points& of_vertices) {
    const int n = mesh.dimension();
    const Row row(n, mesh.places.cols(), of_vertices.cols());
    const Points told = ranks.together("cells", [&] { return rows_of(mesh, of_vertices, row); });
    const Points rows = gather_pieces(ranks, mesh.local, mesh.cells.degree(n), n, told);
    return ranks.together("cells", [&]() -> std::optional<OwnCells> {
        if (rows.rows() == 0)
            return std::nullopt;
        Known known = simplices_of(rows, row);
        return OwnCells{Merging(known.complex, blocks_of(known.complex, rows, row)),
                        std::move(known.points), std::move(known.at_vertices)};
    });
}

} // namespace polydec
