// SPDX-License-Identifier: MIT
#include "base/printable.h"
#include "io/pictures/vtu.h"
#include "io/source_file.h"
#include "io/xml_text.h"
#include "system/atomic_file.h"

#include <fmt/format.h>

namespace polydec {

namespace {

std::string type_of(const VtuArray& array, const char* real) {
    return std::holds_alternative<std::vector<double>>(array.values) ? real : "Int32";
}

void list_arrays(AtomicFile& file, const char* tag, const std::vector<VtuArray>& arrays,
                 const char* real) {
    file.write(fmt::format("<{}>\n", tag));
    for (const VtuArray& array : arrays)
        file.write(fmt::format("<PDataArray type=\"{}\" Name=\"{}\"{}/>\n", type_of(array, real),
                               xml_escaped(array.name),
                               array.components > 1
                                   ? fmt::format(" NumberOfComponents=\"{}\"", array.components)
                                   : ""));
    file.write(fmt::format("</{}>\n", tag));
}

} // namespace

void check_lists_files(const std::filesystem::path& path) {
    const std::string name = path.filename().string();
    if (printable(name, name.size()) != name)
        refuse_writing(path, "its name has characters that a list of files cannot hold; choose "
                             "another name");
}

void write_pvtu(const std::filesystem::path& path, const VtuGrid& one,
                const std::vector<std::string>& pieces, const VtuOptions& options) {
    const char* real = options.numbers == VtuNumbers::float32 ? "Float32" : "Float64";
    AtomicFile file(path);
    file.write("<?xml version=\"1.0\"?>\n<VTKFile type=\"PUnstructuredGrid\" version=\"1.0\" "
               "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
               "<PUnstructuredGrid GhostLevel=\"0\">\n");
    file.write(fmt::format("<PPoints>\n<PDataArray type=\"{}\" Name=\"Points\" "
                           "NumberOfComponents=\"3\"/>\n</PPoints>\n",
                           real));
    list_arrays(file, "PPointData", one.point_data, real);
    list_arrays(file, "PCellData", one.cell_data, real);
    for (const std::string& piece : pieces)
        file.write(fmt::format("<Piece Source=\"{}\"/>\n", xml_escaped(piece)));
    file.write("</PUnstructuredGrid>\n</VTKFile>\n");
    file.commit();
}

} // namespace polydec
