// SPDX-License-Identifier: MIT
#include "base/errors.h"
#include "meshes/generate.h"
#include "tools/generate.h"

#include <fmt/format.h>

#include <memory>
#include <optional>
#include <vector>

namespace polydec::tools {

namespace {

/// A grid of boxes: one count for all axes, or one for each.
struct BoxArguments {
    std::optional<int> dimension;
    std::vector<int> cells{4};
    std::vector<double> lengths;
    std::uint64_t seed = 1;

    std::vector<int> counts() const {
        const auto axes = static_cast<int>(cells.size());
        const int n = dimension.value_or(axes > 1 ? axes : 3);
        if (axes > 1 && axes != n)
            throw InvalidInput(
                fmt::format("--cells has {} counts, but --dimension is {}; give one count for all "
                            "axes, or one for each",
                            axes, n));
        if (n < 1 || n > 12)
            throw InvalidInput(fmt::format("--dimension {} is outside 1 .. 12", n));
        return axes > 1 ? cells : std::vector<int>(static_cast<std::size_t>(n), cells.front());
    }
};

/// Lattices of cubes: one count for the unit cube, or one for each axis.
struct LatticeArguments {
    std::vector<int> cells{4};
    std::optional<double> edge;

    Mesh make(std::size_t n, Mesh (*box)(const std::vector<int>&, double)) const {
        if (cells.size() != 1 && cells.size() != n)
            throw InvalidInput(fmt::format("--cells has {} counts; give one for all {} axes, or "
                                           "one for each",
                                           cells.size(), n));
        const bool is_cube = cells.size() == 1;
        return box(is_cube ? std::vector<int>(n, cells[0]) : cells,
                   edge.value_or(is_cube ? 1.0 / cells[0] : 1.0));
    }
};

CLI::App* add_boxes(CLI::App& generate, const char* name, const char* help,
                    const std::shared_ptr<BoxArguments>& arguments,
                    Mesh (*make)(const BoxArguments&)) {
    auto* command =
        add_generator(generate, name, help, [arguments, make] { return make(*arguments); });
    command->add_option("--dimension", arguments->dimension,
                        "N\tdimension (default: the number of --cells if several, otherwise 3)");
    command->add_option("--cells", arguments->cells, "N ..\tboxes along all axes, or along each")
        ->expected(1, 12);
    command
        ->add_option("--lengths", arguments->lengths,
                     "L ..\tlength along each axis (default: the unit cube)")
        ->expected(1, 12);
    return command;
}

void add_lattice(CLI::App& generate, const char* name, const char* help, std::size_t n,
                 Mesh (*make)(const std::vector<int>&, double)) {
    const auto arguments = std::make_shared<LatticeArguments>();
    auto* command = add_generator(generate, name, help, [=] { return arguments->make(n, make); });
    command->add_option("--cells", arguments->cells, "N ..\tcubes along all axes, or along each")
        ->expected(1, static_cast<int>(n));
    command->add_option(
        "--edge", arguments->edge,
        "L\tedge length of a cube (default: that of a unit cube as a whole, 1 if several --cells)");
}

void add_clusters(CLI::App& generate) {
    const auto options = std::make_shared<ClusterOptions>();
    auto* command =
        add_generator(generate, "clusters", "random points, and spheres with cospherical points",
                      [options] { return sphere_clusters(*options); });
    const auto add = [command](const char* name, auto& value, const char* help) {
        command->add_option(name, value, help);
    };
    add("--dimension", options->dimension, "N\tdimension");
    add("--cells", options->cells_per_side,
        "N\tboxes along each axis, with a random point in each");
    add("--spheres", options->spheres, "N\tspheres without points inside");
    add("--points", options->points_on_sphere, "N\tpoints on each sphere");
    add("--radius", options->radius, "R\tradius of the spheres");
    add("--seed", options->seed, "N\tseed of the random numbers");
}

} // namespace

void add_lattices(CLI::App& generate) {
    add_boxes(generate, "kuhn", "grid of boxes of n! simplices each, any dimension",
              std::make_shared<BoxArguments>(),
              [](const BoxArguments& a) { return kuhn(a.counts(), a.lengths); });
    const auto split = std::make_shared<BoxArguments>();
    add_boxes(generate, "split-boxes", "the same, each box split at random", split,
              [](const BoxArguments& a) { return split_boxes(a.counts(), a.lengths, a.seed); })
        ->add_option("--seed", split->seed, "N\tseed of the random numbers");
    add_lattice(generate, "bcc", "body-centered lattice, tetrahedra", 3, bcc);
    add_lattice(generate, "fcc", "face-centered lattice, tetrahedra and split octahedra", 3, fcc);
    add_lattice(generate, "d4", "lattice D4, split 16-cells in four dimensions", 4, d4);
    add_clusters(generate);
}

} // namespace polydec::tools
