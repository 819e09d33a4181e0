// SPDX-License-Identifier: MIT
#include "tests/io/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <limits>

namespace polydec::tests {

namespace {

using Cells = std::vector<std::vector<Index>>;
const Cells two_triangles{{0, 1, 2}, {0, 2, 3}};

const std::string header_end = "element vertex 4\nproperty float x\nproperty float y\n"
                               "property float z\nelement face 2\n"
                               "property list uchar int vertex_indices\nend_header\n";
const std::string body = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n";

/// Appends numbers in the byte order that is asked for; this machine's own is the lowest first.
class Bytes {
public:
    explicit Bytes(std::string header, std::string order)
        : text_(std::move(header)), order_(order) {}

    template <typename Number>
    Bytes& add(Number number) {
        char bytes[sizeof(Number)];
        std::memcpy(bytes, &number, sizeof(Number));
        if (order_ == "big") {
            std::reverse(bytes, bytes + sizeof(Number));
        }
        text_.append(bytes, sizeof(Number));
        return *this;
    }

    const std::string& text() const { return text_; }

private:
    std::string text_;
    std::string order_;
};

std::string binary_header(const std::string& order, const std::string& line_break = "\n") {
    return with_line_breaks("ply\nformat binary_" + order + "_endian 1.0\n" + header_end,
                            line_break);
}

std::string small_binary(const std::string& order, const std::string& line_break = "\n") {
    Bytes bytes(binary_header(order, line_break), order);
    for (const float value : {0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 1.F, 1.F, 0.F, 0.F, 1.F, 0.F}) {
        bytes.add(value);
    }
    for (const auto& triangle : two_triangles) {
        bytes.add(std::uint8_t{3}).add(triangle[0]).add(triangle[1]).add(triangle[2]);
    }
    return bytes.text();
}

} // namespace

TEST(Ply, AsciiAndBothBinariesAreTheSame) {
    const auto ascii = read_from("a.ply", "ply\nformat ascii 1.0\ncomment x\n" + header_end + body);
    EXPECT_EQ(rows(ascii.simplices), two_triangles);
    EXPECT_TRUE(same(ascii, read_from("a.ply", small_binary("little"))));
    EXPECT_TRUE(same(ascii, read_from("a.ply", small_binary("big"))));
}

TEST(Ply, LinesMayEndInThreeWays) {
    const std::string text = "ply\nformat ascii 1.0\n" + header_end + body;
    const auto mesh = read_from("a.ply", text);
    for (const std::string line_break : {"\r\n", "\r"}) {
        EXPECT_TRUE(same(mesh, read_from("a.ply", with_line_breaks(text, line_break))));
        EXPECT_TRUE(same(mesh, read_from("a.ply", small_binary("little", line_break))));
    }
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
        Bytes bytes("ply\nformat binary_" + order +
                        "_endian 1.0\nobj_info x\nelement thing 1\nproperty list ushort double l\n"
                        "element empty 3\n"
                        "element vertex 3\nproperty list uchar short s\nproperty double x\n"
                        "property char c\nproperty int8 y\nproperty uint u\nproperty int16 z\n"
                        "element face 1\nproperty float q\nproperty list int uint16 vertex_index\n"
                        "property list char float64 t\nend_header\n",
                    order);
        bytes.add(std::uint16_t{2}).add(1.0).add(2.0);
        for (int i = 0; i < 3; ++i) {
            bytes.add(std::uint8_t{1}).add(std::int16_t{7}).add(0.25 * i).add('c');
            bytes.add(std::int8_t(-i * i)).add(std::uint32_t{9}).add(std::int16_t(-300 * i));
        }
        bytes.add(1.5F).add(std::int32_t{3}).add(std::uint16_t{2}).add(std::uint16_t{0});
        bytes.add(std::uint16_t{1}).add(std::int8_t{1}).add(0.5);
        const auto mesh = read_from("a.ply", bytes.text());
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

TEST(Ply, WarnsOfWhatFollows) {
    EXPECT_EQ(read_from("a.ply", small_binary("little") + "abc").warnings,
              (std::vector<std::string>{"3 bytes behind the last element left out"}));
}

TEST(Ply, RefusesBrokenHeaders) {
    const std::string start = "ply\nformat ascii 1.0\n";
    const std::string vertex = "element vertex 1\nproperty float x\nproperty float y\n";
    EXPECT_EQ(reading_error("a.ply", "plx\n"),
              "InvalidInput: a.ply:1: the file does not begin with the word ply; expected a PLY "
              "file; check the format");
    EXPECT_EQ(reading_error("a.ply", "ply\nformat ascii 1.0\nelement vertex 3\n"),
              "InvalidInput: a.ply:4: the file ends here; expected end_header; export it again, it "
              "seems cut off");
    EXPECT_EQ(reading_error("a.ply", "ply\nformat text 1.0\n"),
              "InvalidInput: a.ply:2: 'text' is not an encoding of PLY; expected ascii, "
              "binary_little_endian or binary_big_endian; correct the header");
    EXPECT_EQ(reading_error("a.ply", "ply\n" + header_end + body),
              "InvalidInput: a.ply:8: the header names no format; expected a line such as format "
              "ascii 1.0; correct the header");
    EXPECT_EQ(reading_error("a.ply", start + "property float x\n"),
              "InvalidInput: a.ply:3: a property stands before the first element; expected an "
              "element; correct the header");
    EXPECT_EQ(reading_error("a.ply", start + vertex + "property quad z\n"),
              "InvalidInput: a.ply:6: 'quad' is not a type of PLY; expected char, uchar, short, "
              "ushort, int, uint, float or double; correct the header");
    EXPECT_EQ(
        reading_error("a.ply", start + vertex + "property float\nend_header\n"),
        "InvalidInput: a.ply:6: the line ends here; expected the name of a property; complete "
        "the line");
    EXPECT_EQ(reading_error("a.ply", start + vertex + "property list float int q\n"),
              "InvalidInput: a.ply:6: the length of a list is a floating-point number; expected a "
              "whole number's type; correct the header");
    EXPECT_EQ(reading_error("a.ply", start + vertex + vertex + "end_header\n"),
              "InvalidInput: a.ply:6: the element 'vertex' is there a second time; expected one; "
              "correct the header");
    EXPECT_EQ(
        reading_error("a.ply", start + vertex + "nonsense\n"),
        "InvalidInput: a.ply:6: 'nonsense' is not a keyword of PLY; expected format, comment, "
        "element, property or end_header; correct the header");
    EXPECT_EQ(reading_error("a.ply", start + vertex + "end_header\n0 0\n"),
              "InvalidInput: a.ply:7: the element vertex has no number z; expected x, y and z; "
              "correct the header");
    EXPECT_EQ(reading_error("a.ply", start + "element face 1\nproperty int vertex_indices\n"
                                             "end_header\n3\n"),
              "InvalidInput: a.ply:6: the element face has no list vertex_indices; expected "
              "property list uchar int vertex_indices; correct the header");
    EXPECT_EQ(reading_error("a.ply", start + header_end),
              "InvalidInput: a.ply:9: 4 elements 'vertex' are promised in line 3, but 1 bytes "
              "follow; expected at least 6 bytes for each; correct the number, or export again if "
              "the file was cut off");
}

TEST(Ply, RefusesBrokenBodies) {
    const std::string start = "ply\nformat ascii 1.0\n" + header_end;
    const std::string vertices = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
    EXPECT_EQ(
        reading_error("a.ply", start + vertices + "3 0 1 2\n3 0 2 4\n"),
        "InvalidInput: a.ply:15: face 1 has the vertex number 4; expected 0 to 3; correct the "
        "index or add the vertex");
    EXPECT_EQ(reading_error("a.ply", start + vertices + "3 0 1 2\n3 0 2.5 3\n"),
              "InvalidInput: a.ply:15: face 1 has the vertex number 2.5; expected 0 to 3; correct "
              "the index or add the vertex");
    EXPECT_EQ(reading_error("a.ply", start + vertices + "3 0 1 2 9\n3 0 2 3\n"),
              "InvalidInput: a.ply:14: '9' follows on the same line; expected the end of an "
              "element; correct the line or export the file again");
    EXPECT_EQ(reading_error("a.ply", start + vertices + "-3 0 1 2\n3 0 2 3\n"),
              "InvalidInput: a.ply:14: a list of length -3, but 15 bytes follow; expected a whole "
              "number that fits; export it again");
    EXPECT_EQ(reading_error("a.ply", start + vertices + "3 0 1 2\n"),
              "InvalidInput: a.ply:15: the file ends here; expected a number; export it again, it "
              "seems cut off");
    EXPECT_EQ(reading_error("a.ply", start + "0 0 0\n1 0 nan\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n"),
              "InvalidInput: a.ply:11: vertex 1 (counted from 0) has a coordinate that is NaN, "
              "infinite or beyond the doubles; expected finite numbers; repair or remove the "
              "vertex");
}

TEST(Ply, RefusesBrokenBinaryBodies) {
    const auto text = small_binary("little");
    EXPECT_EQ(
        reading_error("a.ply", text.substr(0, text.size() - 1)),
        "InvalidInput: a.ply: before byte " + std::to_string(text.size() - 4) +
            ": the file ends here; expected more elements; export it again, it seems cut off");
    auto far_index = text;
    far_index[text.size() - 1] = '\x7F';
    EXPECT_EQ(
        reading_error("a.ply", far_index),
        "InvalidInput: a.ply: before byte " + std::to_string(text.size()) +
            ": face 1 has the vertex number 2130706435; expected 0 to 3; correct the index or "
            "add the vertex");
    auto infinite = text;
    const auto begin = binary_header("little").size();
    infinite.replace(begin, 4, std::string("\0\0\x80\x7F", 4));
    EXPECT_EQ(
        reading_error("a.ply", infinite),
        "InvalidInput: a.ply: before byte " + std::to_string(begin + 4) +
            ": vertex 0 (counted from 0) has a coordinate that is NaN, infinite or beyond the "
            "doubles; expected finite numbers; repair or remove the vertex");
    auto long_list = text;
    long_list[begin + 48] = '\xFF';
    EXPECT_EQ(reading_error("a.ply", long_list),
              "InvalidInput: a.ply: before byte " + std::to_string(begin + 49) +
                  ": a list of length 255, but 25 bytes follow; expected a whole number that fits; "
                  "export it again");
}

} // namespace polydec::tests
