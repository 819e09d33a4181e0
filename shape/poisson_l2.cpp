// SPDX-License-Identifier: MIT
#include "backends/registry.h"
#include "backends/spectra/inertia.h"
#include "shape/poisson_pair.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace polydec {

namespace {

/// The integrals of means over simplices against functions of facets, or of vertices: simplices x
/// unknowns.
SparseMatrix loads(const PoissonForms& forms, const PoissonForms::System& system) {
    const int width = forms.dimension() + 1;
    std::vector<Eigen::Triplet<double, Index>> entries;
    for (Index s = 0; s < forms.simplices(); ++s)
        for (int i = 0; i < width; ++i)
            if (const Index u = system.unknowns[std::size_t(width) * s + i]; u >= 0)
                entries.emplace_back(s, u, forms.volumes()[s] / width);
    SparseMatrix B(forms.simplices(), system.K.rows());
    B.setFromTriplets(entries.begin(), entries.end());
    return B;
}

/// An estimate of the greatest eigenvalue k^2 of
/// c D + B_CR K_CR^-1 B_CR^T - B_P1 K_P1^-1 B_P1^T against D, the areas.
double estimate(const PoissonForms& forms, const SparseMatrix& on_facets,
                const SparseMatrix& on_vertices) {
    const auto& volumes = forms.volumes();
    const Vector roots = volumes.cwiseSqrt();
    const auto subtract_means = [&](Vector& f) { // they count where constants are not free alone
        f -= forms.free_means(f.cwiseProduct(volumes));
    };
    const SymmetricOperator A{
        forms.simplices(), [&](const Vector& x, Vector& y) {
            Vector f = x.cwiseQuotient(roots);
            subtract_means(f);
            Vector image = f.cwiseProduct(volumes).cwiseProduct(forms.bubbles());
            if (on_facets.cols() > 0)
                image += on_facets * forms.facets().solve(on_facets.transpose() * f);
            if (on_vertices.cols() > 0)
                image -= on_vertices * forms.vertices().solve(on_vertices.transpose() * f);
            f = image.cwiseQuotient(volumes);
            subtract_means(f);
            y = f.cwiseProduct(roots);
        }};
    const auto largest = make_eigen_solver("spectra")->largest(A, 1, {.tolerance = 1e-3});
    return largest.converged > 0 ? largest.values[0] : 0;
}

/// The rows of facets and vertices in the matrix whose inertia tells, -1 for those left out.
///
/// Where constants are free, a function on facets is fixed to 0 at one of them, which leaves the
/// energy of its answer to loads of mean 0 as it is. The constants at vertices are multipliers that
/// keep the means of loads at 0.
struct Places {
    std::vector<Index> facets, vertices;
    Index of_vertices = 0, size = 0;

    explicit Places(const PoissonForms& forms)
        : facets(forms.facets().K.rows(), 0), vertices(forms.vertices().K.rows(), 0) {
        for (const auto& constant : forms.facets().kernel.colwise()) {
            Eigen::Index fixed = 0;
            constant.maxCoeff(&fixed);
            facets[fixed] = -1;
        }
        for (auto* places : {&facets, &vertices}) {
            const Index before = size;
            for (Index& place : *places)
                place = place < 0 ? -1 : size++;
            of_vertices = size - before;
        }
    }
};

/// That matrix, as triplets, with what its entries may be off by. The loads on simplices, of which
/// each one meets no other, are eliminated before: so the block of vertices is definite.
class Blocks {
public:
    explicit Blocks(Index size) : size_(size), sizes_(Vector::Zero(size)), counts_(sizes_) {}

    void add(const SparseMatrix& A, double sign, const std::vector<Index>& places) {
        for (Index i = 0; i < A.rows(); ++i)
            for (SparseMatrix::InnerIterator at(A, i); at; ++at)
                if (const Index r = places[i], c = places[at.col()]; r >= 0 && c >= 0)
                    add(r, c, sign * at.value(), 1);
    }

    /// Eliminates a load with this entry, which is so many times smaller than its terms.
    void eliminate(double entry, double cancelled,
                   const std::vector<std::pair<Index, double>>& row) {
        for (const auto& [i, a] : row)
            for (const auto& [j, b] : row)
                add(i, j, -(a * b) / entry, cancelled);
    }

    /// Negative eigenvalues, if they can be told; `doubt` is of the matrices added.
    std::optional<Index> negative(const std::string& engine, int dimension, double doubt) const {
        if (size_ == 0)
            return 0;
        SparseMatrix matrix(size_, size_);
        matrix.setFromTriplets(entries_.begin(), entries_.end());
        constexpr double rounding = 16 * std::numeric_limits<double>::epsilon();
        return TrustedInertia(engine, dimension)
            .negative(matrix, sizes_, doubt + rounding * counts_.maxCoeff());
    }

private:
    void add(Index i, Index j, double value, double cancelled) {
        entries_.emplace_back(i, j, value);
        counts_[i] += 1;
        if (i == j)
            sizes_[i] += std::abs(value) * cancelled;
    }

    Index size_;
    std::vector<Eigen::Triplet<double, Index>> entries_;
    Vector sizes_, counts_;
};

/// Whether k^2 is proved: as many negative eigenvalues as functions at vertices.
bool is_proved(const PoissonForms& forms, const SparseMatrix& on_facets,
               const SparseMatrix& on_vertices, double square, const std::string& engine) {
    const Places places(forms);
    Blocks blocks(places.size);
    blocks.add(forms.facets().K, 1, places.facets);
    blocks.add(forms.vertices().K, -1, places.vertices);
    Index negative = 0;
    for (Index s = 0; s < forms.simplices(); ++s) {
        constexpr double half_of_the_digits = 1e8;
        const double bubble = forms.bubbles()[s], rest = square - bubble;
        const double cancelled = (square + bubble) / std::abs(rest);
        if (!(cancelled < half_of_the_digits))
            return false;
        negative += rest < 0 ? 1 : 0;
        std::vector<std::pair<Index, double>> row;
        for (const auto& [B, columns] :
             {std::pair(&on_facets, &places.facets), std::pair(&on_vertices, &places.vertices)})
            for (SparseMatrix::InnerIterator at(*B, s); at; ++at)
                if (const Index column = (*columns)[at.col()]; column >= 0)
                    row.emplace_back(column, at.value());
        blocks.eliminate(rest * forms.volumes()[s], cancelled, row);
    }
    const auto others =
        blocks.negative(engine, forms.dimension(), forms.facets().doubt + forms.vertices().doubt);
    return others && negative + *others == places.of_vertices;
}

} // namespace

std::optional<double> l2_constant_squared(const PoissonForms& forms, const std::string& engine) {
    double largest = 0;
    for (Index s = 0; s < forms.simplices(); ++s)
        largest = std::max(largest, forms.poincare(s));
    const SparseMatrix on_facets = loads(forms, forms.facets()),
                       on_vertices = loads(forms, forms.vertices());
    double square = std::max(1.01 * estimate(forms, on_facets, on_vertices), 1e-3 * largest);
    for (int attempt = 0; attempt < 6; ++attempt, square *= 1.5)
        if (is_proved(forms, on_facets, on_vertices, square, engine))
            return square + largest;
    return std::nullopt;
}

} // namespace polydec
