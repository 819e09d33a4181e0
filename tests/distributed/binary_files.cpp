// SPDX-License-Identifier: MIT
#include "tests/distributed/binary_files.h"

#include "tests/io/bytes.h"

namespace polydec::test {

namespace {

using test::bytes_of;

class Bytes {
public:
    explicit Bytes(const BinaryKind& kind) : kind_(kind) {}

    void text(const std::string& text) { bytes_ += text; }
    void integer(std::int64_t value) { put(static_cast<std::int32_t>(value)); }
    void byte(int value) { bytes_ += static_cast<char>(value); }
    void size(std::int64_t value) { kind_.is_narrow ? integer(value) : put(value); }
    void real(double value) { put(value); }
    void coordinate(double value) { kind_.is_narrow ? put(static_cast<float>(value)) : put(value); }
    void point(const Mesh& mesh, Index v, bool always_wide = false) {
        for (int axis = 0; axis < 3; ++axis) {
            const double x = axis < mesh.points.cols() ? mesh.points(v, axis) : 0;
            always_wide ? real(x) : coordinate(x);
        }
    }
    const std::string& all() const { return bytes_; }

private:
    template <typename Number>
    void put(Number value) {
        bytes_ += bytes_of(value, kind_.order);
    }

    BinaryKind kind_;
    std::string bytes_;
};

/// What a file calls vertex v.
std::int64_t number_of(const Mesh& mesh, const BinaryKind& kind, Index v) {
    return kind.is_scrambled ? 11 + 2 * (mesh.points.rows() - v) : v + 1;
}

constexpr int gmsh_types[] = {15, 1, 2, 4}, vtk_types[] = {1, 3, 5, 10};

void put_old_elements(Bytes& bytes, const Mesh& mesh, const BinaryKind& kind) {
    const int n = mesh.dimension();
    const Index boundary = kind.has_more ? 2 : 0, cells = static_cast<Index>(mesh.simplices.rows());
    bytes.text(fmt::format("$Elements\n{}\n", boundary + cells));
    const auto element = [&](int corners, Index cell, std::int64_t number) {
        for (const std::int64_t word : {number, std::int64_t{7 + cell % 2}, std::int64_t{1}})
            bytes.integer(word);
        for (int i = 0; i < corners; ++i)
            bytes.integer(number_of(mesh, kind, mesh.simplices(cell, i)));
    };
    for (Index b = 0; b < boundary; ++b) {
        for (const int word : {gmsh_types[n - 1], 1, 2})
            bytes.integer(word);
        element(n, b % cells, b + 1);
    }
    for (Index begin = 0; begin < cells; begin += kind.block) {
        const Index count = std::min<Index>(kind.block, cells - begin);
        for (const Index word : {Index{gmsh_types[n]}, count, Index{2}})
            bytes.integer(word);
        for (Index cell = begin; cell < begin + count; ++cell)
            element(n + 1, cell, boundary + cell + 1);
    }
    bytes.text("\n$EndElements\n");
}

void put_old_nodes(Bytes& bytes, const Mesh& mesh, const BinaryKind& kind) {
    bytes.text(fmt::format("$Nodes\n{}\n", mesh.points.rows()));
    for (Index v = 0; v < mesh.points.rows(); ++v) {
        bytes.integer(number_of(mesh, kind, v));
        bytes.point(mesh, v, true);
    }
    bytes.text("\n$EndNodes\n");
}

/// One volume or surface that belongs to two groups.
void put_entities(Bytes& bytes, int n) {
    bytes.text("$Entities\n");
    for (int k = 0; k <= 3; ++k)
        bytes.size(k == n ? 1 : 0);
    bytes.integer(1);
    for (int i = 0; i < 6; ++i)
        bytes.real(0.5 * i);
    bytes.size(2);
    bytes.integer(30);
    bytes.integer(31);
    bytes.size(0);
    bytes.text("\n$EndEntities\n");
}

void put_nodes(Bytes& bytes, const Mesh& mesh, const BinaryKind& kind) {
    const auto count = static_cast<Index>(mesh.points.rows());
    bytes.text("$Nodes\n");
    for (const Index word : {(count + kind.block - 1) / kind.block, count, Index{1}, 5 * count})
        bytes.size(word);
    for (Index begin = 0; begin < count; begin += kind.block) {
        const Index end = std::min<Index>(count, begin + kind.block);
        const int entity = kind.has_more ? 2 : 3; // with two parameters each on a surface
        for (const int word : {entity, 1, kind.has_more ? 1 : 0})
            bytes.integer(word);
        bytes.size(end - begin);
        for (Index v = begin; v < end; ++v)
            bytes.size(number_of(mesh, kind, v));
        for (Index v = begin; v < end; ++v) {
            bytes.point(mesh, v, true);
            for (int parameter = 0; parameter < (kind.has_more ? 2 : 0); ++parameter)
                bytes.real(-1);
        }
    }
    bytes.text("\n$EndNodes\n");
}

void put_elements(Bytes& bytes, const Mesh& mesh, const BinaryKind& kind) {
    const int n = mesh.dimension();
    const auto count = static_cast<Index>(mesh.simplices.rows());
    const Index boundary = kind.has_more ? 1 : 0;
    bytes.text("$Elements\n");
    for (const Index word : {boundary + (count + kind.block - 1) / kind.block, boundary + count,
                             Index{1}, boundary + count})
        bytes.size(word);
    const auto block = [&](int dimension, Index begin, Index end) {
        for (const int word : {dimension, 1, gmsh_types[dimension]})
            bytes.integer(word);
        bytes.size(end - begin);
        for (Index cell = begin; cell < end; ++cell) {
            bytes.size(cell + 1);
            for (int i = 0; i <= dimension; ++i)
                bytes.size(number_of(mesh, kind, mesh.simplices(cell, i)));
        }
    };
    if (boundary > 0)
        block(n - 1, 0, 1);
    for (Index begin = 0; begin < count; begin += kind.block)
        block(n, begin, std::min<Index>(count, begin + kind.block));
    bytes.text("\n$EndElements\n");
}

} // namespace

std::string binary_ply(const Mesh& mesh, const BinaryKind& kind) {
    const char* real = kind.is_narrow ? "float" : "double";
    Bytes bytes(kind);
    bytes.text(fmt::format("ply\nformat binary_{}_endian 1.0\ncomment made here\n"
                           "element vertex {}\n{}property {} x\nproperty {} y\nproperty {} z\n"
                           "element face {}\n{}property list uchar {} vertex_ind{}\nend_header\n",
                           kind.order == std::endian::little ? "little" : "big", mesh.points.rows(),
                           kind.has_more ? "property uchar red\n" : "", real, real, real,
                           mesh.simplices.rows(), kind.has_more ? "property double quality\n" : "",
                           kind.has_more ? "uint" : "int", kind.has_more ? "ex" : "ices"));
    for (Index v = 0; v < mesh.points.rows(); ++v) {
        if (kind.has_more)
            bytes.byte(200);
        bytes.point(mesh, v);
    }
    for (Index t = 0; t < mesh.simplices.rows(); ++t) {
        if (kind.has_more)
            bytes.real(0.5);
        bytes.byte(3);
        for (int i = 0; i < 3; ++i)
            bytes.integer(mesh.simplices(t, i));
    }
    if (kind.has_more)
        bytes.text("more");
    return bytes.all();
}

std::string binary_gmsh(const Mesh& mesh, const BinaryKind& kind) {
    Bytes bytes(kind);
    bytes.text(fmt::format("$MeshFormat\n{} 1 {}\n", kind.is_old ? "2.2" : "4.1",
                           kind.is_narrow && !kind.is_old ? 4 : 8));
    bytes.integer(1);
    bytes.text("\n$EndMeshFormat\n");
    if (kind.has_more)
        bytes.text("$PhysicalNames\n1\n2 7 \"wall\"\n$EndPhysicalNames\n");
    if (kind.has_more && !kind.is_old)
        put_entities(bytes, mesh.dimension());
    kind.is_old ? put_old_nodes(bytes, mesh, kind) : put_nodes(bytes, mesh, kind);
    kind.is_old ? put_old_elements(bytes, mesh, kind) : put_elements(bytes, mesh, kind);
    return bytes.all();
}

std::string binary_vtu(const Mesh& mesh, const BinaryKind& kind) {
    const auto cells = static_cast<Index>(mesh.simplices.rows());
    const int n = mesh.dimension();
    Bytes points(kind), corners(kind), ends(kind), types(kind), tags(kind);
    for (Index v = 0; v < mesh.points.rows(); ++v)
        points.point(mesh, v);
    for (Index t = 0; t < cells; ++t) {
        for (const Index v : mesh.simplices.row(t))
            corners.size(v);
        ends.integer((n + 1) * (t + 1));
        types.byte(vtk_types[n]);
        tags.integer(t % 3);
    }
    std::string arrays, appended;
    const auto array = [&](const std::string& type, const std::string& more, const Bytes& bytes) {
        arrays += fmt::format("<DataArray type=\"{}\" {} format=\"appended\" offset=\"{}\"/>\n",
                              type, more, appended.size());
        const auto length = bytes.all().size();
        appended += kind.is_narrow ? bytes_of(static_cast<std::uint32_t>(length), kind.order)
                                   : bytes_of(static_cast<std::uint64_t>(length), kind.order);
        appended += bytes.all();
    };
    const std::string whole = kind.is_narrow ? "Int32" : "Int64";
    if (kind.has_more) {
        arrays += "<CellData>\n";
        array("Int32", "Name=\"material\"", tags);
        arrays += "</CellData>\n";
    }
    arrays += "<Points>\n";
    array(kind.is_narrow ? "Float32" : "Float64", "NumberOfComponents=\"3\"", points);
    arrays += "</Points>\n<Cells>\n";
    array(whole, "Name=\"connectivity\"", corners);
    array("Int32", "Name=\"offsets\"", ends);
    array("UInt8", "Name=\"types\"", types);
    return fmt::format(
               "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
               "byte_order=\"{}\" header_type=\"{}\">\n<UnstructuredGrid>\n"
               "<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n",
               kind.order == std::endian::little ? "LittleEndian" : "BigEndian",
               kind.is_narrow ? "UInt32" : "UInt64", mesh.points.rows(), cells) +
           arrays + "</Cells>\n</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_" +
           appended + "\n</AppendedData>\n</VTKFile>\n";
}

} // namespace polydec::test
