// SPDX-License-Identifier: MIT
#pragma once

#include "tests/fuzz/target.h"

#include <array>

namespace polydec::fuzz {

/// The bytes as a file of a mesh of this name.
void read_file(const char* name, std::string_view bytes);

inline constexpr auto off = [](std::string_view bytes) { read_file("a.off", bytes); };
inline constexpr auto obj = [](std::string_view bytes) { read_file("a.obj", bytes); };
inline constexpr auto ply = [](std::string_view bytes) { read_file("a.ply", bytes); };
inline constexpr auto stl = [](std::string_view bytes) { read_file("a.stl", bytes); };
inline constexpr auto medit = [](std::string_view bytes) { read_file("a.mesh", bytes); };
inline constexpr auto gmsh = [](std::string_view bytes) { read_file("a.msh", bytes); };
inline constexpr auto vtk = [](std::string_view bytes) { read_file("a.vtk", bytes); };
inline constexpr auto vtu = [](std::string_view bytes) { read_file("a.vtu", bytes); };
inline constexpr auto nsc = [](std::string_view bytes) { read_file("a.nsc", bytes); };

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
    Target{"off", off},
    Target{"obj", obj},
    Target{"ply", ply},
    Target{"stl", stl},
    Target{"medit", medit},
    Target{"gmsh", gmsh},
    Target{"tetgen", tetgen},
    Target{"vtk", vtk},
    Target{"vtu", vtu},
    Target{"nsc", nsc},
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
