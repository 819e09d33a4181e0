// SPDX-License-Identifier: MIT
#include "base/errors.h"
#include "python/bindings/convert.h"

namespace polydec::python {

namespace {

/// Raises the class of that name of polydec/_errors.py, with the places that the error names.
void raise(const char* name, const Error& error, py::dict known = {}) {
    const Error::Place& place = error.place();
    if (place.degree >= 0)
        known["degree"] = place.degree;
    known["cells"] = place.cells;
    known["vertices"] = place.vertices;
    if (!place.path.empty())
        known["path"] = place.path.string();
    if (place.line > 0)
        known["line"] = place.line;
    const auto errors = py::module_::import("polydec._errors");
    const py::object type = errors.attr(name);
    PyErr_SetObject(type.ptr(), type(errors.attr("told")(error.what()), **known).ptr());
}

void translate(std::exception_ptr thrown) {
    try {
        if (thrown)
            std::rethrow_exception(thrown);
    } catch (const SolverFailure& error) {
        raise("SolverFailure", error, py::dict(py::arg("report") = report_of(error.report())));
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
