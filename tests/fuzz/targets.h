// SPDX-License-Identifier: MIT
#pragma once

#include "tests/fuzz/target.h"

#include <array>

namespace polydec::fuzz {

/// The bytes as a file of a mesh of this name.
void read_file(const char* name, std::string_view bytes);

void tetgen(std::string_view bytes);
void nsl(std::string_view bytes);
void matrix_market(std::string_view bytes);
void xml(std::string_view bytes);
void inflate(std::string_view bytes);
void base64(std::string_view bytes);
void mesher_files(std::string_view bytes);
void complex(std::string_view bytes);
void mesh(std::string_view bytes);
void lengths(std::string_view bytes);
void options(std::string_view bytes);
void expression(std::string_view bytes);

inline constexpr std::array targets{
    Target{"off", [](std::string_view bytes) { read_file("a.off", bytes); }},
    Target{"obj", [](std::string_view bytes) { read_file("a.obj", bytes); }},
    Target{"ply", [](std::string_view bytes) { read_file("a.ply", bytes); }},
    Target{"stl", [](std::string_view bytes) { read_file("a.stl", bytes); }},
    Target{"medit", [](std::string_view bytes) { read_file("a.mesh", bytes); }},
    Target{"gmsh", [](std::string_view bytes) { read_file("a.msh", bytes); }},
    Target{"tetgen", tetgen},
    Target{"vtk", [](std::string_view bytes) { read_file("a.vtk", bytes); }},
    Target{"vtu", [](std::string_view bytes) { read_file("a.vtu", bytes); }},
    Target{"nsc", [](std::string_view bytes) { read_file("a.nsc", bytes); }},
    Target{"nsl", nsl},
    Target{"matrix_market", matrix_market},
    Target{"xml", xml},
    Target{"inflate", inflate},
    Target{"base64", base64},
    Target{"mesher_files", mesher_files},
    Target{"complex", complex},
    Target{"mesh", mesh},
    Target{"lengths", lengths},
    Target{"options", options},
    Target{"expression", expression},
};

} // namespace polydec::fuzz
