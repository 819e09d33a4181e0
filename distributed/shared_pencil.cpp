// SPDX-License-Identifier: MIT
#include "distributed/shared_pencil.h"

#include "base/checks.h"
#include "base/errors.h"
#include "dec/stars/star.h"
#include "distributed/petsc_calls.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace polydec {

namespace {

constexpr double unit_of_rounding = std::numeric_limits<double>::epsilon() / 2;

/// Throws unless a star is positive, but for zeros where these do no harm.
void check_positive(const HodgeStar& star, bool zeros_too) {
    auto bad = star.negatives();
    const auto zeros = star.zeros();
    if (zeros_too)
        bad.insert(bad.end(), zeros.begin(), zeros.end());
    std::sort(bad.begin(), bad.end());
    if (!bad.empty())
        throw InvalidInput(
            fmt::format("star_{} is not positive on cells {}: the mesh is not Delaunay there; "
                        "stars that are positive on every mesh need a single process",
                        star.degree(), star.numbers(bad)),
            star.place(bad));
}

OwnedMat absolute(Mat matrix) {
    OwnedMat result = copied(matrix);
    Mat diagonal = nullptr, others = nullptr;
    require(MatMPIAIJGetSeqAIJ(result.get(), &diagonal, &others, nullptr), "copying");
    for (Mat part : {diagonal, others}) {
        MatInfo info;
        double* entries = nullptr;
        require(MatGetInfo(part, MAT_LOCAL, &info), "copying");
        require(MatSeqAIJGetArray(part, &entries), "copying");
        for (PetscInt e = 0; e < static_cast<PetscInt>(info.nz_used); ++e)
            entries[e] = std::abs(entries[e]);
        require(MatSeqAIJRestoreArray(part, &entries), "copying");
    }
    return result;
}

double longest_row(const Ranks& ranks, Mat matrix) {
    PetscInt begin = 0, end = 0;
    require(MatGetOwnershipRange(matrix, &begin, &end), "looking at a matrix");
    PetscInt longest = 0;
    for (PetscInt row = begin; row < end; ++row) {
        PetscInt count = 0;
        require(MatGetRow(matrix, row, &count, nullptr, nullptr), "looking at a matrix");
        longest = std::max(longest, count);
        require(MatRestoreRow(matrix, row, &count, nullptr, nullptr), "looking at a matrix");
    }
    return static_cast<double>(ranks.largest(GlobalIndex{longest}));
}

/// A scaled by diagonal matrices from both sides.
void scale(const Ranks& ranks, Mat A, const Vector& left, const Vector& right) {
    const OwnedVec l = vector_of(ranks, left), r = vector_of(ranks, right);
    require(MatDiagonalScale(A, l.get(), r.get()), "scaling");
}

} // namespace

SharedPencil::SharedPencil(const Ranks& ranks, const DistributedCells& cells, int k)
    : ranks_(ranks) {
    check_number("a Laplacian of degree", k, 0, cells.dimension());
    size_ = cells.degree(k).count;
    const auto star_of = [&](int degree) { return HodgeStar(cells.volumes, degree); };
    ranks.together("stars", [&] {
        check_positive(star_of(k), true);
        if (k < cells.dimension())
            check_positive(star_of(k + 1), false);
        if (k > 0)
            check_positive(star_of(k - 1), true);
    });
    mass_ = star_of(k).diagonal();
    const double share =
        std::min(0.5, ranks.largest(mass_.size() > 0
                                        ? star_of(k).uncertainty().cwiseQuotient(mass_).maxCoeff()
                                        : 0.0));
    mass_share_ = share / (1 - share);
    if (k < cells.dimension()) {
        const HodgeStar above = star_of(k + 1);
        OwnedMat d = coboundary(ranks, cells, k);
        OwnedMat back = transposed(d.get());
        add_part(std::move(d), std::move(back), above.diagonal().cwiseMax(0), above.uncertainty());
    }
    if (k > 0) {
        const HodgeStar below = star_of(k - 1);
        const Vector inverse = ranks.together("inverse star", [&] { return below.inverse(); });
        const Vector shares = below.uncertainty().cwiseProduct(inverse.cwiseAbs()).cwiseMin(0.5);
        OwnedMat up = coboundary(ranks, cells, k - 1); // F^T = star_k d
        scale(ranks, up.get(), mass_, Vector::Ones(inverse.size()));
        OwnedMat down = transposed(up.get());
        add_part(std::move(down), std::move(up), inverse,
                 (inverse.array() * shares.array() / (1 - shares.array())).matrix());
    }
    measure();
}

void SharedPencil::add_part(OwnedMat F, OwnedMat transposed, Vector weights, Vector uncertainty) {
    OwnedMat sizes = absolute(F.get()), transposed_sizes = absolute(transposed.get());
    roundoff_ = std::max(roundoff_, unit_of_rounding * (longest_row(ranks_, F.get()) +
                                                        longest_row(ranks_, transposed.get()) + 8));
    parts_.push_back({std::move(F), std::move(transposed), std::move(sizes),
                      std::move(transposed_sizes), std::move(weights), std::move(uncertainty)});
}

/// The matrix, and what is known of its eigenvalues.
void SharedPencil::measure() {
    const Vector root = mass_.cwiseSqrt().cwiseInverse();
    for (const Part& part : parts_) {
        OwnedMat right = copied(part.F.get());
        scale(ranks_, right.get(), part.weights, Vector::Ones(mass_.size()));
        OwnedMat product = multiplied(part.transposed.get(), right.get());
        if (!B_)
            B_ = std::move(product);
        else
            require(MatAXPY(B_.get(), 1, product.get(), DIFFERENT_NONZERO_PATTERN), "adding");
    }
    scale(ranks_, B_.get(), root, root);
    require(MatSetOption(B_.get(), MAT_SYMMETRIC, PETSC_TRUE), "taking over a matrix");
    require(MatNorm(B_.get(), NORM_INFINITY, &norm_), "looking at a matrix");

    const OwnedVec diagonal = vector_of(ranks_, mass_);
    require(MatGetDiagonal(B_.get(), diagonal.get()), "looking at a matrix");
    double inverses = 0, count = 0;
    for (const double entry : own_entries(diagonal.get()))
        if (entry > 0) {
            inverses += 1 / entry;
            ++count;
        }
    inverses = ranks_.sum(inverses);
    count = ranks_.sum(count);
    const double typical = inverses > 0 ? count / inverses : norm_ > 0 ? norm_ : 1;
    small_ = std::max(1e-3 * typical / std::sqrt(static_cast<double>(size_)), 1e-12 * norm_);
}

SharedPencil::SharedImage SharedPencil::apply(const Vector& x) const {
    SharedImage image{Vector::Zero(x.size()), Vector::Zero(x.size())};
    for (const Part& part : parts_) {
        const Vector Fx = product(ranks_, part.F.get(), x);
        image.Ax += product(ranks_, part.transposed.get(), part.weights.cwiseProduct(Fx));
        const Vector sizes = product(ranks_, part.sizes.get(), x.cwiseAbs());
        image.doubt +=
            product(ranks_, part.transposed_sizes.get(),
                    Vector(roundoff_ * part.weights.cwiseAbs().cwiseProduct(sizes) +
                           part.uncertainty.cwiseProduct(Fx.cwiseAbs() + roundoff_ * sizes)));
    }
    return image;
}

Enclosure SharedPencil::enclose(const Vector& y) const {
    const Vector x = mass_.cwiseSqrt().cwiseInverse().cwiseProduct(y);
    const auto [Ax, doubts] = apply(x);
    const Vector Mx = mass_.cwiseProduct(x);
    const double square = ranks_.sum(x.dot(Mx));
    Enclosure result;
    result.value = ranks_.sum(x.dot(Ax)) / square;
    const Vector residual = Ax - result.value * Mx;
    const double size = std::abs(result.value);
    const Vector doubt = doubts + 8 * unit_of_rounding * size * Mx.cwiseAbs();
    // in the norm of M^-1
    const auto norm = [&](const Vector& v) {
        return std::sqrt(ranks_.sum(v.cwiseAbs2().cwiseQuotient(mass_).sum()) / square);
    };
    // what the sums above have lost is far below a millionth
    constexpr double safety = 1 + 1e-6;
    const auto widened = [&](double radius) {
        return safety * (radius * (1 + mass_share_) + mass_share_ * size);
    };
    result.doubt = widened(norm(doubt));
    result.radius = widened(norm(Vector(residual.cwiseAbs() + doubt)));
    result.energy = std::numeric_limits<double>::infinity();
    result.residual =
        std::sqrt(ranks_.sum(residual.squaredNorm())) / std::sqrt(ranks_.sum(Mx.squaredNorm()));
    return result;
}

std::vector<Enclosure> SharedPencil::enclose(const DenseMatrix& Y) const {
    std::vector<Enclosure> result;
    for (Index j = 0; j < Y.cols(); ++j)
        result.push_back(enclose(Vector(Y.col(j))));
    return result;
}

DenseMatrix SharedPencil::eigenvectors(const DenseMatrix& Y) const {
    return mass_.cwiseSqrt().cwiseInverse().asDiagonal() * Y;
}

DenseMatrix SharedPencil::products(const DenseMatrix& X, const DenseMatrix& Y) const {
    DenseMatrix result = X.transpose() * Y;
    ranks_.add_up({result.data(), static_cast<std::size_t>(result.size())});
    return result;
}

} // namespace polydec
