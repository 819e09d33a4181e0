// SPDX-License-Identifier: MIT
#include "dec/merging/lift.h"

#include "base/decompositions.h"
#include "base/errors.h"
#include "base/groups.h"
#include "base/lists.h"
#include "dec/metric/cell_volumes.h"
#include "dec/metric/exterior_product.h"
#include "dec/metric/simplex_faces.h"
#include "dec/metric/whitney.h"
#include "system/memory.h"

#include <Eigen/SparseQR>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace polydec {

namespace {

using ColumnMajor = Eigen::SparseMatrix<double, Eigen::ColMajor, Index>;

/// The j-simplices with a carrier of degree m, by carrier.
Groups simplices_by_carrier(const Merging& merging, int m, int j) {
    const auto& carriers = merging.carriers(j);
    return {static_cast<Index>(carriers.size()), merging.merged().size(m),
            [&](Index s) { return carriers[s].dimension == m ? carriers[s].cell : -1; }};
}

/// Rows of a sparse matrix, appended in any order.
struct RowStore {
    std::vector<Index> first, last, columns;
    std::vector<double> values;

    explicit RowStore(Index rows) : first(rows, 0), last(rows, 0) {}

    void begin(Index row) { first[row] = last[row] = static_cast<Index>(columns.size()); }
    void append(Index row, Index column, double value) {
        if (columns.size() >= std::size_t(std::numeric_limits<Index>::max()))
            throw InvalidInput("the lift has more than 2^31 - 1 entries: a merged cell of p "
                               "corners needs about p^2 of them; lower the merge tolerance");
        columns.push_back(column);
        values.push_back(value);
        last[row] = static_cast<Index>(columns.size());
    }
    template <class Visit>
    void visit(Index row, Visit visitor) const {
        for (Index i = first[row]; i < last[row]; ++i)
            visitor(columns[i], values[i]);
    }
};

/// A full p x p matrix takes p^3 products: for this number of pieces, 20 seconds.
constexpr std::size_t most_pieces = 2000;

void check_work(int m, Index F, std::size_t pieces) {
    if (pieces > most_pieces)
        throw InvalidInput(
            fmt::format("the {}-cell {} is merged from {} simplices, and the time to lift forms to "
                        "them grows with the cube of this number; expected at most {}; use "
                        "StarKind::circumcentric, which needs no lift, or do not merge cells",
                        m, F, pieces, most_pieces),
            {.degree = m, .cells = {F}});
}

class Lift {
public:
    Lift(const Merging& merging, const Geometry& geometry)
        : merging_(merging),
          K_(merging.pieces()),
          P_(merging.merged()),
          geometry_(geometry),
          volumes_(geometry.volumes()),
          inside_(K_.dimension() + 1) {
        const int n = K_.dimension();
        for (int k = 0; k <= n; ++k)
            rows_.emplace_back(K_.size(k));
        for (int m = 0; m <= n; ++m) {
            for (int j = 0; j <= m; ++j)
                inside_[m].push_back(simplices_by_carrier(merging, m, j));
            for (Index F = 0; F < P_.size(m); ++F)
                fill_cell(m, F);
        }
    }

    SparseMatrix matrix(int k) const {
        SparseMatrix S(K_.size(k), P_.size(k));
        S.reserve(static_cast<Index>(rows_[k].columns.size()));
        for (Index s = 0; s < K_.size(k); ++s) {
            S.startVec(s);
            rows_[k].visit(s, [&](Index F, double value) { S.insertBack(s, F) = value; });
        }
        S.finalize();
        return S;
    }

private:
    void fill_cell(int m, Index F) {
        const auto pieces = inside_[m][m][F];
        double volume = 0;
        for (const Index s : pieces)
            volume += volumes_.primal(m)[s];
        for (IncidenceMatrix::InnerIterator s(merging_.diamond(m), F); s; ++s) {
            const auto piece = static_cast<Index>(s.col());
            rows_[m].begin(piece);
            rows_[m].append(piece, F, s.value() * volumes_.primal(m)[piece] / volume);
        }
        for (int j = m - 1; j >= 0 && pieces.size() > 1; --j)
            if (!inside_[m][j][F].empty())
                fill_degree(m, F, j);
    }

    /// Solves d x = S_(j+1) d^P_j on the (j+1)-simplices inside F for x on the j-simplices inside
    /// F, with known values on the boundary of F; one column per j-cell of P.
    void fill_degree(int m, Index F, int j) {
        const auto unknown = inside_[m][j][F], equations = inside_[m][j + 1][F];
        const auto cells = columns(m, F, j);
        // of the right sides, the solution and its copy in the rows
        check_memory(8.0 * static_cast<double>(cells.size()) *
                         static_cast<double>(equations.size() + 3 * unknown.size()),
                     fmt::format("lifting forms to the {} simplices of a {}-cell",
                                 inside_[m][m][F].size(), m));
        check_work(m, F, inside_[m][m][F].size());

        std::vector<Eigen::Triplet<double, Index>> entries;
        DenseMatrix right_side = DenseMatrix::Zero(equations.size(), cells.size());
        for (std::size_t r = 0; r < equations.size(); ++r) {
            rows_[j + 1].visit(equations[r], [&](Index upper, double value) {
                for (const auto& [E, sign] : P_.incidences(j)[upper])
                    right_side(r, place_in(cells, E)) += value * sign;
            });
            for (const SignedFace& s : K_.incidences(j)[equations[r]])
                if (is_inside(m, F, j, s.face))
                    entries.emplace_back(r, place_in(unknown, s.face), s.sign);
                else
                    rows_[j].visit(s.face, [&](Index E, double value) {
                        right_side(r, place_in(cells, E)) -= s.sign * value;
                    });
        }
        ColumnMajor D(equations.size(), unknown.size());
        D.setFromTriplets(entries.begin(), entries.end());
        const Eigen::SparseQR<ColumnMajor, Eigen::COLAMDOrdering<Index>> qr(D);
        DenseMatrix x = qr.solve(right_side);
        if (j > 0 && !inside_[m][j - 1][F].empty())
            x = least_energy(m, F, j, std::move(x), cells);

        constexpr double rounding = 1e-15;
        for (std::size_t i = 0; i < unknown.size(); ++i) {
            rows_[j].begin(unknown[i]);
            for (std::size_t c = 0; c < cells.size(); ++c)
                if (std::abs(x(i, c)) > rounding)
                    rows_[j].append(unknown[i], cells[c], x(i, c));
        }
    }

    /// The j-cells of P on which the values inside F depend, ascending: the faces of its
    /// (j+1)-simplices, and the cells that carry the simplices on its boundary.
    std::vector<Index> columns(int m, Index F, int j) const {
        std::vector<Index> above, cells;
        for (const Index t : inside_[m][j + 1][F]) {
            rows_[j + 1].visit(t, [&](Index upper, double) { above.push_back(upper); });
            for (const SignedFace& s : K_.incidences(j)[t])
                if (!is_inside(m, F, j, s.face))
                    rows_[j].visit(s.face, [&](Index E, double) { cells.push_back(E); });
        }
        sort_unique(above);
        for (const Index upper : above)
            for (const SignedFace& E : P_.incidences(j)[upper])
                cells.push_back(E.face);
        sort_unique(cells);
        return cells;
    }

    /// x + D y, with y on the (j-1)-simplices inside F such that the Whitney energy of all
    /// j-simplices of F is minimal: D^T W_ii D y = -D^T (W_ii x + W_ib x_b).
    DenseMatrix least_energy(int m, Index F, int j, DenseMatrix x,
                             const std::vector<Index>& cells) const {
        const auto unknown = inside_[m][j][F], free = inside_[m][j - 1][F];
        DenseMatrix D = DenseMatrix::Zero(unknown.size(), free.size());
        for (std::size_t i = 0; i < unknown.size(); ++i)
            for (const auto& [s, sign] : K_.incidences(j - 1)[unknown[i]])
                if (is_inside(m, F, j - 1, s))
                    D(i, place_in(free, s)) = sign;

        if (j == K_.dimension() - 1 && !geometry_.flat().empty())
            equate_densities(m, F, cells, D, x);

        // W_ii and the force W_ii x + W_ib x_b, assembled over the pieces of F
        DenseMatrix W = DenseMatrix::Zero(unknown.size(), unknown.size());
        DenseMatrix force = DenseMatrix::Zero(unknown.size(), cells.size());
        SimplexFaces faces_of_pieces(K_, m, j);
        SimplexLayout layout(K_, geometry_.metric());
        for (const Index piece : inside_[m][m][F]) {
            if (is_flat(m, piece))
                continue;
            const Corners corners = layout.at(m, piece);
            const DenseMatrix mass = whitney_mass(corners.points, corners.vertices, j);
            const auto& faces = faces_of_pieces.of(piece);
            for (std::size_t a = 0; a < faces.size(); ++a) {
                if (!is_inside(m, F, j, faces[a]))
                    continue;
                const Index row = place_in(unknown, faces[a]);
                for (std::size_t b = 0; b < faces.size(); ++b) {
                    if (is_inside(m, F, j, faces[b])) {
                        const Index column = place_in(unknown, faces[b]);
                        W(row, column) += mass(a, b);
                        force.row(row) += mass(a, b) * x.row(column);
                    } else {
                        rows_[j].visit(faces[b], [&](Index E, double value) {
                            force(row, place_in(cells, E)) += mass(a, b) * value;
                        });
                    }
                }
            }
        }
        if (D.cols() == 0)
            return x;
        const DenseMatrix energy = D.transpose() * W * D;
        x -= D * least_squares(energy, D.transpose() * force).shortest;
        return x;
    }

    /// Adds D y to x such that on each flat piece of F the facet values are, as far as possible,
    /// the values of one normal density; D keeps the remaining freedom.
    void equate_densities(int m, Index F, const std::vector<Index>& cells, DenseMatrix& D,
                          DenseMatrix& x) const {
        const auto unknown = inside_[m][m - 1][F];
        const ExteriorProduct product(m, m - 1);
        std::vector<Vector> rows, right_sides;
        for (const Index piece : inside_[m][m][F]) {
            if (!is_flat(m, piece))
                continue;
            Points normals(m + 1, m);
            int largest = 0;
            for (int i = 0; i <= m; ++i) {
                normals.row(i) =
                    area_vector(product, *geometry_.metric().points(), K_, K_.face(m, piece, i));
                if (normals.row(i).norm() > normals.row(largest).norm())
                    largest = i;
            }
            const Vector shares =
                normals * normals.row(largest).transpose() / normals.row(largest).squaredNorm();
            for (int i = 0; i <= m; ++i) { // value at facet i = share times value at the largest
                if (i == largest)
                    continue;
                Vector& row = rows.emplace_back(Vector::Zero(std::ssize(unknown)));
                Vector& right_side = right_sides.emplace_back(Vector::Zero(std::ssize(cells)));
                const auto add = [&](Index facet, double factor) {
                    if (is_inside(m, F, m - 1, facet))
                        row[place_in(unknown, facet)] += factor;
                    else
                        rows_[m - 1].visit(facet, [&](Index E, double value) {
                            right_side[place_in(cells, E)] -= factor * value;
                        });
                };
                add(K_.face(m, piece, i), 1);
                add(K_.face(m, piece, largest), -shares[i]);
            }
        }
        if (rows.empty())
            return;
        DenseMatrix A(rows.size(), unknown.size()), b(rows.size(), cells.size());
        for (std::size_t i = 0; i < rows.size(); ++i) {
            A.row(static_cast<Index>(i)) = rows[i].transpose();
            b.row(static_cast<Index>(i)) = right_sides[i].transpose();
        }
        // stacked flat pieces give the same equations up to their height
        constexpr double height = 1e-2;
        const auto [shortest, kernel] = least_squares(A * D, b - A * x, height);
        x += D * shortest;
        D = D * kernel;
    }

    bool is_flat(int m, Index piece) const {
        return m == K_.dimension() && geometry_.is_flat(piece);
    }

    bool is_inside(int m, Index F, int j, Index s) const {
        const auto& carrier = merging_.carriers(j)[s];
        return carrier.dimension == m && carrier.cell == F;
    }

    const Merging& merging_;
    const Pieces& K_;
    const CellComplex& P_;
    const Geometry& geometry_;
    const CellVolumes& volumes_;
    std::vector<std::vector<Groups>> inside_; // inside_[m][j]
    std::vector<RowStore> rows_;              // of S_k
};

} // namespace

std::vector<SparseMatrix> commuting_lift(const Merging& merging, const Geometry& geometry) {
    check_fit(merging.pieces(), geometry.volumes());
    const Lift lift(merging, geometry);
    std::vector<SparseMatrix> result;
    for (int k = 0; k <= merging.pieces().dimension(); ++k)
        result.push_back(lift.matrix(k));
    return result;
}

} // namespace polydec
