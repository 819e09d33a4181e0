// SPDX-License-Identifier: MIT
#include "examples/paper/report.h"

#include "base/errors.h"
#include "system/atomic_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

namespace polydec::paper {

namespace {

constexpr std::size_t line_width = 100;

/// Number of characters, not bytes.
std::size_t width(std::string_view text) {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
        return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
    }));
}

/// A table whose rows fit its columns and whose numbers are finite or NaN.
void check(const Table& table) {
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        if (table.rows[i].size() != table.columns.size())
            throw InvalidInput(fmt::format("table '{}': row {} has {} entries, expected {}",
                                           table.name, i, table.rows[i].size(),
                                           table.columns.size()));
        for (std::size_t j = 0; j < table.columns.size(); ++j) {
            const auto* number = std::get_if<double>(&table.rows[i][j]);
            if (number != nullptr && std::isinf(*number))
                throw InvalidInput(fmt::format("table '{}': '{}' of row {} is infinite; correct it",
                                               table.name, table.columns[j], i));
        }
    }
}

std::string short_text(const Entry& entry) {
    if (const auto* word = std::get_if<std::string>(&entry))
        return *word;
    if (const auto* count = std::get_if<long>(&entry))
        return fmt::format("{}", *count);
    const double number = std::get<double>(entry);
    return std::isnan(number) ? "-" : fmt::format("{:.4g}", number);
}

std::string padded(const std::string& text, std::size_t to, bool left) {
    const std::string space(to - width(text), ' ');
    return left ? text + space : space + text;
}

std::string without_trailing_space(std::string line) {
    line.erase(line.find_last_not_of(' ') + 1);
    return line;
}

/// Columns of words are left-aligned, columns of numbers right-aligned.
std::string to_text(const Table& table) {
    check(table);
    std::vector<std::size_t> widths;
    std::vector<bool> words;
    for (std::size_t j = 0; j < table.columns.size(); ++j) {
        widths.push_back(width(table.columns[j]));
        words.push_back(!table.rows.empty());
        for (const auto& row : table.rows) {
            widths[j] = std::max(widths[j], width(short_text(row[j])));
            words[j] = words[j] && std::holds_alternative<std::string>(row[j]);
        }
    }
    const auto line = [&](const auto& text_of) {
        std::string text = " ";
        for (std::size_t j = 0; j < table.columns.size(); ++j)
            text += " " + padded(text_of(j), widths[j], words[j]) + " ";
        return without_trailing_space(text) + "\n";
    };
    std::string text = table.title + "\n" + line([&](std::size_t j) { return table.columns[j]; });
    text += line([&](std::size_t j) { return std::string(widths[j], '-'); });
    for (const auto& row : table.rows)
        text += line([&](std::size_t j) { return short_text(row[j]); });
    return text;
}

/// Lines of at most line_width characters, broken at blanks; the first begins with a star.
std::string wrapped(std::string_view remark) {
    std::string text, line = "  *";
    for (std::size_t begin = 0; begin < remark.size();) {
        const auto end = std::min(remark.find(' ', begin), remark.size());
        const auto word = remark.substr(begin, end - begin);
        if (width(line) + 1 + width(word) > line_width && width(line) > 3) {
            text += line + "\n";
            line = "   ";
        }
        (line += ' ') += word;
        begin = end + 1;
    }
    return text + line + "\n";
}

/// NaN is a missing number.
std::optional<double> known(double number) {
    return std::isnan(number) ? std::nullopt : std::optional(number);
}

void write(JsonWriter& json, const Entry& entry) {
    if (const auto* number = std::get_if<double>(&entry))
        json.value(known(*number));
    else if (const auto* count = std::get_if<long>(&entry))
        json.value(*count);
    else
        json.value(std::get<std::string>(entry));
}

void write(JsonWriter& json, const Table& table) {
    check(table);
    json.member("name", table.name);
    json.member("title", table.title);
    json.member("columns", table.columns);
    json.array("rows", [&] {
        for (const auto& row : table.rows)
            json.array([&] {
                for (const auto& entry : row)
                    write(json, entry);
            });
    });
}

void write_numbers(JsonWriter& json, std::string_view name, const std::vector<double>& values) {
    json.array(name, [&] {
        for (const double value : values)
            json.value(known(value));
    });
}

void write(JsonWriter& json, const NamedPlot& named) {
    const auto& plot = named.plot;
    json.member("name", named.name);
    json.member("title", plot.title);
    json.member("x", plot.x.label);
    json.member("y", plot.y.label);
    json.objects("series", plot.series, [&](const auto& each) {
        json.member("name", each.name);
        write_numbers(json, "x", each.x);
        write_numbers(json, "y", each.y);
    });
}

void write(JsonWriter& json, const NamedDrawing& drawing) {
    json.member("name", drawing.name);
    json.member("title", drawing.drawing.title);
}

std::string csv_of(std::string text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos)
        return text;
    for (std::size_t at = 0; (at = text.find('"', at)) != std::string::npos; at += 2)
        text.insert(at, 1, '"');
    return '"' + text + '"';
}

std::string csv_of(const Entry& entry) {
    const auto* number = std::get_if<double>(&entry);
    if (number == nullptr)
        return csv_of(short_text(entry));
    return std::isnan(*number) ? "" : fmt::format("{:.17g}", *number);
}

std::string csv_of(const Table& table) {
    check(table);
    const auto line = [&](const auto& values) {
        std::string text;
        for (std::size_t j = 0; j < values.size(); ++j)
            text += (j == 0 ? "" : ",") + csv_of(values[j]);
        return text + "\r\n";
    };
    std::string text = line(table.columns);
    for (const auto& row : table.rows)
        text += line(row);
    return text;
}

/// File names and their contents.
using Files = std::vector<std::pair<std::string, std::string>>;

/// All names in a folder begin with the name of the report.
std::string file_name(const Report& report, const std::string& name, const char* extension) {
    const bool begins = name == report.name || name.rfind(report.name + "_", 0) == 0;
    const std::string stem = begins ? name : report.name + "_" + name;
    const auto plain = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               c == '_';
    };
    if (name.empty() || !std::all_of(stem.begin(), stem.end(), plain))
        throw InvalidInput(fmt::format("'{}' is no name for a file of {}: letters, digits and _",
                                       name, report.name));
    return stem + extension;
}

Files files_of(const Report& report) {
    Files files{{file_name(report, report.name, ".json"), to_json(report) + "\n"}};
    for (const auto& table : report.tables)
        files.emplace_back(file_name(report, table.name, ".csv"), csv_of(table));
    for (const auto& [name, plot] : report.plots)
        files.emplace_back(file_name(report, name, ".svg"), to_svg(plot));
    for (const auto& [name, drawing] : report.drawings)
        files.emplace_back(file_name(report, name, ".svg"), to_svg(drawing));
    std::set<std::string> names;
    for (const auto& [name, text] : files)
        if (!names.insert(name).second)
            throw InvalidInput(fmt::format("{} is the name of two files: choose another", name));
    return files;
}

} // namespace

double observed_order(const std::vector<double>& sizes, const std::vector<double>& errors) {
    const std::size_t n = sizes.size();
    if (n != errors.size() || n < 2)
        throw InvalidInput(fmt::format("an order of convergence of {} sizes and {} errors: "
                                       "expected as many, at least two",
                                       n, errors.size()));
    const double size_ratio = sizes[n - 2] / sizes[n - 1];
    if (!(sizes[n - 2] > 0 && sizes[n - 1] > 0) || size_ratio == 1)
        throw InvalidInput(fmt::format("an order of convergence of sizes {} and {}: expected "
                                       "different positive numbers",
                                       sizes[n - 2], sizes[n - 1]));
    if (!(errors[n - 2] > 0 && errors[n - 1] > 0))
        return std::numeric_limits<double>::quiet_NaN();
    return std::log2(errors[n - 2] / errors[n - 1]) / std::log2(size_ratio);
}

std::string to_text(const Report& report) {
    std::string text = fmt::format("{}: {}\n", report.name, report.title);
    for (const auto& table : report.tables)
        text += "\n" + to_text(table);
    if (!report.remarks.empty())
        text += "\nRemarks\n";
    for (const auto& remark : report.remarks)
        text += wrapped(remark);
    return text;
}

void write(JsonWriter& json, const Report& report) {
    json.member("name", report.name);
    json.member("title", report.title);
    const auto write_part = [&](const auto& part) { write(json, part); };
    json.objects("tables", report.tables, write_part);
    json.objects("plots", report.plots, write_part);
    json.objects("drawings", report.drawings, write_part);
    json.member("remarks", report.remarks);
}

std::string to_json(const Report& report) {
    JsonWriter json;
    json.object([&] { write(json, report); });
    return std::string(json.view());
}

std::vector<std::filesystem::path> write_report(const std::filesystem::path& folder,
                                                const Report& report) {
    // makes all texts before the first file, so an error leaves no partial output
    const Files files = files_of(report);
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error)
        throw IoError(
            fmt::format("cannot make the folder {}: {}", folder.string(), error.message()));
    std::vector<std::filesystem::path> written;
    for (const auto& [name, text] : files) {
        AtomicFile file(folder / name);
        file.write(text);
        file.commit();
        written.push_back(folder / name);
    }
    return written;
}

} // namespace polydec::paper
