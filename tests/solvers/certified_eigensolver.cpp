// SPDX-License-Identifier: MIT
#include "tests/support/read_golden.h"
#include "tests/support/test.h"

namespace polydec::test::in_certified_eigensolver {

/// Spectra's solver with a fault: of the pairs it finds, only those that are kept come back.
class Forgetful : public EigenSolver {
public:
    using Keeps = std::function<bool(const Vector& values, Index i)>;

    Forgetful(std::string name, Keeps keeps) : name_(std::move(name)), keeps_(std::move(keeps)) {}

    std::string name() const override { return name_; }

protected:
    EigenPairs compute(const SymmetricOperator& A, Index count,
                       const EigenOptions& options) const override {
        auto all = make_eigen_solver("spectra")->largest(A, count, options);
        std::vector<Index> kept;
        for (Index i = 0; i < all.converged; ++i)
            if (keeps_(all.values, i))
                kept.push_back(i);
        const Vector values = all.values(kept);
        const DenseMatrix vectors = all.vectors(Eigen::indexing::all, kept);
        return {values, vectors, static_cast<Index>(kept.size()), all.operations};
    }

private:
    std::string name_;
    Keeps keeps_;
};

bool is_copy(const Vector& values, Index i) {
    return i > 0 && std::abs(values[i] - values[i - 1]) <= 1e-6 * std::abs(values[i]);
}

void register_forgetful(const std::string& name, const Forgetful::Keeps& keeps) {
    register_engine(name, [=] { return std::make_unique<Forgetful>(name, keeps); });
}

/// Two that lose pairs: every other one, and the second copy of every multiple eigenvalue.
void register_faulty_engines() {
    static const bool once = [] {
        register_forgetful("half", [](const Vector&, Index i) { return i % 2 == 0; });
        register_forgetful("second", [](const Vector& values, Index i) {
            return !is_copy(values, i) || (i > 1 && is_copy(values, i - 1));
        });
        return true;
    }();
    static_cast<void>(once);
}

TEST(FaultyEigensolver, is_found_out_and_the_answer_complete_all_the_same) {
    register_faulty_engines();
    for (const auto& generated : {icosphere(4), torus(16, 8), kuhn(3, 4)}) {
        const auto mesh = circumcentric(generated);
        for (int k = 0; k <= mesh.dimension(); ++k) {
            const Vector exact = dense_spectrum(mesh, k);
            for (const std::string engine : {"half", "second"})
                for (const Index count : {6, 20}) {
                    SCOPED_TRACE(testing::Message() << engine << ' ' << k << ' ' << count);
                    const auto found =
                        spectrum({mesh, Side::primal, k}, {.count = count, .eigen_solver = engine});
                    EXPECT_EQ(found.eigen_solver, engine);
                    EXPECT_TRUE(found.certificate.complete);
                    EXPECT_WITHIN(found.eigenvalues, exact.head(count),
                                  1e-8 * exact[count] + 1e-12 * exact[exact.size() - 1]);
                }
        }
    }
}

/// The broken twin of the test above: without the proof it would fail.
TEST(FaultyEigensolver, goes_unnoticed_where_the_proof_is_waived) {
    register_faulty_engines();
    const auto mesh = circumcentric(icosphere(4));
    const Vector exact = dense_spectrum(mesh, 0);
    const auto found =
        spectrum({mesh, Side::primal, 0},
                 {.count = 6, .eigen_solver = "second", .certification = Certification::waived});
    EXPECT_FALSE(found.certificate.complete);
    EXPECT_NEAR(found.eigenvalues[2], exact[2], 1e-8);
    EXPECT_GT(found.eigenvalues[3], exact[3] + 1);
}

TEST(ShareOfASpectrum, grows_without_being_computed_anew) {
    const auto mesh = circumcentric(icosphere(4));
    const Vector exact = dense_spectrum(mesh, 2);
    CertifiedEigensolver solver(symmetric_laplacian({mesh.complex(), mesh.volumes()}, 2),
                                star(mesh.volumes(), 2).diagonal());
    for (const Index count : {5, 30, 12, 60}) {
        const auto pairs = solver.smallest(count);
        EXPECT_WITHIN(pairs.values, exact.head(count), 1e-8 * exact[count]);
        EXPECT_TRUE(pairs.certificate.complete);
    }
}

TEST(ShareOfASpectrum, is_taken_by_blocks_where_it_is_large) {
    const auto mesh = circumcentric(icosphere(8));
    EXPECT_EQ(spectrum({mesh, Side::primal, 0}, {.count = 6}).eigen_solver, "spectra");
    EXPECT_EQ(spectrum({mesh, Side::primal, 0}, {.count = 40}).eigen_solver, "block-lanczos");
    const Vector exact = dense_spectrum(mesh, 0);
    for (const std::string engine : {"spectra", "block-lanczos"})
        for (const Index count : {1, 6, 40}) {
            SCOPED_TRACE(testing::Message() << engine << ' ' << count);
            const auto found =
                spectrum({mesh, Side::primal, 0}, {.count = count, .eigen_solver = engine});
            EXPECT_EQ(found.eigen_solver, engine);
            EXPECT_TRUE(found.certificate.complete);
            EXPECT_WITHIN(found.eigenvalues, exact.head(count), 1e-10 * exact[count]);
        }
}

TEST(WholeSpectrum, is_complete_without_a_count) {
    const auto mesh = circumcentric(icosphere(2));
    const Index size = mesh.complex().size(0);
    Index counts = 0;
    const auto found =
        spectrum({mesh, Side::primal, 0}, {.count = size, .progress = [&](std::string_view what) {
                                               counts += what == "counting" ? 1 : 0;
                                           }});
    EXPECT_EQ(counts, 0);
    EXPECT_EQ(found.certificate.below_shift, size);
    EXPECT_GT(found.certificate.shift, dense_spectrum(mesh, 0)[size - 1]);
    spectrum({mesh, Side::primal, 0}, {.count = size - 20, .progress = [&](std::string_view what) {
                                           counts += what == "counting" ? 1 : 0;
                                       }});
    EXPECT_EQ(counts, 1);
}

/// Diagonal of known eigenvalues, with masses 1, 2, 1, 2, ..
void expect_diagonal_solved(const Vector& exact, Index count) {
    const auto size = static_cast<Index>(exact.size());
    Vector mass(size);
    SparseMatrix A(size, size);
    for (Index i = 0; i < size; ++i) {
        mass[i] = 1 + i % 2;
        A.insert(i, i) = mass[i] * exact[i];
    }
    const auto pairs = CertifiedEigensolver(A, mass).smallest(count);
    EXPECT_WITHIN(pairs.values, exact.head(count), 1e-9 * exact.cwiseAbs().maxCoeff() + 1e-15);
    EXPECT_TRUE(pairs.certificate.complete);
    EXPECT_EQ(pairs.certificate.below_shift, number_below(exact, pairs.certificate.shift));
}

TEST(CertifiedEigensolver, solves_matrices_that_are_as_degenerate_as_can_be) {
    expect_diagonal_solved(Vector::Zero(1), 1);
    expect_diagonal_solved(Vector::Zero(50), 1);
    expect_diagonal_solved(Vector::Zero(50), 50);
    expect_diagonal_solved(Vector::Constant(60, 3.0), 7);
    expect_diagonal_solved(Vector::Constant(60, -3.0), 7);
    Vector halves = Vector::Constant(100, 2.0);
    halves.head(50).setConstant(1.0);
    expect_diagonal_solved(halves, 20);
    expect_diagonal_solved(halves, 70);
    expect_diagonal_solved(Vector::LinSpaced(90, -1e6, 1e-6), 30);
}

std::vector<Mesh> meshes_with_negative_duals() {
    return {obtuse_planar(), perturbed(grid(12, 12), 0.03, 4), perturbed(icosphere(3), 0.1, 2),
            obtuse_solid()};
}

TEST(SpuriousEigenvalues, of_dual_0_forms_over_negative_duals_are_all_found) {
    for (const auto& obtuse : meshes_with_negative_duals()) {
        const auto mesh = circumcentric(obtuse);
        const int n = mesh.dimension();
        const Vector exact = dense_spectrum(mesh, n);
        const Index spurious = number_below(exact, -1e-9 * exact.cwiseAbs().maxCoeff());
        ASSERT_GT(spurious, 0);
        for (const Index count : {spurious - spurious / 2, spurious, spurious + 5, spurious + 25}) {
            SCOPED_TRACE(testing::Message() << "n = " << n << ", " << spurious << " negative, "
                                            << count << " asked for");
            const auto found = spectrum({mesh, Side::dual, 0}, {.count = count});
            for (Index i = 0; i < count; ++i)
                EXPECT_NEAR(found.eigenvalues[i], exact[i],
                            1e-8 * std::abs(exact[i]) + 1e-12 * exact.cwiseAbs().maxCoeff())
                    << i;
            EXPECT_TRUE(found.certificate.complete);
            EXPECT_EQ(found.certificate.below_shift, number_below(exact, found.certificate.shift));
        }
    }
}

using test::refusal;

std::string refusal(const std::string& golden, const SpectrumOptions& options,
                    Side side = Side::primal, int degree = 0) {
    const auto mesh = circumcentric(read_golden(golden + ".nsc"));
    return refusal([&] { spectrum({mesh, side, degree}, options); });
}

TEST(SpectrumRefuses, counts_that_cannot_be_had) {
    EXPECT_SAYS(refusal("grid4", {.count = 0}), "0 eigenvalues", "primal 0-forms", "25 0-cells",
                "1", "25");
    EXPECT_SAYS(refusal("grid4", {.count = -3}), "-3 eigenvalues", "primal 0-forms", "25 0-cells",
                "1", "25");
    EXPECT_SAYS(refusal("grid4", {.count = 26}, Side::dual, 2), "26 eigenvalues", "dual 2-forms",
                "25 0-cells", "1", "25");
}

TEST(SpectrumRefuses, degrees_that_there_are_not) {
    EXPECT_SAYS(refusal("grid4", {}, Side::primal, 3), "primal forms", "degree 3", "dimension 2",
                "0", "2");
    EXPECT_SAYS(refusal("kuhn3", {}, Side::dual, -1), "dual forms", "degree -1", "dimension 3", "0",
                "3");
}

TEST(SpectrumRefuses, masses_that_are_not_positive) {
    EXPECT_SAYS(refusal("star_negative", {.count = 2}), "mass", "primal 0-forms", "1 of 7 0-cells",
                "negative", "cells 0", "StarKind::automatic", "Delaunay::flips_and_splits");
    EXPECT_SAYS(refusal("fcc1", {.count = 2}, Side::primal, 2), "mass", "primal 2-forms",
                "24 of 56 2-cells", "zero", "cells 0, 1, 2, 5, 7", "StarKind::automatic");
}

TEST(SpectrumRefuses, inverse_stars_that_divide_by_zero) {
    const auto split = discretize(
        mesh_named("grid4"), {.criterion = MergeCriterion::none, .star = StarKind::circumcentric});
    EXPECT_REFUSED(spectrum({split, Side::dual, 0}, {.count = 2}), "inverse star", "degree 1",
                   "zero", "16 1-cells");
}

TEST(SpectrumRefuses, engines_nobody_knows) {
    EXPECT_SAYS(refusal("grid4", {.linear_solver = "abacus"}), "linear solver", "abacus");
    EXPECT_SAYS(refusal("grid4", {.eigen_solver = "abacus"}), "eigensolver", "abacus");
}

TEST(CertifiedEigensolverRefuses, sizes_and_masses_that_do_not_fit) {
    const auto solve = [](Index rows, const Vector& mass, Index count) {
        return refusal([&] {
            SparseMatrix A(rows, rows);
            A.setIdentity();
            CertifiedEigensolver(A, mass).smallest(count);
        });
    };
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_SAYS(solve(3, Vector::Ones(2), 1), "eigenproblem", "3 x 3", "2 entries");
    EXPECT_SAYS(solve(0, Vector(0), 1), "eigenproblem", "0 x 0", "0 entries");
    EXPECT_SAYS(solve(2, Vector::Unit(2, 0), 1), "eigenproblem", "entry 1", "M", "0");
    EXPECT_SAYS(solve(2, Vector::Constant(2, nan), 1), "eigenproblem", "entry 0", "M", "nan");
    EXPECT_SAYS(solve(2, Vector::Ones(2), 3), "3 eigenvalues", "1", "2");
}

} // namespace polydec::test::in_certified_eigensolver
