// SPDX-License-Identifier: MIT
#include "backends/component.h"
#include "backends/linear/checked_solver.h"
#include "backends/linear/one_thread.h"

#include <cholmod.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <tuple>

namespace polydec {

namespace {

// Nested dissection pays from about this size on, and METIS is slow to start.
constexpr Eigen::Index small_for_metis = 1000;

// CHOLMOD's state, and everything that it has allocated.
struct Workspace {
    cholmod_common common{};
    cholmod_factor* factor = nullptr;
    cholmod_dense* x = nullptr;
    cholmod_dense* y = nullptr;
    cholmod_dense* e = nullptr;

    Workspace() {
        cholmod_start(&common);
        common.print = 0;
        common.error_handler = nullptr;
        common.nmethods = 1;
        common.postorder = 1;
        common.final_asis = 1;
        common.final_ll = 0;
        common.quick_return_if_not_posdef = 1;
    }
    ~Workspace() {
        cholmod_free_dense(&x, &common);
        cholmod_free_dense(&y, &common);
        cholmod_free_dense(&e, &common);
        cholmod_free_factor(&factor, &common);
        cholmod_finish(&common);
    }
    Workspace(const Workspace&) = delete;
    Workspace& operator=(const Workspace&) = delete;
};

// CHOLMOD never writes to what it is given, though its types do not say so.
cholmod_sparse view(const SparseMatrix& A) {
    cholmod_sparse result{};
    result.nrow = static_cast<std::size_t>(A.rows());
    result.ncol = static_cast<std::size_t>(A.cols());
    result.nzmax = static_cast<std::size_t>(A.nonZeros());
    result.p = const_cast<Index*>(A.outerIndexPtr());
    result.i = const_cast<Index*>(A.innerIndexPtr());
    result.x = const_cast<double*>(A.valuePtr());
    result.stype = 1; // symmetric, so rows are columns, and it reads one triangle only
    result.itype = CHOLMOD_INT;
    result.xtype = CHOLMOD_REAL;
    result.dtype = CHOLMOD_DOUBLE;
    result.sorted = 1;
    result.packed = 1;
    return result;
}

cholmod_dense view(const DenseMatrix& B) {
    cholmod_dense result{};
    result.nrow = static_cast<std::size_t>(B.rows());
    result.ncol = static_cast<std::size_t>(B.cols());
    result.nzmax = static_cast<std::size_t>(B.size());
    result.d = static_cast<std::size_t>(B.rows());
    result.x = const_cast<double*>(B.data());
    result.xtype = CHOLMOD_REAL;
    result.dtype = CHOLMOD_DOUBLE;
    return result;
}

class Cholmod final : public CheckedSolver {
public:
    explicit Cholmod(const LinearSolverOptions& options)
        : CheckedSolver("cholmod", {.symmetry = Symmetry::symmetric, .inertia = Inertia::wanted},
                        options) {}

protected:
    void compute(const SparseMatrix& A, const MatrixFacts& facts, Pattern pattern) override {
        const OneThread one;
        cholmod_sparse matrix = view(A);

        // Supernodal factors are L L^T and stop at the first negative pivot.
        const bool is_definite =
            facts.symmetry == Symmetry::symmetric && facts.definiteness == Definiteness::positive;
        const int mode = is_definite ? CHOLMOD_SUPERNODAL : CHOLMOD_SIMPLICIAL;
        const bool by_nested_dissection =
            A.rows() >= small_for_metis && domain_dimension(A, facts) > 2;
        if (pattern == Pattern::fresh || !work_.factor || work_.common.supernodal != mode) {
            work_.common.supernodal = mode;
            analyze(matrix, by_nested_dissection);
        }

        cholmod_factorize(&matrix, work_.factor, &work_.common);
        require_success("factorization");
        require_pivots(is_definite);
        set_negative_pivots(is_definite ? 0 : count_negative_pivots(), facts);
    }

    Solution apply_inverse(const DenseMatrix& B) override {
        const OneThread one;
        reserve(static_cast<std::size_t>(B.cols()));
        cholmod_dense right_hand_sides = view(B);
        cholmod_solve2(CHOLMOD_A, work_.factor, &right_hand_sides, nullptr, &work_.x, nullptr,
                       &work_.y, &work_.e, &work_.common);
        require_success("solution");
        return {Eigen::Map<const DenseMatrix>(static_cast<const double*>(work_.x->x), B.rows(),
                                              B.cols())};
    }

private:
    void analyze(cholmod_sparse& A, bool by_nested_dissection) {
        cholmod_free_factor(&work_.factor, &work_.common);
        if (by_nested_dissection) {
            work_.common.method[0].ordering = CHOLMOD_METIS;
            work_.factor = cholmod_analyze(&A, &work_.common);
        }
        // Some builds of CHOLMOD come without METIS.
        if (!work_.factor) {
            work_.common.method[0].ordering = CHOLMOD_AMD;
            work_.factor = cholmod_analyze(&A, &work_.common);
        }
        require_success("analysis");
        const auto& factor = *work_.factor; // values, and in single columns their rows too
        const double bytes = factor.is_super ? sizeof(double) * double(factor.xsize)
                                             : (sizeof(double) + sizeof(Index)) * work_.common.lnz;
        check_factor(bytes, static_cast<Eigen::Index>(factor.n));
    }

    void require_success(const char* step) const {
        switch (work_.common.status) {
        case CHOLMOD_TOO_LARGE:
            fail(fmt::format("{}: more than 2^31 - 1 entries in the factor\nUse eigen.cg.", step));
        case CHOLMOD_OUT_OF_MEMORY:
            throw std::bad_alloc();
        default:
            if (work_.common.status < CHOLMOD_OK)
                fail(fmt::format("{}: CHOLMOD's error {}", step, work_.common.status));
        }
    }

    // Of the two that cholmod_solve2 would allocate for supernodal factors it looks at the second
    // only.
    void reserve(std::size_t columns) {
        const auto& factor = *work_.factor;
        if (!factor.is_super)
            return;
        for (const auto& [place, rows, count] :
             {std::tuple{&work_.y, factor.n, columns}, {&work_.e, columns, factor.maxesize}})
            if (!cholmod_ensure_dense(place, rows, count, rows, CHOLMOD_REAL, &work_.common))
                require_success("solution");
    }

    void require_pivots(bool is_definite) const {
        const auto* const factor = work_.factor;
        if (work_.common.status == CHOLMOD_OK && factor->minor == factor->n)
            return;
        const auto row =
            static_cast<const Index*>(factor->Perm)[std::min(factor->minor, factor->n - 1)];
        if (is_definite)
            fail(fmt::format("the matrix is not positive definite, although its facts say so: row "
                             "{} has no positive pivot",
                             row));
        fail(fmt::format("zero pivot in row {}: the matrix, or a leading block of it, is singular\n"
                         "Move the shift, give the kernel in the facts, or use eigen.lu.",
                         row));
    }

    Index count_negative_pivots() const {
        const auto* const starts = static_cast<const Index*>(work_.factor->p);
        const auto* const values = static_cast<const double*>(work_.factor->x);
        Index negative = 0;
        for (std::size_t j = 0; j < work_.factor->n; ++j) {
            const double pivot = values[starts[j]];
            if (!std::isfinite(pivot))
                fail("the factorization overflows: the matrix is singular to working precision");
            negative += pivot < 0.0 ? 1 : 0;
        }
        return negative;
    }

    Workspace work_;
};

} // namespace

void component::add_cholmod(EngineRegistrar& registrar) {
    registrar.add({.name = "cholmod"}, [](const LinearSolverOptions& options) {
        return std::make_unique<Cholmod>(options);
    });
}

} // namespace polydec
