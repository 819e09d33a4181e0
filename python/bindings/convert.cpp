// SPDX-License-Identifier: MIT
#include "python/bindings/convert.h"

#include "backends/linear/auto_solver.h"
#include "base/errors.h"
#include "dec/fields/lie_derivative.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace polydec::python {

namespace {

template <class Scalar>
py::object csr_of(const Eigen::SparseMatrix<Scalar, Eigen::RowMajor, Index>& matrix,
                  py::handle owner) {
    if (!matrix.isCompressed())
        throw InvalidInput("a sparse matrix with gaps cannot be shared with Python: compress it");
    const py::tuple parts =
        py::make_tuple(view(matrix.valuePtr(), {matrix.nonZeros()}, owner),
                       view(matrix.innerIndexPtr(), {matrix.nonZeros()}, owner),
                       view(matrix.outerIndexPtr(), {matrix.rows() + 1}, owner));
    py::object result =
        py::module_::import("scipy.sparse")
            .attr("csr_matrix")(parts, py::make_tuple(matrix.rows(), matrix.cols()));
    // scipy would look at all columns to find out
    result.attr("has_sorted_indices") = true;
    result.attr("has_canonical_format") = true;
    return result;
}

} // namespace

py::object csr(SparseMatrix&& matrix) {
    auto kept = std::make_unique<SparseMatrix>();
    kept->swap(matrix); // Eigen would copy it where one moves it
    kept->makeCompressed();
    const SparseMatrix& shown = *kept;
    py::object result = csr_of(shown, owner_of(std::move(kept)));
    for (const char* part : {"data", "indices", "indptr"})
        writable(result.attr(part));
    return result;
}

py::object csr(const IncidenceMatrix& matrix, py::handle owner) {
    return csr_of(matrix, owner);
}

Vector vector(const Numbers& numbers) {
    if (numbers.ndim() > 1)
        throw InvalidInput(fmt::format("an array of {} axes is given: expected a list of numbers",
                                       numbers.ndim()));
    return Eigen::Map<const Eigen::VectorXd>(numbers.data(), numbers.size());
}

std::vector<Index> indices(const Integers& numbers) {
    return {numbers.data(), numbers.data() + numbers.size()};
}

SparseMatrix sparse(const MatrixParts& matrix) {
    const auto& [data, columns, begins, width] = matrix;
    return Eigen::Map<const SparseMatrix>(begins.size() - 1, width, data.size(), begins.data(),
                                          columns.data(), data.data());
}

void refuse_choice(std::string_view option, const std::string& name,
                   const std::vector<std::string_view>& names) {
    throw InvalidInput(fmt::format("{} is \"{}\": expected one of \"{}\"", option, name,
                                   fmt::join(names, "\", \"")));
}

Side side_of(const std::string& name) {
    return chosen<Side>("side", name, {{"primal", Side::primal}, {"dual", Side::dual}});
}

Sampling sampling_of(const std::string& name) {
    return chosen<Sampling>("sampling", name,
                            {{"centered", Sampling::centered}, {"upwind", Sampling::upwind}});
}

Cochain form(const GivenForm& given) {
    const auto& [side, degree, values] = given;
    return {side_of(side), degree, vector(values)};
}

BoundaryForms boundary_forms(const GivenBoundary& given) {
    const auto& [values, codifferential, flow, derivative_flow] = given;
    return {vector(values), vector(codifferential), vector(flow), vector(derivative_flow)};
}

py::dict report_of(const SolveReport& report) {
    warn_of_missed_engines();
    return py::dict(py::arg("engine") = report.engine, py::arg("iterations") = report.iterations,
                    py::arg("residual") = report.residual,
                    py::arg("backward_error") = report.backward_error,
                    py::arg("tried") = report.tried);
}

void check_signals() {
    locked([] {
        if (PyErr_CheckSignals() != 0)
            throw py::error_already_set();
    });
}

std::shared_ptr<py::object> shared(const py::object& function) {
    return {new py::object(function), [](py::object* object) {
                if (!Py_IsInitialized()) // an engine's, which stays until the program ends
                    return;
                locked([&] { delete object; });
            }};
}

Progress listener(const py::object& function) {
    return [kept = shared(function)](std::string_view what) {
        locked([&] {
            check_signals();
            if (!kept->is_none())
                (*kept)(std::string(what));
        });
    };
}

void warn_of_missed_engines() {
    if (const auto missed = take_missed_engines(); !missed.empty())
        warn({missed});
}

void warn(const std::vector<std::string>& warnings) {
    if (!warnings.empty())
        py::module_::import("polydec._errors").attr("warn")(warnings);
}

} // namespace polydec::python
