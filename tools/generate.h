// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/mesh.h"
#include "tools/answer.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <functional>

/// The parts of `polydec generate`.
namespace polydec::tools {

/// A subcommand with --out and --json that writes the mesh from `make`.
CLI::App* add_generator(CLI::App& generate, const char* name, const char* help,
                        std::function<Mesh()> make);

/// Writes the mesh and reports its size.
void write_generated(const std::filesystem::path& out, const Mesh& mesh, Log& log,
                     const TellOptions& options);

/// Boxes and lattices in any dimension, and clusters of cospherical points.
void add_lattices(CLI::App& generate);

/// The command without a mesh name, which fills a surface with tetrahedra.
void add_fill(CLI::App& generate);

} // namespace polydec::tools
