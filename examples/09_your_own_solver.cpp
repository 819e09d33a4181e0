// SPDX-License-Identifier: MIT
//
// An engine is any type with Eigen's compute(A) and solve(B). Registered under a name, it serves
// every solver of polydec. polydec checks its solutions as for any other engine. This engine is
// plain Gauss-Seidel iteration, in about forty lines.
#include <cmath>
#include <iostream>
#include <polydec.h>

namespace {

class GaussSeidel {
public:
    void compute(const polydec::SparseMatrix& A) { A_ = &A; }

    polydec::DenseMatrix solve(const polydec::DenseMatrix& B) {
        polydec::DenseMatrix X = polydec::DenseMatrix::Zero(B.rows(), B.cols());
        for (sweeps_ = 0; sweeps_ < 100000; ++sweeps_) {
            if ((B - *A_ * X).norm() <= 1e-11 * B.norm())
                break;
            for (polydec::Index i = 0; i < A_->rows(); ++i)
                relax(i, B, X);
        }
        return X;
    }

    polydec::Index iterations() const { return sweeps_; }

private:
    /// Solves equation i for unknown i.
    void relax(polydec::Index i, const polydec::DenseMatrix& B, polydec::DenseMatrix& X) const {
        Eigen::RowVectorXd rest = B.row(i);
        double diagonal = 0;
        for (polydec::SparseMatrix::InnerIterator a(*A_, i); a; ++a)
            if (a.col() == i)
                diagonal = a.value();
            else
                rest -= a.value() * X.row(a.col());
        X.row(i) = rest / diagonal;
    }

    const polydec::SparseMatrix* A_ = nullptr;
    polydec::Index sweeps_ = 0;
};

} // namespace

int main() {
    polydec::register_engine(
        "gauss-seidel", polydec::adapt<GaussSeidel>(
                            "gauss-seidel", {.method = polydec::Method::iterative,
                                             .symmetry = polydec::Symmetry::symmetric,
                                             .definiteness = polydec::Definiteness::positive}));

    const auto mesh = polydec::discretize(polydec::grid(24, 24));
    const auto solve = [&](const char* engine) {
        const polydec::PoissonSolver solver({mesh, polydec::Side::primal, 0, {}}, engine);
        const polydec::Vector one = polydec::Vector::Ones(mesh.complex().size(0));
        const auto found = solver.solve({polydec::Side::primal, 0, one});
        std::cout << found.report.engine << ": " << found.report.iterations
                  << " iterations, largest value " << found.form.values.maxCoeff() << '\n';
        return found.form.values;
    };
    const polydec::Vector mine = solve("gauss-seidel"), theirs = solve("eigen.ldlt");
    std::cout << "they agree to 1e-9: " << ((mine - theirs).norm() < 1e-9 ? "yes" : "no") << '\n';
}
