// SPDX-License-Identifier: MIT
#include "backends/component.h"
#include "backends/linear/checked_solver.h"
#include "backends/linear/one_thread.h"
#include "base/errors.h"

#include <fmt/format.h>

#include <dlfcn.h>
#include <dmumps_c.h>
#include <memory>
#include <mutex>
#include <new>
#include <vector>

namespace polydec {

namespace {

// Numbers of the users' guide to MUMPS 5, from 1.
enum Control {
    error_stream = 1,
    diagnostic_stream = 2,
    information_stream = 3,
    matching = 6,
    ordering = 7,
    refinement = 10,
    sequential_root = 13,
    spare_room = 14, // percent of what the analysis estimates
    null_pivots = 24
};
constexpr int negative_pivot_count = 12, null_pivot_count = 28;
// Nested dissection by METIS, or, where MUMPS was built without, by what it has instead.
constexpr int by_degree = 0, by_dissection = 5;

enum class Job { start = -1, end = -2, analyze = 1, factorize = 2, solve = 3 };

// Delayed pivots may take more than the analysis has estimated.
constexpr int most_room = 1000;

// MUMPS keeps state outside of what it is handed.
std::mutex mumps_mutex;

/// One matrix in the hands of MUMPS.
class MumpsRun {
public:
    MumpsRun() {
        data_.sym = 2; // symmetric, any signs
        data_.par = 1;
        data_.comm_fortran = -987654; // what it calls all of MPI, which is this process here
        run(Job::start);
        for (const int stream : {error_stream, diagnostic_stream, information_stream})
            control(stream) = -1;
        control(4) = 0;
        control(matching) = 0;
        control(refinement) = 0;
        control(sequential_root) = 1; // else pivots of the last front are not counted
        control(null_pivots) = 1;     // told, instead of divided by
    }
    ~MumpsRun() { run(Job::end); }
    MumpsRun(const MumpsRun&) = delete;
    MumpsRun& operator=(const MumpsRun&) = delete;

    /// What MUMPS returns: negative for errors.
    int run(Job job) {
        const std::lock_guard lock(mumps_mutex);
        data_.job = static_cast<MUMPS_INT>(job);
        dmumps_c(&data_);
        return data_.infog[0];
    }

    MUMPS_INT& control(int number) { return data_.icntl[number - 1]; }
    int told(int number) const { return data_.infog[number - 1]; }
    DMUMPS_STRUC_C& data() { return data_; }

private:
    DMUMPS_STRUC_C data_{};
};

class Mumps final : public CheckedSolver {
public:
    explicit Mumps(const LinearSolverOptions& options)
        : CheckedSolver("mumps", {.symmetry = Symmetry::symmetric, .inertia = Inertia::wanted},
                        options) {}

protected:
    void compute(const SparseMatrix& A, const MatrixFacts& facts, Pattern pattern) override {
        const OneThread one;
        const bool is_new = pattern == Pattern::fresh || !run_;
        if (is_new)
            run_ = std::make_unique<MumpsRun>();
        take_lower_triangle(A);
        if (is_new) {
            run_->control(ordering) = domain_dimension(A, facts) > 2 ? by_dissection : by_degree;
            require(run_->run(Job::analyze), "analysis");
        }
        factorize_with_room();

        if (const int count = run_->told(null_pivot_count); count > 0)
            fail(fmt::format("{} zero pivots: the matrix is singular\n"
                             "Move the shift, give the kernel in the facts, or use eigen.lu.",
                             count));
        set_negative_pivots(run_->told(negative_pivot_count), facts);
    }

    Solution apply_inverse(const DenseMatrix& B) override {
        const OneThread one;
        DenseMatrix X = B;
        auto& data = run_->data();
        data.nrhs = static_cast<MUMPS_INT>(X.cols());
        data.lrhs = static_cast<MUMPS_INT>(X.rows());
        data.rhs = X.data();
        require(run_->run(Job::solve), "solution");
        return {std::move(X)};
    }

private:
    void take_lower_triangle(const SparseMatrix& A) {
        rows_.clear();
        columns_.clear();
        values_.clear();
        for (Index row = 0; row < A.rows(); ++row)
            for (SparseMatrix::InnerIterator entry(A, row); entry && entry.col() <= row; ++entry) {
                rows_.push_back(row + 1);
                columns_.push_back(static_cast<MUMPS_INT>(entry.col()) + 1);
                values_.push_back(entry.value());
            }
        auto& data = run_->data();
        data.n = static_cast<MUMPS_INT>(A.rows());
        data.nnz = static_cast<MUMPS_INT8>(values_.size());
        data.irn = rows_.data();
        data.jcn = columns_.data();
        data.a = values_.data();
    }

    void factorize_with_room() {
        constexpr int too_little_for_integers = -8, too_little = -9;
        int answer = run_->run(Job::factorize);
        while ((answer == too_little || answer == too_little_for_integers) &&
               run_->control(spare_room) < most_room) {
            run_->control(spare_room) *= 2;
            answer = run_->run(Job::factorize);
        }
        require(answer, "factorization");
    }

    void require(int answer, const char* step) {
        if (answer >= 0)
            return;
        run_.reset();
        switch (answer) {
        case -5:
        case -7:
        case -8:
        case -9:
        case -13:
            throw std::bad_alloc();
        case -6:
        case -10:
            fail("zero pivot: the matrix is singular\n"
                 "Move the shift, give the kernel in the facts, or use eigen.lu.");
        case -51:
        case -52:
            fail(
                fmt::format("{}: the matrix is too large for 32-bit numbers\nUse eigen.cg.", step));
        default:
            fail(fmt::format("{}: MUMPS's error {}", step, answer));
        }
    }

    std::unique_ptr<MumpsRun> run_; // null before the first analysis, and where it failed
    std::vector<MUMPS_INT> rows_, columns_;
    std::vector<double> values_;
};

} // namespace

void component::add_mumps(EngineRegistrar& registrar) {
    // MUMPS comes with a stand-in for MPI under the same names, which a real one would hide.
    if (dlsym(RTLD_DEFAULT, "MPI_Init_thread"))
        throw BackendUnavailable(
            "mumps: the program uses MPI, but this is the sequential MUMPS: use another engine");
    registrar.add({.name = "mumps"}, [](const LinearSolverOptions& options) {
        return std::make_unique<Mumps>(options);
    });
}

} // namespace polydec
