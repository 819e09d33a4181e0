// SPDX-License-Identifier: MIT
#include "shape/lehmann_bounds.h"

#include "backends/blas.h"
#include "base/decompositions.h"
#include "base/parallel.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace polydec {

namespace {

/// P of one simplex, on its unknowns m and, behind these, the unknown u of its cell.
class LocalDrop {
public:
    explicit LocalDrop(const FormFamily& family) : family_(family) {}

    /// Whether P is positive definite in spite of rounding.
    bool compute(Index simplex, double s, double t, const Vector& doubt) {
        family_.drop(simplex, s, t, doubt, form_, mass_);
        form_.diagonal() *= 1 - form_.rows() * (32 * std::numeric_limits<double>::epsilon());
        root_.compute(form_);
        cell_ = &family_.cell(simplex);
        return root_.info() == Eigen::Success && (cell_->size() == 0 || mass_ > 0);
    }

    /// Y P, for rows Y.
    DenseMatrix of(const Eigen::Ref<const DenseMatrix>& Y) const {
        const Eigen::Index width = form_.rows();
        if (cell_->size() == 0)
            return Y * form_;
        DenseMatrix image(Y.rows(), Y.cols());
        image.leftCols(width) =
            (Y.leftCols(width) - Y.col(width) * cell_->transpose()).lazyProduct(form_);
        image.col(width) = mass_ * Y.col(width) - image.leftCols(width) * *cell_;
        return image;
    }

    /// Overwrites V with W, W W^T = V P^-1 V^T.
    void unroot(Eigen::Ref<DenseMatrix> V) const {
        const Eigen::Index width = form_.rows();
        if (cell_->size() > 0) {
            V.col(width) += V.leftCols(width) * *cell_;
            V.col(width) /= std::sqrt(mass_);
        }
        const DenseMatrix& root = root_.matrixLLT();
        for (Eigen::Index i = 0; i < width; ++i) {
            for (Eigen::Index k = 0; k < i; ++k)
                V.col(i) -= root(i, k) * V.col(k);
            V.col(i) /= root(i, i);
        }
    }

private:
    const FormFamily& family_;
    DenseMatrix form_;
    double mass_ = 0;
    Eigen::LLT<DenseMatrix> root_;
    const Vector* cell_ = nullptr;
};

/// A X, without the rounding of sums that cancel.
LongMatrix product(const SparseMatrix& A, const DenseMatrix& X) {
    LongMatrix result = LongMatrix::Zero(X.rows(), X.cols());
    for (Index row = 0; row < A.rows(); ++row)
        for (SparseMatrix::InnerIterator entry(A, row); entry; ++entry)
            result.row(row) +=
                static_cast<long double>(entry.value()) * X.row(entry.col()).cast<long double>();
    return result;
}

/// Ascending; not finite if they cannot be computed.
Vector generalized_eigenvalues(const DenseMatrix& A, const DenseMatrix& B) {
    const Eigen::GeneralizedSelfAdjointEigenSolver<DenseMatrix> pencil((A + A.transpose()) / 2, B,
                                                                       Eigen::EigenvaluesOnly);
    if (pencil.info() != Eigen::Success)
        return Vector::Constant(A.rows(), std::numeric_limits<double>::quiet_NaN());
    return pencil.eigenvalues();
}

} // namespace

LehmannBounds::LehmannBounds(const FamilyCounter& counter, double near, const DenseMatrix& X)
    : family_(counter.family()), t_(counter.counted_at()) {
    const Index width = family_.width(), simplices = family_.simplices();
    const bool has_cells = simplices > 0 && family_.cell(0).size() > 0;
    rows_ = width + (has_cells ? 1 : 0);
    doubts_.resize(width, simplices);
    residues_ = DenseMatrix::Zero(X.cols(), Eigen::Index(rows_) * simplices);
    vectors_ = residues_;
    DenseMatrix loads = DenseMatrix::Zero(X.rows(), X.cols()), Y;
    DenseMatrix of_cells = DenseMatrix::Zero(X.cols(), X.cols());
    FormFamily::Elimination cell;
    // unknowns of cells from the others
    const auto take = [&](Index s, const DenseMatrix& from) {
        family_.restrict_to(s, from, Y);
        part(vectors_, s).leftCols(width) = Y.transpose();
        if (!has_cells)
            return;
        cell = family_.elimination(s, t_);
        part(vectors_, s).col(width) =
            Y.transpose() * cell.weights + part(residues_, s).col(width) / cell.pivot;
    };
    LocalDrop drop(family_);
    for (Index s = 0; s < simplices; ++s) {
        doubts_.col(s) = family_.doubt(s, t_);
        if (!drop.compute(s, near, t_, doubts_.col(s)))
            return;
        take(s, X);
        DenseMatrix image = drop.of(part(vectors_, s));
        part(residues_, s) = image;
        if (has_cells) {
            of_cells.noalias() += image.col(width) * image.col(width).transpose() / cell.pivot;
            image.leftCols(width) += image.col(width) * cell.weights.transpose();
        }
        family_.add_to(loads, s, image.transpose());
    }
    const DenseMatrix Z = counter.solve(loads);
    const LongMatrix AZ = product(*counter.counted().matrix, Z);
    const DenseMatrix rest = family_.summands().cwiseInverse().asDiagonal() *
                             (AZ - loads.cast<long double>()).cast<double>();
    for (Index s = 0; s < simplices; ++s) {
        take(s, Z);
        family_.restrict_to(s, rest, Y);
        part(residues_, s).leftCols(width) += Y.transpose();
    }
    const DenseMatrix energies =
        -(Z.transpose().cast<long double>() * AZ).cast<double>() - of_cells;
    if (Eigen::LLT<DenseMatrix>(energies).info() == Eigen::Success)
        energies_ = (energies + energies.transpose()) / 2;
}

std::optional<LehmannBounds::Ratios> LehmannBounds::ratios(double s) const {
    constexpr Index size = 64;
    const Index simplices = family_.simplices();
    const DenseMatrix zero = DenseMatrix::Zero(energies_.rows(), energies_.rows());
    std::vector<std::array<DenseMatrix, 2>> sums((simplices + size - 1) / size, {zero, zero});
    std::vector<char> fails(sums.size(), zero.size() == 0);
    for_each_part(simplices, size, [&](Index begin, Index end) {
        const Eigen::Index first = Eigen::Index(rows_) * begin, columns = rows_ * (end - begin);
        DenseMatrix images = vectors_.middleCols(first, columns),
                    roots = residues_.middleCols(first, columns);
        LocalDrop drop(family_);
        for (Index i = begin; i < end && !fails[begin / size]; ++i) {
            fails[begin / size] = !drop.compute(i, s, t_, doubts_.col(i));
            part(images, i - begin) = drop.of(part(images, i - begin));
            drop.unroot(part(roots, i - begin));
        }
        const DenseMatrix R = roots.transpose(), I = images.transpose(),
                          V = vectors_.middleCols(first, columns).transpose();
        sums[begin / size] = {transposed_product(R, R), transposed_product(V, I)};
    });
    if (std::find(fails.begin(), fails.end(), true) != fails.end())
        return std::nullopt;
    auto& [of_residues, of_vectors] = sums[0];
    for (std::size_t i = 1; i < sums.size(); ++i) {
        of_residues += sums[i][0];
        of_vectors += sums[i][1];
    }
    constexpr double rounding = 1e-10;
    const Vector most = generalized_eigenvalues(of_residues, energies_),
                 least = generalized_eigenvalues(of_vectors, energies_);
    if (!most.allFinite() || !least.allFinite())
        return std::nullopt;
    return Ratios{(1 + rounding) * most.reverse(), least.cwiseInverse()};
}

} // namespace polydec
