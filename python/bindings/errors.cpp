// SPDX-License-Identifier: MIT
#include "base/errors.h"

#include "python/bindings/convert.h"

namespace polydec::python {

namespace {

/// Raises the class of that name of polydec/_errors.py, with the places that the error names.
void raise(const char* name, const Error& error, const py::object& report = py::none()) {
    const py::object type = py::module_::import("polydec._errors").attr(name);
    const Error::Place& place = error.place();
    const auto some = [](bool is_known, const py::object& value) {
        return is_known ? value : py::object(py::none());
    };
    const py::object raised = type(
        error.what(), py::arg("degree") = some(place.degree >= 0, py::int_(place.degree)),
        py::arg("cells") = py::cast(place.cells), py::arg("vertices") = py::cast(place.vertices),
        py::arg("path") = some(!place.path.empty(), py::str(place.path.string())),
        py::arg("line") = some(place.line > 0, py::int_(place.line)), py::arg("report") = report);
    PyErr_SetObject(type.ptr(), raised.ptr());
}

void translate(std::exception_ptr thrown) {
    try {
        if (thrown)
            std::rethrow_exception(thrown);
    } catch (const SolverFailure& error) {
        raise("SolverFailure", error, in_words(error.report()));
    } catch (const BackendUnavailable& error) {
        raise("BackendUnavailable", error);
    } catch (const IoError& error) {
        raise("IoError", error);
    } catch (const InvalidInput& error) {
        raise("InvalidInput", error);
    } catch (const Error& error) {
        raise("Error", error);
    }
}

} // namespace

void add_errors(py::module_&) {
    py::register_exception_translator(&translate);
}

} // namespace polydec::python
