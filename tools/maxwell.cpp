// SPDX-License-Identifier: MIT
#include "base/errors.h"
#include "dec/discretization/material_stars.h"
#include "tools/commands.h"
#include "tools/common.h"
#include "tools/conditions.h"
#include "tools/expression.h"
#include "tools/form_values.h"
#include "tools/picture.h"
#include "tools/wave_answer.h"

#include <fmt/format.h>

#include <optional>

namespace polydec::tools {

namespace {

struct MaxwellArguments {
    MeshArguments mesh;
    TimeArguments time;
    ConditionArguments conditions;
    Side side = Side::primal;
    int degree = 1;
    std::string initial, current, pulse = "1";
    std::string permittivity, permeability, conductivity;
    double layer_width = 0;
    LayerKind layer = LayerKind::automatic;
};

/// What is given of a material, as expressions or files.
struct Material {
    std::optional<SiteValues> permittivity, permeability, conductivity;

    explicit Material(const MaxwellArguments& arguments)
        : permittivity(if_given<SiteValues>("--permittivity", arguments.permittivity, "group")),
          permeability(if_given<SiteValues>("--permeability", arguments.permeability, "group")),
          conductivity(if_given<SiteValues>("--conductivity", arguments.conductivity, "group")) {}
};

/// What materials make of a field of one side and degree: energies are of permittivity |E|^2 and
/// |B|^2 / permeability, and dual forms are stars of primal ones by what is between them, 1 over
/// it.
class Filling {
public:
    Filling(const Discretization& empty, const MaxwellArguments& arguments,
            const Material& material)
        : empty_(empty),
          side_(arguments.side),
          degree_(arguments.degree),
          k_(cell_degree(empty.complex(), arguments.side, arguments.degree)) {
        const auto at = [&](const char* name, const std::optional<SiteValues>& values,
                            Range range) {
            return values ? cell_values(empty, *values).on(empty, name, range) : Vector();
        };
        permittivity_ = at("permittivity", material.permittivity, Range::positive);
        permeability_ = at("permeability", material.permeability, Range::positive);
        conductivity_ = at("conductivity", material.conductivity, Range::not_negative);
    }

    Discretization filled() const {
        return with_electric_material(empty_, side_, degree_, CellData::on_cells(permittivity_),
                                      CellData::on_cells(permeability_));
    }

    /// Conductivity over permittivity; none where nothing conducts.
    Vector loss() const {
        return conductivity_.isZero(0) ? Vector() : over_permittivity(conductivity_);
    }

    /// What a current adds to the rate of the field.
    Vector source(const Vector& current) const {
        if (permittivity_.size() == 0)
            return -current;
        return -current.cwiseProduct(over_permittivity(Vector::Ones(permittivity_.size())));
    }

private:
    /// Means around cells: of primal fields, which neighbors share, of each; of dual ones, of which
    /// neighbors share the flux, of the quotient.
    Vector over_permittivity(const Vector& values) const {
        const auto means = [&](const Vector& of_cells) {
            return cell_means(empty_, k_, CellData::on_cells(of_cells));
        };
        if (permittivity_.size() == 0)
            return means(values);
        if (side_ == Side::dual)
            return means(values.cwiseQuotient(permittivity_));
        return means(values).cwiseQuotient(means(permittivity_));
    }

    const Discretization& empty_;
    Side side_;
    int degree_, k_;
    Vector permittivity_, permeability_, conductivity_; // empty: not given
};

WaveWords words_of(const MaxwellArguments& arguments) {
    std::string equation = "dB/dt = -d E, dE/dt = (delta B - conductivity E - J) / permittivity";
    if (!arguments.initial.empty())
        equation += fmt::format(", E = {} at the time 0", arguments.initial);
    if (!arguments.current.empty())
        equation += fmt::format(", J = ({}) times {}", arguments.current, arguments.pulse);
    return {"maxwell",
            "Maxwell's equations",
            equation,
            "E",
            "the electric field",
            "B",
            "the magnetic field, half a step earlier",
            true};
}

void run_maxwell(const MaxwellArguments& arguments) {
    Log log;
    const auto initial = if_given<FormValues>("--initial", arguments.initial);
    const auto current = if_given<FormValues>("--current", arguments.current);
    if (!initial && !current)
        throw CLI::ValidationError("maxwell needs --initial FORM or --current FORM, or both");
    const Expression pulse("--pulse", arguments.pulse, "t");
    const Material material(arguments);
    const ConditionValues asked(arguments.conditions);
    const FormValues& first = initial ? *initial : *current;
    check_time(arguments.time);

    const Discretization empty = load(arguments.mesh, log, arguments.time.out);
    const Filling filling(empty, arguments, material);
    const auto on_cells = [&](const FormValues& values) {
        return values.on(empty, arguments.side, arguments.degree);
    };
    WaveOptions options{.loss = filling.loss()};
    if (arguments.layer_width > 0)
        options.layer = {filling.filled(), arguments.layer_width, arguments.layer};
    const auto space = computed_on(log.mesh, [&] {
        return FormSpace(filling.filled(), arguments.side, arguments.degree,
                         asked.on(empty).value_or(BoundaryConditions{}));
    });
    Vector start = on_cells(first);
    if (!initial)
        start.setZero();
    if (current) {
        pulse.of_label(0); // which there must be
        const Vector source = filling.source(on_cells(*current));
        options.source = [=, &pulse](double t) { return Vector(pulse.of_label(t) * source); };
        options.label =
            fmt::format("{} of {:x}", arguments.pulse, polydec::Fingerprint().add(source).value());
    }
    answer_waves(words_of(arguments), filling.filled(), space, start, options, arguments.mesh.tell,
                 arguments.time, log);
}

void add_materials(CLI::App& command, MaxwellArguments& arguments) {
    const auto add = [&](const char* option, std::string& text, const char* preset) {
        command.add_option(option, text, fmt::format("EXPR\tper cell (default: {})", preset));
    };
    add("--permittivity", arguments.permittivity, "1");
    add("--permeability", arguments.permeability, "1");
    add("--conductivity", arguments.conductivity, "0");
}

} // namespace

void add_maxwell(CLI::App& app) {
    const auto [command, arguments] = add_command<MaxwellArguments>(
        app, "maxwell", "solves Maxwell's equations with currents, materials and open boundaries",
        run_maxwell);
    add_form(*command, "--initial", arguments->initial, "the electric field at time 0");
    add_form(*command, "--current", arguments->current, "current density");
    command
        ->add_option("--pulse", arguments->pulse,
                     "PULSE\tfactor of the current over time, an expression in t")
        ->needs("--current");
    add_materials(*command, *arguments);
    add_side(*command, arguments->side);
    command
        ->add_option("--degree", arguments->degree,
                     "K\tdegree of the electric field: 1, along primal or dual edges; in the plane "
                     "0, perpendicular to it")
        ->check(CLI::Range(0, 1));
    add_mesh_arguments(*command, arguments->mesh, StarKind::automatic);
    add_conditions(*command, arguments->conditions,
                   "magnetic walls, planes of symmetry: tangential magnetic field 0",
                   "perfect conductors at boundary facets where this is not 0, magnetic walls "
                   "elsewhere (default: 1)");
    command
        ->add_option("--absorb", arguments->layer_width,
                     "WIDTH\tabsorb waves in a layer of this width along the sides of the bounding "
                     "box; ten cells reflect less than 1e-4")
        ->check(check_positive);
    command
        ->add_option("--layer", arguments->layer,
                     "NAME\tabsorb by stretched coordinates (cells parallel to the axes), "
                     "conducting (any cells, waves at normal incidence), or automatic")
        ->transform(enumerator({"stretched", "conducting", "automatic"}))
        ->default_str("automatic")
        ->needs("--absorb");
    add_time(*command, arguments->time, "0.9 of the largest stable step");
    command->footer(
        "Expressions per cell may use `group`, the cell's physical group; files list the cells in "
        "the order of the mesh file. Light has the speed 1 where permittivity and permeability are "
        "1. On merged cubes this is Yee's scheme.\n\nExamples:\n"
        "  polydec maxwell box.off --initial '0; 0; exp(-99*((x-.5)^2+(y-.5)^2+(z-.5)^2))' \\\n"
        "      --until .4 -o pulse.html\n"
        "  polydec maxwell plane.msh --degree 0 --current 'exp(-400*(x^2+y^2))' \\\n"
        "      --pulse 'sin(40*t)' --permittivity 'group==2 ? 4 : 1' --keep-groups --absorb .2 \\\n"
        "      --until 3 -o lens.pvd --checkpoint lens.checkpoint --resume");
}

} // namespace polydec::tools
