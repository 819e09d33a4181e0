// SPDX-License-Identifier: MIT
#include "tools/initial_form.h"

#include "base/errors.h"
#include "dec/fields/cell_centers.h"
#include "tools/outputs.h"

#include <fmt/format.h>

namespace polydec::tools {

void add_initial(CLI::App& command, std::string& text) {
    command
        .add_option("--initial", text,
                    "the form at time 0: of degree 0 an expression in x, y, z; or a\n"
                    "file with a value for each cell")
        ->required();
}

InitialForm::InitialForm(const std::string& text) : values_("--initial", text) {}

Cochain InitialForm::on(const Discretization& mesh, Side side, int degree) const {
    const int n = mesh.dimension();
    if (degree < 0 || degree > n)
        throw InvalidInput(
            fmt::format("forms of degree {} are asked for: expected 0 to {}", degree, n));
    if (degree > 0 && !values_.file())
        throw InvalidInput(fmt::format("--initial is an expression, which gives values of "
                                       "0-forms: expected a file with one number for each cell "
                                       "for forms of degree {}",
                                       degree));
    if (degree > 0)
        return {
            side, degree,
            values_.at(Points(mesh.complex().size(cell_degree(mesh.complex(), side, degree)), 0))};
    const Points sites = side == Side::primal ? cell_centers(mesh, 0) : dual_sites(mesh);
    return {side, degree, values_.at(mesh.unit() * sites)};
}

Paths InitialForm::inputs(const std::filesystem::path& mesh,
                          const std::vector<std::optional<std::filesystem::path>>& others) const {
    Paths files = mesh_files(mesh);
    if (values_.file())
        files.push_back(*values_.file());
    for (const auto& other : others)
        if (other)
            files.push_back(*other);
    return files;
}

} // namespace polydec::tools
