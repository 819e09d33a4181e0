// SPDX-License-Identifier: MIT
#include "tests/io/bytes.h"
#include "tests/io/support.h"

namespace polydec::test::in_ply {

using Cells = std::vector<std::vector<Index>>;
const Cells two_triangles{{0, 1, 2}, {0, 2, 3}};

const std::string header_end = "element vertex 4\nproperty float x\nproperty float y\n"
                               "property float z\nelement face 2\n"
                               "property list uchar int vertex_indices\nend_header\n";
const std::string body = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n";

std::endian endian(const std::string& order) {
    return order == "big" ? std::endian::big : std::endian::little;
}

std::string binary_header(const std::string& order, const std::string& line_break = "\n") {
    return with_line_breaks("ply\nformat binary_" + order + "_endian 1.0\n" + header_end,
                            line_break);
}

std::string small_binary(const std::string& order, const std::string& line_break = "\n") {
    std::string text =
        binary_header(order, line_break) +
        bytes_of_all<float>(std::vector{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, endian(order));
    for (const auto& triangle : two_triangles)
        text += "\3" + bytes_of_all<Index>(triangle, endian(order));
    return text;
}

TEST(Ply, AsciiAndBothBinariesAreTheSame) {
    const auto ascii = read_from("a.ply", "ply\nformat ascii 1.0\ncomment x\n" + header_end + body);
    EXPECT_EQ(rows(ascii.simplices), two_triangles);
    EXPECT_TRUE(same(ascii, read_from("a.ply", small_binary("little"))));
    EXPECT_TRUE(same(ascii, read_from("a.ply", small_binary("big"))));
}

TEST(Ply, MayBeginWithAByteOrderMark) {
    const std::string text = "ply\nformat ascii 1.0\n" + header_end + body;
    for (const auto& file : {text, small_binary("little"), small_binary("big")})
        EXPECT_TRUE(same(read_from("a.ply", text), read_from("a.ply", "\xEF\xBB\xBF" + file)));
}

TEST(Ply, BinaryBodyMayBeginWithTheByteOfALineBreak) {
    for (const std::string line_break : {"\n", "\r\n", "\r"}) {
        auto text = small_binary("little", line_break);
        text[binary_header("little", line_break).size()] = '\n';
        EXPECT_EQ(read_from("a.ply", text).points(0, 0),
                  10 * std::numeric_limits<float>::denorm_min());
    }
}

TEST(Ply, EveryTypeAndStrangePropertiesAreRead) {
    for (const std::string order : {"little", "big"}) {
        std::string text =
            "ply\nformat binary_" + order +
            "_endian 1.0\nobj_info x\nelement thing 1\nproperty list ushort double l\n"
            "element empty 3\n"
            "element vertex 3\nproperty list uchar short s\nproperty double x\n"
            "property char c\nproperty int8 y\nproperty uint u\nproperty int16 z\n"
            "element face 1\nproperty float q\nproperty list int uint16 vertex_index\n"
            "property list char float64 t\nend_header\n";
        const auto add = [&](auto... numbers) {
            ((text += bytes_of(numbers, endian(order))), ...);
        };
        add(std::uint16_t{2}, 1.0, 2.0);
        for (int i = 0; i < 3; ++i)
            add(std::uint8_t{1}, std::int16_t{7}, 0.25 * i, 'c', std::int8_t(-i * i),
                std::uint32_t{9}, std::int16_t(-300 * i));
        add(1.5F, std::int32_t{3}, std::uint16_t{2}, std::uint16_t{0}, std::uint16_t{1},
            std::int8_t{1}, 0.5);
        const auto mesh = read_from("a.ply", text);
        EXPECT_EQ(rows(mesh.points),
                  (std::vector<std::vector<double>>{{0, 0, 0}, {0.25, -1, -300}, {0.5, -4, -600}}));
        EXPECT_EQ(rows(mesh.simplices), (Cells{{2, 0, 1}}));
    }
}

TEST(Ply, FacesMayComeFirst) {
    const auto mesh = read_from("a.ply", "ply\nformat ascii 1.0\nelement face 1\n"
                                         "property list uchar uint vertex_index\nelement vertex 3\n"
                                         "property float z\nproperty float y\nproperty float x\n"
                                         "end_header\n3 2 1 0\n0 0 0\n0 0 1\n0 1 0\n");
    EXPECT_EQ(rows(mesh.points),
              (std::vector<std::vector<double>>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    EXPECT_EQ(rows(mesh.simplices), (Cells{{2, 1, 0}}));
}

TEST(Ply, OfEdgesAloneIsACurve) {
    const auto text = [](const std::string& elements, const std::string& records) {
        return "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n" +
               elements + "end_header\n0 0\n1 0\n1 1\n" + records;
    };
    const std::string edges = "element edge 2\nproperty int vertex1\nproperty int vertex2\n"
                              "property uchar red\n",
                      face = "element face 1\nproperty list uchar int vertex_indices\n";
    EXPECT_EQ(rows(read_from("a.ply", text(edges, "0 1 9\n1 2 9\n")).simplices),
              (Cells{{0, 1}, {1, 2}}));
    EXPECT_EQ(rows(read_from("a.ply", text(edges + face, "0 1 9\n1 2 9\n3 0 1 2\n")).simplices),
              (Cells{{0, 1, 2}}));
    EXPECT_UNREADABLE("a.ply", text(edges, "0 1 9\n1 3 9\n"), "a.ply:15", "edge 1",
                      "vertex number 3", "0", "2");
}

TEST(Ply, WarnsOfWhatFollows) {
    EXPECT_EACH_SAYS(read_from("a.ply", small_binary("little") + "abc").warnings,
                     {"3 bytes", "last element"});
}

TEST(Ply, RefusesBrokenHeaders) {
    const std::string start = "ply\nformat ascii 1.0\n";
    const std::string vertex = "element vertex 1\nproperty float x\nproperty float y\n";
    EXPECT_UNREADABLE("a.ply", "plx\n", "a.ply:1", "word ply");
    EXPECT_UNREADABLE("a.ply", "ply\nformat ascii 1.0\nelement vertex 3\n", "a.ply:4", "file ends",
                      "end_header");
    EXPECT_UNREADABLE("a.ply", "ply\nformat text 1.0\n", "a.ply:2", "text", "ascii");
    EXPECT_UNREADABLE("a.ply", "ply\n" + header_end + body, "a.ply:8", "header", "format");
    EXPECT_UNREADABLE("a.ply", start + "property float x\n", "a.ply:3", "property", "element");
    EXPECT_UNREADABLE("a.ply", start + vertex + "property quad z\n", "a.ply:6", "quad", "type");
    EXPECT_UNREADABLE("a.ply", start + vertex + "property float\nend_header\n", "a.ply:6",
                      "line ends", "property");
    EXPECT_UNREADABLE("a.ply", start + vertex + "property list float int q\n", "a.ply:6", "length",
                      "list");
    EXPECT_UNREADABLE("a.ply", start + vertex + vertex + "end_header\n", "a.ply:6", "element",
                      "vertex", "twice");
    EXPECT_UNREADABLE("a.ply", start + vertex + "nonsense\n", "a.ply:6", "nonsense", "keyword");
    EXPECT_UNREADABLE("a.ply", start + "element vertex 1\nproperty float x\nend_header\n0\n",
                      "a.ply:6", "vertex", "y");
    EXPECT_UNREADABLE("a.ply",
                      start + "element face 1\nproperty int vertex_indices\n"
                              "end_header\n3\n",
                      "a.ply:6", "face", "list", "vertex_indices");
    EXPECT_UNREADABLE("a.ply", start + header_end, "a.ply:3", "4 elements", "vertex", "1 bytes",
                      "6 bytes");
}

TEST(Ply, RefusesBrokenBodies) {
    const std::string start = "ply\nformat ascii 1.0\n" + header_end;
    const std::string vertices = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
    EXPECT_UNREADABLE("a.ply", start + vertices + "3 0 1 2\n3 0 2 4\n", "a.ply:15", "face 1",
                      "vertex", "4", "0", "3");
    EXPECT_UNREADABLE("a.ply", start + vertices + "3 0 1 2\n3 0 2.5 3\n", "a.ply:15", "face 1",
                      "vertex", "2.5", "0", "3");
    EXPECT_UNREADABLE("a.ply", start + vertices + "3 0 1 2 9\n3 0 2 3\n", "a.ply:14", "9", "line",
                      "element");
    EXPECT_UNREADABLE("a.ply", start + vertices + "-3 0 1 2\n3 0 2 3\n", "a.ply:14", "list", "-3",
                      "15 bytes");
    EXPECT_UNREADABLE("a.ply", start + vertices + "3 0 1 2\n", "a.ply:15", "file ends", "number");
    EXPECT_UNREADABLE("a.ply", start + "0 0 0\n1 0 nan\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n",
                      "a.ply:11", "vertex 1", "coordinate", "NaN");
}

TEST(Ply, RefusesBrokenBinaryBodies) {
    const auto text = small_binary("little");
    EXPECT_UNREADABLE("a.ply", text.substr(0, text.size() - 1), "a.ply",
                      "byte " + std::to_string(text.size() - 4), "file ends", "elements");
    auto far_index = text;
    far_index[text.size() - 1] = '\x7F';
    EXPECT_UNREADABLE("a.ply", far_index, "a.ply", "byte " + std::to_string(text.size()), "face 1",
                      "vertex", "2130706435", "0", "3");
    auto infinite = text;
    const auto begin = binary_header("little").size();
    infinite.replace(begin, 4, std::string("\0\0\x80\x7F", 4));
    EXPECT_UNREADABLE("a.ply", infinite, "a.ply", "byte " + std::to_string(begin + 4), "vertex 0",
                      "coordinate", "NaN");
    auto long_list = text;
    long_list[begin + 48] = '\xFF';
    EXPECT_UNREADABLE("a.ply", long_list, "a.ply", "byte " + std::to_string(begin + 49), "list",
                      "255", "25 bytes");
}

} // namespace polydec::test::in_ply
