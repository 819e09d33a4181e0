// SPDX-License-Identifier: MIT
#include "backends/spectra/certified_eigensolver.h"
#include "python/bindings/convert.h"
#include "solvers/spectra/spectrum.h"

#include <variant>

namespace polydec::python {

namespace {

py::dict certificate_of(const Certificate& certificate) {
    return py::dict(py::arg("shift") = certificate.shift,
                    py::arg("below_shift") = certificate.below_shift,
                    py::arg("returned_below_shift") = certificate.returned_below_shift,
                    py::arg("complete") = certificate.complete);
}

/// Of a Spectrum or of CertifiedEigenpairs, whose columns go by other names.
template <class Pairs>
py::dict pairs_of(Pairs& pairs, Vector values, DenseMatrix columns) {
    warn_of_missed_engines();
    return py::dict(
        py::arg("eigenvalues") = std::move(values), py::arg("modes") = std::move(columns),
        py::arg("radii") = std::move(pairs.radii),
        py::arg("residuals") = std::move(pairs.residuals),
        py::arg("certificate") = certificate_of(pairs.certificate),
        py::arg("linear_solver") = pairs.linear_solver,
        py::arg("eigen_solver") = pairs.eigen_solver, py::arg("rough") = std::move(pairs.rough));
}

Certification certification_of(bool certified) {
    return certified ? Certification::required : Certification::waived;
}

/// Modes have values on all cells, 0 where the conditions of the space fix them.
py::dict spectrum_of(const FormSpace& space, Index count, bool coexact, bool certified,
                     const std::string& linear_solver, const std::string& eigen_solver,
                     const py::object& progress) {
    const SpectrumOptions options{count, linear_solver, eigen_solver, certification_of(certified),
                                  listener(progress)};
    Spectrum found = unlocked(
        [&] { return coexact ? coexact_spectrum(space, options) : spectrum(space, options); });
    warn(found.warnings);
    py::dict parts = pairs_of(found, std::move(found.eigenvalues), std::move(found.modes));
    parts["coarseness"] = found.coarseness;
    return parts;
}

py::dict smallest_eigenpairs(const MatrixParts& A, const std::variant<Vector, MatrixParts>& M,
                             Index count, bool certified, const std::string& linear_solver,
                             const std::string& eigen_solver, const py::object& progress) {
    const EigensolverOptions options{.linear_solver = linear_solver,
                                     .eigen_solver = eigen_solver,
                                     .certification = certification_of(certified),
                                     .progress = listener(progress)};
    Pencil pencil;
    pencil.C = sparse(A);
    if (const auto* masses = std::get_if<Vector>(&M))
        pencil.M = *masses;
    else
        pencil.M = sparse(std::get<MatrixParts>(M));
    CertifiedEigenpairs found =
        unlocked([&] { return CertifiedEigensolver(pencil, options).smallest(count); });
    return pairs_of(found, std::move(found.values), std::move(found.vectors));
}

} // namespace

void add_spectra(py::module_& module) {
    module.def("spectrum", &spectrum_of);
    module.def("smallest_eigenpairs", &smallest_eigenpairs);
}

} // namespace polydec::python
