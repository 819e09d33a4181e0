// SPDX-License-Identifier: MIT
#include "backends/engine_module.h"
#include "backends/linear/checked_solver.h"
#include "backends/registry.h"
#include "base/checks.h"
#include "base/errors.h"
#include "base/parallel.h"
#include "python/bindings/convert.h"
#include "python/bindings/guarded.h"
#include "system/memory.h"

#include <fmt/format.h>

#include <array>

namespace polydec::python {

namespace {

const char* kind_name(EngineKind kind) {
    constexpr std::array names{"linear", "eigen", "integrator", "mesher"};
    return names[static_cast<std::size_t>(kind)];
}

py::dict engine_of(const EngineInfo& info) {
    return py::dict(py::arg("name") = info.name, py::arg("kind") = kind_name(info.kind),
                    py::arg("available") = info.available,
                    py::arg("description") = info.description,
                    py::arg("how_to_get") = info.how_to_get, py::arg("license") = info.license);
}

/// An engine written in Python: a function that takes a scipy matrix and gives one that takes
/// right-hand sides, a column each, to solutions. What it gives is checked like any engine's.
class PythonSolver final : public CheckedSolver {
public:
    PythonSolver(const std::string& name, const LinearSolverOptions& options,
                 std::shared_ptr<py::object> factorize)
        : CheckedSolver(name, {}, options), factorize_(std::move(factorize)) {}
    ~PythonSolver() override {
        locked([&] { solve_ = py::object(); });
    }

protected:
    void compute(const SparseMatrix& A, const MatrixFacts&, Pattern) override {
        locked([&] { solve_ = (*factorize_)(csr(SparseMatrix(A))); });
    }

    Solution apply_inverse(const DenseMatrix& B) override {
        return locked([&]() -> Solution {
            using Columns = py::array_t<double, py::array::f_style | py::array::forcecast>;
            const auto found = Columns::ensure(solve_(B));
            if (!found || found.size() != B.size())
                fail("the Python function did not return as many numbers as it got");
            return {Eigen::Map<const DenseMatrix>(found.data(), B.rows(), B.cols())};
        });
    }

private:
    std::shared_ptr<py::object> factorize_;
    py::object solve_;
};

void register_solver(const std::string& name, const py::function& factorize) {
    const auto kept = shared(factorize);
    register_engine(name, [name, kept](const LinearSolverOptions& options) {
        return std::make_unique<PythonSolver>(name, options, kept);
    });
}

/// An operator for Python, which may keep what `function` gives: used after the lender is gone, it
/// throws InvalidInput.
class Lent {
public:
    explicit Lent(const SymmetricOperator& A) : use_(std::make_shared<Guarded<Use>>(Use{&A})) {}
    ~Lent() {
        use_->use([](Use& use) { use.A = nullptr; });
    }
    Lent(const Lent&) = delete;
    Lent& operator=(const Lent&) = delete;

    py::cpp_function function() const {
        return [kept = use_](const Vector& x) {
            return kept->use([&](Use& use) { return applied(use, x); });
        };
    }
    Index count() const { return use_->solver.count; }

private:
    struct Use {
        const SymmetricOperator* A;
        Index count = 0;
    };

    static Vector applied(Use& use, const Vector& x) {
        if (use.A == nullptr)
            throw InvalidInput(
                "the operator of an eigensolver is applied after its call, with which "
                "it ended: expected products before the function returns");
        check_as_many("values for the operator of an eigensolver", x.size(), use.A->size);
        ++use.count;
        Vector y(use.A->size);
        use.A->apply(x, y);
        return y;
    }

    std::shared_ptr<Guarded<Use>> use_;
};

/// An eigensolver written in Python, called with what the operator does.
class PythonEigenSolver final : public EigenSolver {
public:
    PythonEigenSolver(std::string name, std::shared_ptr<py::object> largest)
        : name_(std::move(name)), largest_(std::move(largest)) {}
    std::string name() const override { return name_; }

protected:
    EigenPairs compute(const SymmetricOperator& A, Index count,
                       const EigenOptions& options) const override {
        return locked([&] { return computed(A, count, options); });
    }

private:
    EigenPairs computed(const SymmetricOperator& A, Index count,
                        const EigenOptions& options) const {
        const Lent lent(A);
        const auto [values, vectors] =
            (*largest_)(lent.function(), A.size, count, options.krylov_dimension, options.tolerance,
                        options.start)
                .cast<std::pair<Vector, DenseMatrix>>();
        if (values.size() > count || vectors.rows() != A.size || vectors.cols() != values.size())
            throw SolverFailure(fmt::format(
                "{}: the Python function returned {} values and a {} x {} array of vectors: "
                "expected at most {} values and {} numbers for each",
                name_, values.size(), vectors.rows(), vectors.cols(), count, A.size));
        return {values, vectors, static_cast<Index>(values.size()), lent.count()};
    }

    std::string name_;
    std::shared_ptr<py::object> largest_;
};

void register_eigensolver(const std::string& name, const py::function& largest) {
    register_engine(name, [name, kept = shared(largest)] {
        return std::make_unique<PythonEigenSolver>(name, kept);
    });
}

/// The module of that name, with all that its engines need.
void load_named(const std::string& name) {
    for (const EngineInfo& info : unlocked([] { return engines(); })) {
        if (info.name != name && info.name.rfind(name + ".", 0) != 0)
            continue;
        if (!info.available)
            throw BackendUnavailable(fmt::format("{}: {}", name, info.how_to_get));
        return;
    }
    make_linear_solver(name); // which lists the names that there are
}

} // namespace

void add_engines(py::module_& module) {
    module.def("engines", [] {
        py::list all;
        for (const EngineInfo& info : unlocked([] { return engines(); }))
            all.append(engine_of(info));
        return all;
    });
    module.def("load_engine", [](const std::string& path) { load_engine_module(path); });
    module.def("load_named_engine", &load_named);
    module.def("set_memory_limit", &set_memory_limit);
    module.def("use_one_thread", &use_one_thread);
    module.def("register_linear_solver", &register_solver);
    module.def("register_eigen_solver", &register_eigensolver);
    module.def("solve", [](const MatrixParts& A, const DenseMatrix& B, const std::string& engine,
                           bool symmetric, bool positive) {
        auto [X, report] = unlocked([&] {
            const auto solver = make_linear_solver(engine);
            MatrixFacts facts;
            facts.symmetry = symmetric ? Symmetry::symmetric : Symmetry::general;
            if (positive)
                facts.definiteness = Definiteness::positive;
            solver->factorize(sparse(A), facts);
            DenseMatrix found = solver->solve(B);
            return std::pair(std::move(found), solver->report());
        });
        return py::make_tuple(std::move(X), report_of(report));
    });
}

} // namespace polydec::python
