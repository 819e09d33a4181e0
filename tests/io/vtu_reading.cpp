// SPDX-License-Identifier: MIT
#include "io/meshes/readers.h"
#include "tests/io/bytes.h"
#include "tests/io/support.h"

namespace polydec::test::in_vtu_reading {

using Cells = std::vector<std::vector<Index>>;

/// How the arrays of a file are written.
enum class Place { text, in_line, appended_base64, appended_raw };

struct Variant {
    Place place;
    std::endian order = std::endian::little;
    bool has_wide_headers = true;
    bool is_compressed = false;
    std::string longer = {}; ///< an array with one number more than belongs there
};

std::vector<Variant> variants() {
    std::vector<Variant> all{{Place::text}};
    for (const auto place : {Place::in_line, Place::appended_base64, Place::appended_raw}) {
        for (const auto order : {std::endian::little, std::endian::big}) {
            for (const bool wide : {false, true}) {
                all.push_back({place, order, wide, false});
                all.push_back({place, order, wide, true});
            }
        }
    }
    return all;
}

/// A zlib stream that stores the bytes as they are.
std::string stored(const std::string& bytes) {
    std::uint32_t low = 1;
    std::uint32_t high = 0;
    for (const char c : bytes) {
        low = (low + static_cast<unsigned char>(c)) % 65521;
        high = (high + low) % 65521;
    }
    const auto size = static_cast<std::uint16_t>(bytes.size());
    return from_hex("780101") + bytes_of(size, std::endian::little) +
           bytes_of(static_cast<std::uint16_t>(~size), std::endian::little) + bytes +
           bytes_of(high << 16U | low, std::endian::big);
}

class Writer {
public:
    explicit Writer(const Variant& variant) : variant_(variant) {
        text_ = std::string("<?xml version=\"1.0\"?>\n<!-- a comment -->\n<VTKFile "
                            "type='UnstructuredGrid' version=\"1.0\" byte_order=\"") +
                (variant.order == std::endian::big ? "Big" : "Little") +
                "Endian\" header_type=\"UInt" + (variant.has_wide_headers ? "64" : "32") + "\"" +
                (variant.is_compressed ? " compressor=\"vtkZLibDataCompressor\"" : "") +
                ">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"5\" NumberOfCells=\"3\">\n";
    }

    Writer& line(const std::string& text) {
        text_ += text + "\n";
        return *this;
    }

    template <typename Number>
    Writer& array(const std::string& type, const std::string& attributes,
                  std::vector<Number> values) {
        constexpr std::array formats{"ascii", "binary", "appended", "appended"};
        if (!variant_.longer.empty() && attributes.starts_with("Name=\"" + variant_.longer + "\""))
            values.push_back(values.back());
        text_ += "<DataArray type=\"" + type + "\" " + attributes + " format=\"" +
                 formats[static_cast<std::size_t>(variant_.place)] + "\"";
        const auto [header, body] = encoded(bytes_of_all<Number>(values, variant_.order));
        switch (variant_.place) {
        case Place::text:
            text_ += ">\n";
            for (const auto value : values)
                text_ += std::to_string(value) + " ";
            break;
        case Place::in_line:
            text_ += ">\n" + in_base64(header, body);
            break;
        case Place::appended_base64:
            text_ += " offset=\"" + std::to_string(appended_.size()) + "\">";
            appended_ += in_base64(header, body);
            break;
        case Place::appended_raw:
            text_ += " offset=\"" + std::to_string(appended_.size()) + "\">";
            appended_ += header + body;
        }
        return line("\n<InformationKey name=\"x\"><Value>9</Value></InformationKey></DataArray>");
    }

    std::string text() const {
        auto text = text_ + "</Piece>\n</UnstructuredGrid>\n";
        if (!appended_.empty()) {
            text += std::string("<AppendedData encoding=\"") +
                    (variant_.place == Place::appended_raw ? "raw" : "base64") + "\">\n_" +
                    appended_ + "\n</AppendedData>\n";
        }
        return text + "</VTKFile>\n";
    }

private:
    /// What stands in front of an array, and its bytes: of a compressed one in blocks of 16.
    std::pair<std::string, std::string> encoded(const std::string& bytes) const {
        if (!variant_.is_compressed)
            return {header({bytes.size()}), bytes};
        constexpr std::size_t block = 16;
        std::vector<std::size_t> numbers{(bytes.size() + block - 1) / block, block,
                                         bytes.size() % block};
        std::string body;
        for (std::size_t begin = 0; begin < bytes.size(); begin += block) {
            const auto piece = stored(bytes.substr(begin, block));
            numbers.push_back(piece.size());
            body += piece;
        }
        return {header(numbers), body};
    }

    std::string header(const std::vector<std::size_t>& numbers) const {
        return variant_.has_wide_headers ? bytes_of_all<std::uint64_t>(numbers, variant_.order)
                                         : bytes_of_all<std::uint32_t>(numbers, variant_.order);
    }

    /// The header of a compressed array is a text of its own.
    std::string in_base64(const std::string& header, const std::string& body) const {
        return variant_.is_compressed ? base64(header) + base64(body) : base64(header + body);
    }

    Variant variant_;
    std::string text_;
    std::string appended_;
};

/// Two tetrahedra and a triangle between them.
std::string grid(const Variant& variant, std::uint8_t last_type = 10) {
    Writer writer(variant);
    writer.line("<PointData>").array<float>("Float32", "Name=\"material\"", {1, 2, 3, 4, 5});
    writer.line("</PointData>\n<CellData Scalars='q'>");
    writer.array<double>("Float64", "Name=\"q\"", {0.5, 1, 2});
    writer.array<std::int16_t>("Int16", "Name=\"gmsh:physical\"", {11, 40, 12});
    writer.line("</CellData>\n<Points>");
    writer.array<double>("Float64", "Name=\"Points\" NumberOfComponents=\"3\"",
                         {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1.25});
    writer.line("</Points>\n<Cells>");
    writer.array<std::int64_t>("Int64", "Name=\"connectivity\"", {0, 1, 2, 3, 0, 1, 2, 1, 2, 3, 4});
    writer.array<std::int32_t>("Int32", "Name=\"offsets\"", {4, 7, 11});
    writer.array<std::uint8_t>("UInt8", "Name=\"types\"", {10, 5, last_type});
    return writer.line("</Cells>").text();
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
    return text.replace(text.find(what), what.size(), by);
}

std::string written(const VtuGrid& grid) {
    const TemporaryFolder folder;
    write_vtu(folder.path("a.vtu"), grid);
    return read_text(folder.path("a.vtu"));
}

VtuGrid cube_corner() {
    VtuGrid grid;
    grid.points = Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1. / 3, 1e-300, -7e300}};
    return grid;
}

const Variant as_text{Place::text};

TEST(VtuReading, EveryEncodingIsTheSame) {
    for (const auto& variant : variants()) {
        const auto mesh = parse_mesh({"a.vtu", grid(variant)});
        EXPECT_EQ(rows(mesh.points),
                  (std::vector<std::vector<double>>{
                      {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1.25}}));
        expect_two_tetrahedra(mesh);
    }
}

TEST(VtuReading, TheOtherOrderOfBytesDoesNotFit) {
    // The twin of the proposition above.
    for (const auto& variant : variants()) {
        if (variant.place != Place::text) {
            const bool big = variant.order == std::endian::big;
            const auto damaged = replaced(grid(variant), big ? "BigEndian" : "LittleEndian",
                                          big ? "LittleEndian" : "BigEndian");
            EXPECT_UNREADABLE("a.vtu", damaged, "a.vtu:");
        }
    }
}

TEST(VtuReading, WhatIsWrittenIsReadToTheLastBit) {
    auto grid = cube_corner();
    add_cell(grid, VtuCell::tetra, std::array<Index, 4>{0, 1, 2, 3});
    add_cell(grid, VtuCell::triangle, std::array<Index, 3>{0, 1, 2});
    add_cell(grid, VtuCell::tetra, std::array<Index, 4>{1, 2, 3, 4});
    grid.cell_data.push_back({"material", std::vector<Index>{-3, 1, 2}, 1});
    const auto mesh = read_from("a.vtu", written(grid));
    EXPECT_EQ(rows(mesh.points), rows(grid.points));
    EXPECT_EQ(rows(mesh.simplices), (Cells{{0, 1, 2, 3}, {1, 2, 3, 4}}));
    EXPECT_EQ(mesh.tags, (std::vector<Index>{-3, 2}));
}

TEST(VtuReading, PolygonsThatAreWrittenAreSplitLikeThoseThatAreGiven) {
    PolygonMesh polygons;
    polygons.points =
        Points{{0, 0, 0}, {1, 0, 0}, {1.5, 1, 0}, {0.5, 2, 0}, {-0.5, 1, 0}, {2, -1, 0}, {3, 0, 0}};
    polygons.corners = {0, 1, 2, 3, 4, 1, 5, 6, 2, 4, 3, 2};
    polygons.offsets = {0, 5, 9, 12};
    polygons.tags = {4, 5, 6};
    const auto mesh = split_polygons(polygons);
    EXPECT_EQ(mesh.tags, (std::vector<Index>{4, 4, 4, 5, 5, 6}));

    VtuGrid grid;
    grid.points = polygons.points;
    add_cell(grid, VtuCell::polygon, std::array<Index, 5>{0, 1, 2, 3, 4});
    add_cell(grid, VtuCell::quad, std::array<Index, 4>{1, 5, 6, 2});
    add_cell(grid, VtuCell::triangle, std::array<Index, 3>{4, 3, 2});
    grid.cell_data.push_back({"gmsh:physical", polygons.tags, 1});
    const auto read = read_from("a.vtu", written(grid));
    EXPECT_TRUE(same(read, mesh));
    EXPECT_EQ(read.tags, mesh.tags);
    EXPECT_EQ(read.warnings, mesh.warnings);
}

TEST(VtuReading, PolyhedraAreRefused) {
    auto grid = cube_corner();
    add_cell(grid, VtuCell::tetra, std::array<Index, 4>{1, 2, 3, 4});
    add_polyhedron(grid, {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}});
    EXPECT_UNREADABLE("a.vtu", written(grid), "a.vtu:11", "cell 1", "polyhedron", "type 42");
}

TEST(VtuReading, RefusesOtherGridsAndEncodings) {
    const auto with = [](const std::string& what, const std::string& by) {
        return replaced(grid(as_text), what, by);
    };
    EXPECT_UNREADABLE("a.vtu", with("UnstructuredGrid", "PolyData"), "a.vtu:3", "PolyData",
                      "UnstructuredGrid");
    EXPECT_UNREADABLE("a.vtu", with("UInt64\"", "UInt64\" compressor=\"vtkLZ4DataCompressor\""),
                      "a.vtu:3", "compressed", "vtkLZ4DataCompressor", "vtkZLibDataCompressor");
    EXPECT_UNREADABLE("a.vtu", with("UInt64", "UInt16"), "a.vtu:3", "header_type", "UInt16",
                      "UInt32", "UInt64");
    EXPECT_UNREADABLE("a.vtu", with("LittleEndian", "PDP"), "a.vtu:3", "bytes", "PDP",
                      "LittleEndian");
    EXPECT_UNREADABLE("a.vtu", with("<Points>", "<Piece NumberOfCells=\"1\"/><Points>"), "a.vtu:38",
                      "no array", "points");
    EXPECT_UNREADABLE("a.vtu", with("NumberOfComponents=\"3\"", "NumberOfComponents=\"2\""),
                      "a.vtu:38", "points", "three components");
    EXPECT_UNREADABLE("a.vtu", with("Name=\"types\"", "Name=\"kinds\""), "a.vtu:38", "no array",
                      "types");
    EXPECT_UNREADABLE("a.vtu", with("Int32", "String"), "a.vtu:28", "type", "String");
    EXPECT_UNREADABLE("a.vtu", with("1.250000", "nan"), "a.vtu:20", "vertex 4", "NaN");
    EXPECT_UNREADABLE("a.vtu", grid(as_text, 12), "a.vtu:25", "cell 2", "type 12", "4 corners");
}

TEST(VtuReading, RefusesBrokenXml) {
    EXPECT_UNREADABLE("a.vtu", "no XML at all", "a.vtu:1", "VTKFile");
    EXPECT_UNREADABLE("a.vtu", "<a>\n<b></a>", "a.vtu:2", "element 'a'", "end of 'b'");
    EXPECT_UNREADABLE("a.vtu", "<a>\n", "a.vtu:2", "file ends", "element 'a'");
    EXPECT_UNREADABLE("a.vtu", "<a b>", "a.vtu:1", "attribute", "value");
    EXPECT_UNREADABLE("a.vtu", "<a b=c>", "a.vtu:1", "attribute", "quotes");
    EXPECT_UNREADABLE("a.vtu", "<!DOCTYPE a>", "a.vtu:1", "!DOCTYPE a", "name");
    EXPECT_UNREADABLE("a.vtu", "<!-- >", "a.vtu:1", "file ends", "comment");
}

TEST(VtuReading, DamagedArraysAreNamed) {
    const auto damaged = [](const Variant& variant, char by) {
        auto text = grid(variant);
        const auto array = text.find("\"connectivity\"");
        text[text.find(">\n", array) + 70] = by;
        return text;
    };
    EXPECT_UNREADABLE("a.vtu", damaged({Place::in_line}, '*'), "a.vtu:25", "array", "88", "base64");
    EXPECT_UNREADABLE("a.vtu", damaged({Place::in_line, std::endian::little, false, true}, '/'),
                      "a.vtu:25", "block 0", "compressed", "zlib");
}

TEST(VtuReading, ArraysHaveTheNumbersThatTheirPieceTells) {
    for (auto variant : variants())
        for (const auto& [name, wanted] : {std::pair("Points", 15),
                                           {"connectivity", 11},
                                           {"offsets", 3},
                                           {"types", 3},
                                           {"gmsh:physical", 3}}) {
            variant.longer = name;
            EXPECT_UNREADABLE("a.vtu", grid(variant), "a.vtu:", name,
                              fmt::format("{} numbers", wanted + 1),
                              fmt::format("expected {}", wanted));
        }
}

TEST(VtuReading, NothingIsInflatedForAPromiseThatIsTooLarge) {
    // The streams are not even there.
    const auto header = bytes_of_all<std::uint64_t>(
        std::vector<std::size_t>{2, std::size_t{1} << 40U, 0, 16, 16}, std::endian::little);
    const auto text = replaced(grid({Place::in_line, std::endian::little, true, true}),
                               "NumberOfComponents=\"3\" format=\"binary\">\n",
                               "NumberOfComponents=\"3\" format=\"binary\">\n" + base64(header));
    EXPECT_UNREADABLE("a.vtu", text, "a.vtu:", "Points", "274877906944 numbers", "expected 15");
    const auto spaced = replaced(grid({Place::in_line, std::endian::little, true, true}),
                                 "NumberOfPoints=\"5\"", "NumberOfPoints=\"   5\"");
    EXPECT_EQ(parse_mesh({"a.vtu", spaced}).points.rows(), 5);
}

TEST(VtuReading, ClaimsOfGiantPiecesAreRefusedBeforeAnythingIsInflated) {
    const Variant variant{Place::in_line, std::endian::little, true, true};
    const std::string giant = std::to_string(std::size_t{1} << 40U);
    const auto points = "NumberOfComponents=\"3\" format=\"binary\">\n";
    // a stream of points that is damaged behind its header, so that inflating it would be told
    auto damaged = grid(variant);
    damaged[damaged.find(points) + std::string(points).size() + 120] = '/';
    EXPECT_UNREADABLE("a.vtu", damaged, "a.vtu:", "block");
    EXPECT_UNREADABLE("a.vtu", replaced(damaged, "OfCells=\"3", "OfCells=\"" + giant),
                      "a.vtu:", "offsets", "3 numbers", "expected 1099511627776");
    EXPECT_UNREADABLE("a.vtu", replaced(damaged, "OfPoints=\"5", "OfPoints=\"" + giant),
                      "a.vtu:", "Points", "15 numbers", "expected 3298534883328");

    // what stands in front of the array agrees, but no file of this size holds so much
    const auto header = bytes_of_all<std::uint64_t>(
        std::vector<std::size_t>{1, std::size_t{24} << 40U, 0, 16}, std::endian::little);
    const auto agreed = replaced(replaced(grid(variant), "OfPoints=\"5", "OfPoints=\"" + giant),
                                 points, points + base64(header));
    EXPECT_UNREADABLE("a.vtu", agreed, "a.vtu:", "Points", "26388279066624 bytes", "rest");
}

} // namespace polydec::test::in_vtu_reading
