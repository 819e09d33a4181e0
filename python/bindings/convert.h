// SPDX-License-Identifier: MIT
#pragma once

#include "base/progress.h"
#include "base/solve_report.h"
#include "base/types.h"
#include "dec/forms/cochain.h"
#include "solvers/sources/boundary_forms.h"

#include <cxxabi.h>
#include <memory>
#include <optional>
#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <string>
#include <string_view>
#include <tuple>
#include <unistd.h>
#include <utility>
#include <vector>

namespace polydec {
enum class Sampling;
}

/// Between numpy's arrays, scipy's matrices and polydec's. What is handed out shares memory and
/// keeps alive what it belongs to; it is read-only, unless it was made to be handed out. What comes
/// in has been made contiguous and of the right type and shape in Python, where it has a name, and
/// is copied. Arguments and results that are vectors, lists of whole numbers, tables, sides, forms
/// and data on the boundary, and results that are sparse matrices, are converted as the end of this
/// file says.
namespace polydec::python {

namespace py = pybind11;

using Numbers = py::array_t<double, py::array::c_style>;
using Integers = py::array_t<Index, py::array::c_style>;

/// Of a matrix of scipy: data, columns, begins of rows, and the number of columns.
using MatrixParts = std::tuple<Numbers, Integers, Integers, Index>;

/// An array of these numbers, which belong to the owner. Strides are those of C, or of Fortran.
template <class Scalar>
py::array view(const Scalar* numbers, std::vector<py::ssize_t> shape, py::handle owner,
               bool by_columns = false) {
    std::vector<py::ssize_t> strides(shape.size());
    py::ssize_t stride = sizeof(Scalar);
    for (std::size_t i = 0; i < shape.size(); ++i) {
        const std::size_t axis = by_columns ? i : shape.size() - 1 - i;
        strides[axis] = stride;
        stride *= shape[axis];
    }
    py::array result(py::dtype::of<Scalar>(), shape, strides, numbers, owner);
    py::detail::array_proxy(result.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
    return result;
}

/// The same for a list or a table.
template <class Values>
py::array shown(const Values& numbers, py::handle owner) {
    std::vector<py::ssize_t> shape{std::ssize(numbers)};
    bool by_columns = false;
    if constexpr (requires { numbers.cols(); })
        if (Values::ColsAtCompileTime != 1) {
            shape = {numbers.rows(), numbers.cols()};
            by_columns = !Values::IsRowMajor;
        }
    return view(numbers.data(), std::move(shape), owner, by_columns);
}

/// Lets Python change an array that belongs to nobody else.
inline py::array writable(py::array numbers) {
    py::detail::array_proxy(numbers.ptr())->flags |= py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
    return numbers;
}

/// Something that lives as long as arrays of its numbers do.
template <class Value>
py::capsule owner_of(std::unique_ptr<Value> value) {
    return py::capsule(value.release(), [](void* kept) { delete static_cast<Value*>(kept); });
}

/// An array that owns what it shows.
template <class Values>
py::array array(Values values) {
    auto kept = std::make_unique<Values>(std::move(values));
    const Values& numbers = *kept;
    return writable(shown(numbers, owner_of(std::move(kept))));
}

/// Warns of each as Python does; throws what that raises where warnings are errors.
void warn(const std::vector<std::string>& warnings);

/// Warns, once, of engines that `auto` missed; called where a report is returned.
void warn_of_missed_engines();

/// scipy.sparse.csr_matrix, of this matrix, which is emptied, or of one that belongs to the owner.
/// Throws InvalidInput for one that is not compressed.
py::object csr(SparseMatrix&& matrix);
py::object csr(const IncidenceMatrix& matrix, py::handle owner);

/// What comes in.
Vector vector(const Numbers& numbers);
std::vector<Index> indices(const Integers& numbers);
SparseMatrix sparse(const MatrixParts& matrix);
template <class Table, class Scalar>
Table table(const py::array_t<Scalar, py::array::c_style>& numbers) {
    using Rows = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    return Eigen::Map<const Rows>(numbers.data(), numbers.shape(0), numbers.shape(1));
}

/// The value of an option's name. Throws InvalidInput, listing those there are.
template <class Value>
Value chosen(std::string_view option, const std::string& name,
             const std::vector<std::pair<std::string_view, Value>>& values);
[[noreturn]] void refuse_choice(std::string_view option, const std::string& name,
                                const std::vector<std::string_view>& names);
template <class Value>
Value chosen(std::string_view option, const std::string& name,
             const std::vector<std::pair<std::string_view, Value>>& values) {
    std::vector<std::string_view> names;
    for (const auto& [own, value] : values) {
        if (own == name)
            return value;
        names.push_back(own);
    }
    refuse_choice(option, name, names);
}
Side side_of(const std::string& name);
Sampling sampling_of(const std::string& name);

/// A form, by its side, degree and values.
using GivenForm = std::tuple<std::string, int, Numbers>;
Cochain form(const GivenForm& given);

/// Data on the boundary as Python names them: values, codifferential, flow, derivative_flow.
using GivenBoundary = std::tuple<Numbers, Numbers, Numbers, Numbers>;
BoundaryForms boundary_forms(const GivenBoundary& given);

py::dict report_of(const SolveReport& report);

/// A function of Python's that may be copied and destroyed without the interpreter's lock, with
/// which alone references to it are counted.
std::shared_ptr<py::object> shared(const py::object& function);

/// Tells a function of Python's what is being done, if there is one, and lets Ctrl-C end it. May
/// be called, copied and destroyed without the interpreter's lock.
Progress listener(const py::object& function);

/// Lets Ctrl-C end what is being done. To be called with or without the interpreter's lock.
void check_signals();

/// While the interpreter ends, it unwinds every other thread that asks for its lock or runs Python.
/// Destructors and functions of C++ must not be unwound, which would end the program by
/// std::terminate: such a thread waits here for the end of the process instead.
template <class Work>
auto until_the_end(Work work) {
#ifdef __GLIBCXX__
    try {
        return work();
    } catch (const abi::__forced_unwind&) {
        for (;;)
            ::pause();
    }
#else
    return work(); // nothing is unwound
#endif
}

/// Lets go of the interpreter's lock.
class Unlocked {
public:
    Unlocked() : state_(PyEval_SaveThread()) {}
    ~Unlocked() {
        until_the_end([&] { PyEval_RestoreThread(state_); });
    }
    Unlocked(const Unlocked&) = delete;
    Unlocked& operator=(const Unlocked&) = delete;

private:
    PyThreadState* state_;
};

/// What is done without the interpreter's lock.
template <class Work>
auto unlocked(Work work) {
    const Unlocked release;
    return work();
}

/// Of a function that is called without it, but for its arguments and result.
using Unlocking = py::call_guard<Unlocked>;

/// What is done with the interpreter's lock, by C++ that runs without it.
template <class Work>
auto locked(Work work) {
    std::optional<py::gil_scoped_acquire> lock;
    return until_the_end([&] {
        lock.emplace();
        return work();
    });
}

void add_errors(py::module_& module);
void add_meshes(py::module_& module);
void add_calculus(py::module_& module);
void add_discretization(py::module_& module);
void add_fields(py::module_& module);
void add_pages(py::module_& module);
void add_solvers(py::module_& module);
void add_in_time(py::module_& module);
void add_flows(py::module_& module);
void add_shape(py::module_& module);
void add_spectra(py::module_& module);
void add_engines(py::module_& module);

} // namespace polydec::python

namespace pybind11::detail {

/// An argument that is made from what Python gives.
template <class Value, class Given, Value (*from)(const Given&)>
struct made_from {
    PYBIND11_TYPE_CASTER(Value, make_caster<Given>::name);

    bool load(handle source, bool convert) {
        make_caster<Given> given;
        if (!given.load(source, convert))
            return false;
        value = from(cast_op<const Given&>(given));
        return true;
    }
};

template <>
struct type_caster<polydec::Side>
    : made_from<polydec::Side, std::string, polydec::python::side_of> {};

/// The same for results too, which become arrays.
template <class Value, class Given, Value (*from)(const Given&)>
struct as_array : made_from<Value, Given, from> {
    static handle cast(Value value, return_value_policy, handle) {
        return polydec::python::array(std::move(value)).release();
    }
};

template <>
struct type_caster<polydec::Sampling>
    : made_from<polydec::Sampling, std::string, polydec::python::sampling_of> {};

template <>
struct type_caster<polydec::Vector>
    : as_array<polydec::Vector, polydec::python::Numbers, polydec::python::vector> {};

template <>
struct type_caster<std::vector<polydec::Index>>
    : as_array<std::vector<polydec::Index>, polydec::python::Integers, polydec::python::indices> {};

template <>
struct type_caster<polydec::Simplices>
    : as_array<polydec::Simplices, polydec::python::Integers, polydec::python::table> {};

template <>
struct type_caster<polydec::Points>
    : as_array<polydec::Points, polydec::python::Numbers, polydec::python::table> {};

template <>
struct type_caster<polydec::DenseMatrix>
    : as_array<polydec::DenseMatrix, polydec::python::Numbers, polydec::python::table> {};

template <>
struct type_caster<polydec::SparseMatrix> {
    static constexpr auto name = const_name("scipy.sparse.csr_matrix");
    static handle cast(polydec::SparseMatrix&& matrix, return_value_policy, handle) {
        return polydec::python::csr(std::move(matrix)).release();
    }
};

template <>
struct type_caster<polydec::Cochain>
    : made_from<polydec::Cochain, polydec::python::GivenForm, polydec::python::form> {
    static handle cast(polydec::Cochain form, return_value_policy, handle) {
        return make_tuple(polydec::name(form.side), form.degree, std::move(form.values)).release();
    }
};

template <>
struct type_caster<polydec::BoundaryForms>
    : made_from<polydec::BoundaryForms, polydec::python::GivenBoundary,
                polydec::python::boundary_forms> {};

} // namespace pybind11::detail
