// SPDX-License-Identifier: MIT
#pragma once

#include "base/progress.h"
#include "examples/plots/svg_plot.h"
#include "io/json_writer.h"
#include "io/pictures/svg_drawing.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace polydec::paper {

/// An entry of a table: a word, a count or a number. NaN is a missing number, shown as a dash.
using Entry = std::variant<std::string, long, double>;

struct Table {
    std::string name; ///< of its files, letters, digits and underscores
    std::string title;
    std::vector<std::string> columns;
    std::vector<std::vector<Entry>> rows;
};

struct NamedPlot {
    std::string name; ///< of its file
    SvgPlot plot;
};

struct NamedDrawing {
    std::string name; ///< of its file
    SvgDrawing drawing;
};

/// The result of reproducing a figure or table.
struct Report {
    std::string name; ///< table1, fig7 ..
    std::string title;
    std::vector<Table> tables = {};
    std::vector<NamedPlot> plots = {};
    std::vector<NamedDrawing> drawings = {};
    /// Differences from the paper, and other remarks; one sentence each.
    std::vector<std::string> remarks = {};
};

/// Options of a reproduction.
struct Request {
    int levels = 0;                    ///< refinements; 0: the figure's own default
    std::filesystem::path meshes = {}; ///< a folder of mesh files, for those that survey one
    Progress progress = {};            ///< called with each step; may be empty
};

/// Observed order: log2 of the ratio of the last two errors over log2 of the ratio of their sizes.
/// NaN if one of the two errors is zero or NaN. Throws InvalidInput unless there are as many sizes
/// as errors, at least two, and the last two sizes are positive and different.
double observed_order(const std::vector<double>& sizes, const std::vector<double>& errors);

/// The tables as text, with title and remarks, for a terminal. Throws InvalidInput, naming table
/// and row, for rows that do not fit the columns and for infinite numbers.
std::string to_text(const Report& report);

/// A report as one JSON object, without the shapes of its drawings: name, title, tables (name,
/// title, columns, rows), plots (name, title, x, y, series), drawings (name, title), remarks. NaN
/// is null. Throws like to_text.
std::string to_json(const Report& report);

/// The members of that object.
void write(JsonWriter& json, const Report& report);

/// Writes name.json, a .csv for each table and an .svg for each plot and drawing into a folder.
/// Creates the folder if necessary. File names that do not begin with the name of the report get it
/// as prefix. Returns the files written. Throws IoError; InvalidInput like to_text and to_svg, and
/// for names used twice or with characters other than letters, digits and _.
std::vector<std::filesystem::path> write_report(const std::filesystem::path& folder,
                                                const Report& report);

} // namespace polydec::paper
