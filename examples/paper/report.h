// SPDX-License-Identifier: MIT
#pragma once

#include "examples/plots/svg_plot.h"
#include "io/json_writer.h"
#include "io/pictures/svg_drawing.h"

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace polydec::paper {

/// An entry of a table: a word, a count or a number. NaN is a number that there is not, shown as a
/// dash.
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

/// What the reproduction of a figure or table gives.
struct Report {
    std::string name; ///< table1, fig7 ..
    std::string title;
    std::vector<Table> tables = {};
    std::vector<NamedPlot> plots = {};
    std::vector<NamedDrawing> drawings = {};
    /// What comes out otherwise than the paper says, and other things to know; a sentence each.
    std::vector<std::string> remarks = {};
};

/// What is asked of a reproduction.
struct Request {
    int levels = 0;                    ///< refinements; 0: the figure's own default
    std::filesystem::path meshes = {}; ///< a folder of mesh files, for those that survey one
    std::function<void(std::string_view)> progress = {}; ///< told what is being done; may be empty
};

/// log2 of the ratio of the last two errors over that of their sizes: the observed order. NaN,
/// there is none, if one of the two errors is zero or NaN. Throws InvalidInput unless there are as
/// many sizes as errors, at least two, and the last two sizes are positive and different.
double observed_order(const std::vector<double>& sizes, const std::vector<double>& errors);

/// The tables as text, with title and remarks, for a terminal. Throws InvalidInput, naming table
/// and row, for rows that do not fit the columns and numbers that are infinite.
std::string to_text(const Report& report);

/// All of a report but the shapes of its drawings as one JSON object: name, title, tables (name,
/// title, columns, rows), plots (name, title, x, y, series), drawings (name, title), remarks. NaN
/// is null. Throws like to_text.
std::string to_json(const Report& report);

/// The members of that object.
void write(JsonWriter& json, const Report& report);

/// Writes name.json, and a .csv for each table and an .svg for each plot and drawing, into a
/// folder, which is made if it is not there. The name of the report stands before the names of the
/// others where they do not begin with it. Returns the files written. Throws IoError; InvalidInput
/// like to_text and to_svg, and for names that are used twice or are not letters, digits and _.
std::vector<std::filesystem::path> write_report(const std::filesystem::path& folder,
                                                const Report& report);

} // namespace polydec::paper
