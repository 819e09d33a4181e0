// SPDX-License-Identifier: MIT
#include "io/meshes/readers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace polydec {

namespace {

using namespace std::string_view_literals;

/// A format by the first bytes of its files, which stand behind blanks if it is text.
struct Mark {
    std::string_view begin;
    const char* name;
    const char* extension = ""; ///< of formats that are read: such files need another name
    const char* advice = "convert it, for instance with meshio";
};

constexpr const char* unpack = "unpack it";
constexpr const char* download = "download the file itself";
constexpr std::array marks{
    Mark{"version https://git-lfs"sv, "a pointer of Git LFS", "", "run git lfs pull"},
    Mark{"<!DOCTYPE html"sv, "a page of HTML", "", download},
    Mark{"<html"sv, "a page of HTML", "", download},
    Mark{"\x1F\x8B"sv, "compressed by gzip", "", unpack},
    Mark{"BZh"sv, "compressed by bzip2", "", unpack},
    Mark{"\xFD"
         "7zXZ"sv,
         "compressed by xz", "", unpack},
    Mark{"\x28\xB5\x2F\xFD"sv, "compressed by zstd", "", unpack},
    Mark{"PK\x03\x04"sv, "a zip archive", "", unpack},
    Mark{"%PDF"sv, "a PDF document", "", download},
    Mark{"MFEM"sv, "an MFEM mesh"},
    Mark{"\x89HDF"sv, "an HDF5 file, such as MED, CGNS, Exodus or XDMF"},
    Mark{"CDF\x01"sv, "a NetCDF file, such as Exodus"},
    Mark{"CDF\x02"sv, "a NetCDF file, such as Exodus"},
    Mark{"CDF\x05"sv, "a NetCDF file, such as Exodus"},
    Mark{"\x01\0\0\0"sv, "a binary MEDIT mesh (.meshb)", "",
         "convert it to text, for instance with transmesh"},
    Mark{"\0\0\0\x01"sv, "a binary MEDIT mesh (.meshb)", "",
         "convert it to text, for instance with transmesh"},
    Mark{"mesh3d"sv, "a Netgen mesh"},
    Mark{"surfacemesh"sv, "a Netgen mesh"},
    Mark{"NDIME"sv, "an SU2 mesh"},
    Mark{"(0 "sv, "a Fluent mesh"},
    Mark{"(2 "sv, "a Fluent mesh"},
    Mark{"CONTROL INFO"sv, "a GAMBIT mesh"},
    Mark{"TITLE"sv, "a Tecplot file"},
    Mark{"VARIABLES"sv, "a Tecplot file"},
    Mark{"/*--"sv, "a file of OpenFOAM"},
    Mark{"LIBMESH"sv, "a libMesh file"},
    Mark{"libMesh"sv, "a libMesh file"},
    Mark{"\x4C\x01"sv, "a compiled object file", "", download},
    Mark{"\x64\x86"sv, "a compiled object file", "", download},
    Mark{"\0\x10[Mesh"sv, "a mesh of OGRE"},
    Mark{"SolidWorks"sv, "a SolidWorks file", "", "mesh it, for instance with Gmsh"},
    Mark{"0\nSECTION"sv, "a DXF file"},
    Mark{"0\r\nSECTION"sv, "a DXF file"},
    Mark{"{"sv, "JSON, such as glTF"},
    Mark{"FoamFile"sv, "a file of OpenFOAM"},
    Mark{"*HEADING"sv, "an Abaqus input file"},
    Mark{"*Heading"sv, "an Abaqus input file"},
    Mark{"*NODE"sv, "an Abaqus input file"},
    Mark{"*Node"sv, "an Abaqus input file"},
    Mark{"BEGIN BULK"sv, "a Nastran file"},
    Mark{"GRID "sv, "a Nastran file"},
    Mark{"ISO-10303"sv, "a STEP file", "", "mesh it, for instance with Gmsh"},
    Mark{"glTF"sv, "a binary glTF file"},
    Mark{"Kaydara FBX"sv, "an FBX file"},
    Mark{"#VRML"sv, "a VRML file"},
    Mark{"\x93NUMPY"sv, "an array of NumPy"},
    Mark{"<dolfin"sv, "a mesh of FEniCS"},
    Mark{"<Xdmf"sv, "an XDMF file"},
    Mark{"<COLLADA"sv, "a COLLADA file"},
    Mark{"# vtk DataFile"sv, "a legacy VTK file", ".vtk"},
    Mark{"<VTKFile"sv, "an XML file of VTK", ".vtu"},
    Mark{"$MeshFormat"sv, "a Gmsh mesh", ".msh"},
    Mark{"$NOD"sv, "a Gmsh mesh", ".msh"},
    Mark{"MeshVersionFormatted"sv, "a MEDIT mesh", ".mesh"},
    Mark{"ply\n"sv, "a PLY file", ".ply"},
    Mark{"ply\r"sv, "a PLY file", ".ply"},
    Mark{"OFF"sv, "an OFF file", ".off"},
    Mark{"COFF"sv, "an OFF file", ".off"},
    Mark{"solid "sv, "an STL file", ".stl"},
    Mark{"v "sv, "an OBJ file", ".obj"},
    Mark{"# Blender"sv, "an OBJ file", ".obj"},
};

/// Behind a byte order mark, blanks and, of XML, the declaration and comments.
std::string_view beginning(std::string_view text) {
    if (text.starts_with("\xEF\xBB\xBF"))
        text.remove_prefix(3);
    const auto skip_blanks = [&text] {
        text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
    };
    skip_blanks();
    for (const auto& [opens, closes] : {std::pair{"<?"sv, "?>"sv}, std::pair{"<!--"sv, "-->"sv},
                                        std::pair{"<!DOCTYPE Xdmf"sv, ">"sv}})
        while (text.starts_with(opens)) {
            const auto end = text.find(closes);
            text.remove_prefix(end == std::string_view::npos ? text.size() : end + closes.size());
            skip_blanks();
        }
    return text;
}

} // namespace

std::string foreign_format(const SourceFile& file) {
    constexpr std::size_t longest_front = 1 << 16;
    const auto text = beginning(std::string_view(file.text).substr(0, longest_front));
    const auto own = lower_extension(file.name);
    if (own == ".msh" && !text.empty() && text[0] >= '0' && text[0] <= '9')
        return "a mesh of FreeFEM; save it with savemesh as .mesh";
    for (const auto& mark : marks) {
        if (!text.starts_with(mark.begin))
            continue;
        if (own == mark.extension)
            return {};
        return fmt::format("{}; {}", mark.name,
                           mark.extension[0] == '\0'
                               ? mark.advice
                               : fmt::format("rename it to end with {}", mark.extension));
    }
    return {};
}

} // namespace polydec
