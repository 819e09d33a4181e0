// SPDX-License-Identifier: MIT
#include "system/child_process.h"
#include "tests/io/support.h"
#include "tests/support/variable.h"

namespace polydec::test::in_write_drawing {

const SvgDrawing square{.shapes = {SvgPolygon{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}}};

void add_program(const TemporaryFolder& folder, const std::string& name, const std::string& text) {
    std::filesystem::permissions(folder.write(name, "#!/bin/sh\n" + text),
                                 std::filesystem::perms::owner_all);
}

TEST(WriteDrawing, GoesByTheExtension) {
    const TemporaryFolder folder;
    write_drawing(folder.path("square.SVG"), square);
    EXPECT_EQ(read_text(folder.path("square.SVG")), to_svg(square));
    EXPECT_REFUSED(write_drawing(folder.path("square.gif"), square), "square.gif", ".png");
}

TEST(WriteDrawing, NamesThePackagesOfMissingPrograms) {
    const TemporaryFolder folder;
    const Variable path("PATH", folder.path().string());
    EXPECT_NO_THROW(check_drawing_file("square.svg"));
    for (const char* name : {"square.png", "square.pdf"}) {
        const Words packages{"rsvg-convert", "librsvg2-bin", "cairosvg"};
        EXPECT_ERROR(BackendUnavailable, write_drawing(folder.path(name), square), packages);
        EXPECT_ERROR(BackendUnavailable, check_drawing_file(name), packages);
    }
    EXPECT_EQ(folder.names(), std::vector<std::string>());
}

TEST(WriteDrawing, NoNameReachesAShell) {
    const TemporaryFolder programs, folder;
    add_program(programs, "cairosvg", "printf '%s|' \"$@\" > drawing.png\n");
    const std::string odd = "a $(touch b) 'c' -o.png";
    {
        const Variable path("PATH", programs.path().string());
        write_drawing(folder.path(odd), square);
    }
    EXPECT_EQ(read_text(folder.path(odd)), "-fpng|-s2|-odrawing.png|drawing.svg|");
    EXPECT_EQ(folder.names(), std::vector{odd});
}

TEST(WriteDrawing, AFailureLeavesNothing) {
    const TemporaryFolder programs, folder;
    add_program(programs, "rsvg-convert", "echo no fonts; exit 1\n");
    const Variable path("PATH", programs.path().string());
    EXPECT_ERROR(SolverFailure, write_drawing(folder.path("square.pdf"), square), "rsvg-convert",
                 ".svg", "no fonts");
    EXPECT_EQ(folder.names(), std::vector<std::string>());
}

TEST(WriteDrawing, FilesHaveTheirFormats) {
    if (!find_program("rsvg-convert") && !find_program("cairosvg"))
        GTEST_SKIP() << "neither rsvg-convert nor cairosvg is there";
    const TemporaryFolder folder;
    write_drawing(folder.path("square.png"), square);
    const std::string png = read_text(folder.path("square.png"));
    EXPECT_EQ(png.substr(1, 3), "PNG");
    EXPECT_EQ(static_cast<unsigned char>(png[18]) * 256 + static_cast<unsigned char>(png[19]),
              1440);
    write_drawing(folder.path("square.pdf"), square);
    EXPECT_EQ(read_text(folder.path("square.pdf")).substr(0, 5), "%PDF-");
}

} // namespace polydec::test::in_write_drawing
