// SPDX-License-Identifier: MIT
#include "examples/paper/report.h"

#include "examples/paper/process.h"
#include "examples/paper/program.h"
#include "examples/paper/reproductions.h"
#include "tests/io/support.h"

namespace polydec::paper::in_report {

using nlohmann::json;
using test::error_of;
using test::read_text;
using test::says;
using test::TemporaryFolder;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

Report example() {
    Report report{.name = "fig0", .title = "An example"};
    report.tables.push_back({"errors",
                             "errors by mesh",
                             {"mesh", "cells", "error, relative"},
                             {{"quads", 10L, 1.0 / 3}, {"\"hexagons\", split", 1234567L, none}}});
    report.plots.push_back({"errors", SvgPlot{"Errors", {"h"}, {"error"}}});
    report.plots[0].plot.series.push_back({"quads", {0.1, 0.05}, {1e-2, none}});
    report.drawings.push_back({"fig0_mesh", SvgDrawing{.shapes = {SvgCircle{{0, 0}, 1}}}});
    report.remarks = {"A remark."};
    return report;
}

std::string refused(const Report& report) {
    const TemporaryFolder folder;
    const auto message = error_of([&] { write_report(folder.path("out"), report); });
    EXPECT_TRUE(message.empty() || folder.names().empty()) << "nothing is begun";
    return message;
}

TEST(Orders, of_powers_are_their_exponents) {
    for (const double order : {0.5, 1.0, 2.0, 4.0}) {
        std::vector<double> sizes{0.5, 0.2, 0.07}, errors;
        for (const double h : sizes)
            errors.push_back(3 * std::pow(h, order));
        EXPECT_NEAR(observed_order(sizes, errors), order, 1e-12);
        errors[1] *= 2;
        EXPECT_GT(observed_order(sizes, errors), order + 0.5) << "the last two count";
        errors[0] = none;
        EXPECT_GT(observed_order(sizes, errors), order) << "and these alone";
    }
}

TEST(Orders, are_none_without_two_errors_and_refused_without_two_sizes) {
    EXPECT_TRUE(std::isnan(observed_order({0.2, 0.1}, {1e-3, 0})));
    EXPECT_TRUE(std::isnan(observed_order({0.2, 0.1}, {none, 1e-3})));
    EXPECT_REFUSED(observed_order({0.1}, {1e-3}), "order", "1 sizes", "1 errors", "two");
    EXPECT_REFUSED(observed_order({0.1, 0.1}, {2, 1}), "order", "sizes", "0.1", "0.1");
}

TEST(Reports, as_text_have_aligned_columns_and_four_digits) {
    EXPECT_EQ(to_text(example()), "fig0: An example\n"
                                  "\n"
                                  "errors by mesh\n"
                                  "  mesh                 cells  error, relative\n"
                                  "  -----------------  -------  ---------------\n"
                                  "  quads                   10           0.3333\n"
                                  "  \"hexagons\", split  1234567                -\n"
                                  "\n"
                                  "Remarks\n"
                                  "  * A remark.\n");
}

TEST(Reports, as_text_are_aligned_by_characters_not_bytes) {
    Report report{.name = "a", .title = "b"};
    report.tables.push_back({"t",
                             "c",
                             {"M\xC3\xB6"
                              "bius",
                              "n"},
                             {{"abcdef", 1L}, {"\xC3\xA9", 2L}}});
    EXPECT_NE(to_text(report).find("  M\xC3\xB6"
                                   "bius  n\n  ------  -\n  abcdef  1\n  \xC3\xA9       2\n"),
              std::string::npos)
        << to_text(report);
}

TEST(Reports, wrap_remarks_at_a_hundred_characters) {
    Report report{.name = "a", .title = "b"};
    std::string remark = "word";
    for (int i = 0; i < 60; ++i)
        remark += " word";
    report.remarks = {remark, std::string(150, 'x')};
    std::istringstream lines(to_text(report));
    std::size_t longest = 0, words = 0;
    for (std::string line; std::getline(lines, line);) {
        if (line.find('x') == std::string::npos)
            longest = std::max(longest, line.size());
        for (std::size_t at = 0; (at = line.find("word", at)) != std::string::npos; ++at)
            ++words;
    }
    EXPECT_GT(longest, 90U);
    EXPECT_LE(longest, 100U);
    EXPECT_EQ(words, 61U) << "none is lost";
    EXPECT_NE(to_text(report).find("\n  * " + std::string(150, 'x') + "\n"), std::string::npos)
        << "a word that is too long stays whole";
}

TEST(Reports, as_json_have_all_digits_and_null_for_nan) {
    const auto object = json::parse(to_json(example()));
    EXPECT_EQ(object["name"], "fig0");
    const auto& table = object["tables"][0];
    EXPECT_EQ(table["columns"][2], "error, relative");
    EXPECT_EQ(table["rows"][0], (json{"quads", 10, 1.0 / 3})) << "to the last digit";
    EXPECT_TRUE(table["rows"][1][2].is_null());
    EXPECT_EQ(table["rows"][1][0], "\"hexagons\", split");
    EXPECT_EQ(object["plots"][0]["series"][0]["x"], (json{0.1, 0.05}));
    EXPECT_TRUE(object["plots"][0]["series"][0]["y"][1].is_null());
    EXPECT_EQ(object["drawings"][0]["name"], "fig0_mesh");
    EXPECT_EQ(object["remarks"], json{"A remark."});
}

TEST(Reports, are_written_as_one_file_each) {
    const TemporaryFolder folder;
    const auto out = folder.path("made") / "here";
    const auto files = write_report(out, example());
    std::vector<std::string> names;
    for (const auto& file : files) {
        EXPECT_EQ(file.parent_path(), out);
        names.push_back(file.filename().string());
    }
    EXPECT_EQ(names, (std::vector<std::string>{"fig0.json", "fig0_errors.csv", "fig0_errors.svg",
                                               "fig0_mesh.svg"}));
    std::size_t there = 0;
    for (const auto& entry : std::filesystem::directory_iterator(out))
        there += entry.is_regular_file() ? 1 : 0;
    EXPECT_EQ(there, names.size()) << "and nothing else is left";

    EXPECT_EQ(read_text(files[0]), to_json(example()) + "\n");
    EXPECT_EQ(read_text(files[1]), "mesh,cells,\"error, relative\"\r\n"
                                   "quads,10,0.33333333333333331\r\n"
                                   "\"\"\"hexagons\"\", split\",1234567,\r\n");
    EXPECT_EQ(read_text(files[2]), to_svg(example().plots[0].plot));
    EXPECT_EQ(read_text(files[3]), to_svg(example().drawings[0].drawing));
}

TEST(Reports, with_flaws_are_refused_before_anything_is_written) {
    EXPECT_EQ(refused(example()), "");
    auto report = example();
    report.tables[0].rows[1][2] = HUGE_VAL;
    EXPECT_SAYS(refused(report), "InvalidInput", "table 'errors'", "error, relative", "row 1",
                "infinite");
    EXPECT_EQ(error_of([&] { to_text(report); }), refused(report));
    report.tables[0].rows[1].pop_back();
    EXPECT_SAYS(refused(report), "InvalidInput", "table 'errors'", "row 1", "2 entries", "3");
    report = example();
    report.plots[0].name = "mesh";
    EXPECT_SAYS(refused(report), "InvalidInput", "fig0_mesh.svg", "two files");
    report.plots[0].name = "../mesh";
    EXPECT_SAYS(refused(report), "InvalidInput", "../mesh", "file", "fig0");
    report = example();
    report.plots[0].plot.series[0].y = {-1, 2};
    EXPECT_SAYS(refused(report), "series 'quads'", "y[0]", "-1");
}

TEST(Reports, that_cannot_be_written_say_why) {
    const TemporaryFolder folder;
    const auto file = folder.write("taken", "");
    EXPECT_ERROR(IoError, write_report(file, example()), file.string(), "Not a directory");
}

TEST(Reproductions, have_different_names_that_files_can_have) {
    std::vector<std::string> names;
    for (const auto& each : reproductions()) {
        names.push_back(each.name);
        EXPECT_EQ(each.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789"),
                  std::string::npos);
        EXPECT_FALSE(each.summary.empty());
        EXPECT_LE(each.summary.size(), 85U);
    }
    std::sort(names.begin(), names.end());
    EXPECT_EQ(std::unique(names.begin(), names.end()), names.end());
}

TEST(Figure2, shows_each_kind_of_pair_with_the_sign_of_its_dual_edge) {
    const auto report = fig2({});
    const std::vector<std::pair<std::string, int>> expected{
        {"well-centered", 1}, {"Delaunay", 1},  {"non-Delaunay", -1},
        {"non-Delaunay", -1}, {"concyclic", 0}, {"concyclic", 0}};
    const auto& rows = report.tables[0].rows;
    ASSERT_EQ(rows.size(), expected.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        EXPECT_EQ(std::get<std::string>(rows[i][1]),
                  i % 2 == 0 ? "crosses the edge" : "on one side");
        EXPECT_EQ(std::get<std::string>(rows[i][2]), expected[i].first);
        const double dual = std::get<double>(rows[i][3]), star = std::get<double>(rows[i][4]);
        EXPECT_EQ((dual > 0) - (dual < 0), expected[i].second);
        EXPECT_NEAR(star, dual / 2, 1e-14) << "an edge of length 2";
        EXPECT_EQ(std::get<std::string>(rows[i][5]), dual == 0 ? "yes" : "no");
    }
}

TEST(Figures, have_legends_for_all_colors) {
    for (const auto& figure : {fig2({}), fig6({})}) {
        std::set<std::string> colors, explained{"none", "#000000", "#ffffff"};
        const auto& shapes = figure.drawings.at(0).drawing.shapes;
        for (std::size_t i = 0; i < shapes.size(); ++i)
            std::visit(
                [&](const auto& shape) {
                    if constexpr (requires { shape.style; }) {
                        const auto* words =
                            i + 1 < shapes.size() ? std::get_if<SvgText>(&shapes[i + 1]) : nullptr;
                        const bool is_sample = words && words->anchor == SvgAnchor::start;
                        for (const auto& color : {shape.style.stroke, shape.style.fill})
                            (is_sample ? explained : colors).insert(color);
                    }
                },
                shapes[i]);
        EXPECT_TRUE(std::includes(explained.begin(), explained.end(), colors.begin(), colors.end()))
            << figure.name;
    }
}

TEST(Table2, counts_pairs_of_files_and_tells_why_others_are_left_out) {
    const TemporaryFolder folder;
    folder.write("square.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n");
    folder.write("kite.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1.2 0\n0 1 0\n3 0 1 2\n3 0 2 3\n");
    folder.write("broken.off", "OFF\n4 2 0\n0 0 0\n");
    folder.write("notes.txt", "no mesh");
    std::vector<std::string> told;
    const auto report = table2({.meshes = folder.path(), .progress = [&](std::string_view text) {
                                    told.emplace_back(text);
                                }});
    const auto& rows = report.tables[0].rows;
    ASSERT_EQ(rows.size(), 4U) << "three files and all together";
    EXPECT_EQ(told.size(), 3U);
    EXPECT_EQ(std::get<std::string>(rows[0][0]), "broken.off");
    EXPECT_TRUE(std::isnan(std::get<double>(rows[0][1])));
    EXPECT_EQ(std::get<std::string>(rows[0][8]).find(folder.path().string()), std::string::npos);
    EXPECT_FALSE(std::get<std::string>(rows[0][8]).empty());
    EXPECT_EQ(rows[1], (std::vector<Entry>{"kite.off", 2L, 0L, 0L, 0.0, 0L, 0L, 0.0, ""}));
    EXPECT_EQ(rows[2], (std::vector<Entry>{"square.off", 2L, 1L, 2L, 100.0, 1L, 2L, 100.0, ""}));
    EXPECT_EQ(rows[3], (std::vector<Entry>{"all", 4L, 1L, 2L, 50.0, 1L, 2L, 50.0, ""}));
    EXPECT_ERROR(IoError, table2({.meshes = folder.path("none")}), folder.path("none").string(),
                 "No such file");
}

TEST(Program, refuses_a_reproduction_that_there_is_not) {
    EXPECT_EXIT(std::_Exit(run_program("fig99", 0, nullptr)), testing::ExitedWithCode(bad_input),
                "fig99: .*no reproduction");
}

} // namespace polydec::paper::in_report
