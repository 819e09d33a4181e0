// SPDX-License-Identifier: MIT
#pragma once

#include "base/lazy.h"
#include "base/shared.h"
#include "base/types.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace polydec {

/// A face of a cell, with sign 1 or -1; 2 if both are glued to themselves on a one-sided surface.
struct SignedFace {
    Index face;
    int sign;
};

/// The faces of one cell, ascending, with their signs.
class IncidenceRow {
public:
    class Iterator {
    public:
        Iterator(const Index* face, const std::int8_t* sign) : face_(face), sign_(sign) {}
        SignedFace operator*() const { return {*face_, *sign_}; }
        Iterator& operator++() {
            ++face_;
            ++sign_;
            return *this;
        }
        bool operator!=(const Iterator& other) const { return face_ != other.face_; }

    private:
        const Index* face_;
        const std::int8_t* sign_;
    };

    IncidenceRow(const Index* faces, const std::int8_t* signs, Index size)
        : faces_(faces), signs_(signs), size_(size) {}

    Index size() const { return size_; }
    SignedFace operator[](Index i) const { return {faces_[i], signs_[i]}; }
    Iterator begin() const { return {faces_, signs_}; }
    Iterator end() const { return {faces_ + size_, signs_ + size_}; }

private:
    const Index* faces_;
    const std::int8_t* signs_;
    Index size_;
};

/// The (k+1)-cells of a complex with the k-cells that bound them: the entries of d_k. Cells with
/// equal numbers of faces and alternating signs, such as simplices, need only a table of faces;
/// others a matrix. An immutable handle.
class Incidences {
public:
    using Signs = std::vector<std::int8_t>;

    /// Cells of any kind: rows ascending, without zeros.
    explicit Incidences(IncidenceMatrix&& matrix);

    /// Each row lists the faces of a cell, ascending. The last face has the cell's sign (1 without
    /// `signs`), the face before it the opposite sign, and so on.
    Incidences(std::shared_ptr<const Simplices> faces, Index cols,
               std::shared_ptr<const Signs> signs = nullptr);

    /// The same table of faces with other signs of the rows.
    Incidences with_signs(std::shared_ptr<const Signs> signs) const;

    /// Numbers of (k+1)-cells, of k-cells, and of faces of all cells.
    Index rows() const { return rows_; }
    Index cols() const { return cols_; }
    Index size() const { return begins_ ? begins_[rows_] : rows_ * width_; }

    /// The faces of a cell. For inner loops: the cell is not checked.
    IncidenceRow operator[](Index cell) const {
        if (begins_)
            return {faces_ + begins_[cell], signs_ + begins_[cell],
                    begins_[cell + 1] - begins_[cell]};
        const int turned = signs_ && signs_[cell] < 0 ? 1 : 0;
        return {faces_ + std::ptrdiff_t{width_} * cell, alternating(width_ + turned), width_};
    }

    /// The sign of a face in a cell; 0 if it is not a face.
    int sign(Index cell, Index face) const;

    /// d_k with entries of one byte; computed on first use, and kept.
    const IncidenceMatrix& matrix() const&;
    IncidenceMatrix matrix() && { return matrix(); }

    /// The same with doubles, and the transpose, recomputed at each call. Linear time.
    SparseMatrix real_matrix() const;
    IncidenceMatrix transposed() const;

    /// The table of faces; null if numbers of faces differ.
    const Index* table() const { return begins_ ? nullptr : faces_; }

    /// Calls work(rows) with rows for innermost loops: rows.for_each(cell, factor, take) calls
    /// take(face, sign * factor) for each face, and rows.size(cell) counts them. `work` is compiled
    /// for each kind of rows.
    template <class Work>
    void visit(Work work) const;

private:
    /// Alternating signs with 1 at index `width` - 1.
    static const std::int8_t* alternating(Index width) {
        static constexpr std::int8_t signs[] = {-1, 1, -1, 1, -1, 1, -1, 1, -1, 1, -1, 1,
                                                -1, 1, -1, 1, -1, 1, -1, 1, -1, 1, -1, 1,
                                                -1, 1, -1, 1, -1, 1, -1, 1, -1, 1, -1, 1};
        return signs + (width % 2);
    }

    template <class Scalar>
    Eigen::SparseMatrix<Scalar, Eigen::RowMajor, Index> make() const;

    Index rows_, cols_, width_ = 0;
    const Index *faces_, *begins_ = nullptr; // null: each row has width_ faces
    const std::int8_t* signs_;               // of entries; where rows have one width, of rows
    Shared<const Simplices> table_;
    Shared<const Signs> turns_;
    Shared<const Lazy<IncidenceMatrix>> matrix_;
};

/// Rows of `width` faces with alternating signs; width 0 means `given`.
template <int width>
struct AlternatingRows {
    const Index* faces;
    const std::int8_t* signs; // or null
    Index given;

    Index size(Index) const { return width > 0 ? width : given; }

    template <class Take>
    void for_each(Index cell, double factor, Take take) const {
        const Index count = size(cell);
        const Index* const face = faces + std::ptrdiff_t{count} * cell;
        // no branch on signs, which may be random
        const double last = signs ? signs[cell] * factor : factor;
        double value = count % 2 == 1 ? last : -last;
        for (Index i = 0; i < count; ++i, value = -value)
            take(face[i], value);
    }
};

/// Rows of any kind, as in a sparse matrix.
struct SignedRows {
    const Index *begins, *faces;
    const std::int8_t* signs;

    Index size(Index cell) const { return begins[cell + 1] - begins[cell]; }

    template <class Take>
    void for_each(Index cell, double factor, Take take) const {
        for (Index e = begins[cell]; e < begins[cell + 1]; ++e)
            take(faces[e], signs[e] * factor);
    }
};

template <class Work>
void Incidences::visit(Work work) const {
    if (begins_)
        work(SignedRows{begins_, faces_, signs_});
    else if (width_ == 2)
        work(AlternatingRows<2>{faces_, signs_, width_});
    else if (width_ == 3)
        work(AlternatingRows<3>{faces_, signs_, width_});
    else if (width_ == 4)
        work(AlternatingRows<4>{faces_, signs_, width_});
    else
        work(AlternatingRows<0>{faces_, signs_, width_});
}

} // namespace polydec
