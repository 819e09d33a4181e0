// SPDX-License-Identifier: MIT
#include "io/pages/series.h"

#include "base/errors.h"
#include "base/printable.h"
#include "io/number_text.h"
#include "io/pictures/draw_cells.h"
#include "io/source_file.h"
#include "io/xml_text.h"
#include "system/atomic_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <exception>
#include <optional>
#include <system_error>
#include <utility>

namespace polydec {

namespace {

constexpr std::size_t most_unlisted = 32; ///< one of so many steps may be missing in the list

std::string name_of_step(const std::string& stem, std::size_t step) {
    return fmt::format("{}_{:04}.vtu", stem, step);
}

/// The number of a step in the name of its file; none for other files.
std::optional<std::size_t> step_of(const std::string& name, const std::string& stem) {
    if (name.size() <= stem.size() + 5)
        return std::nullopt;
    const auto digits = name.substr(stem.size() + 1, name.size() - stem.size() - 5);
    std::size_t step = 0;
    const auto end = digits.data() + digits.size();
    if (std::from_chars(digits.data(), end, step).ptr != end || name != name_of_step(stem, step))
        return std::nullopt;
    return step;
}

/// The folder of the steps.
void make_folder(const std::filesystem::path& series) {
    const auto folder = std::filesystem::path(series).replace_extension();
    std::error_code error;
    std::filesystem::create_directory(folder, error);
    if (!std::filesystem::is_directory(folder))
        throw IoError(fmt::format("cannot create {}, the folder for the steps of a series{}",
                                  printable(folder.string()),
                                  error ? ": " + error.message() : std::string()),
                      {.path = folder});
}

} // namespace

std::vector<std::filesystem::path> files_of_steps(const std::filesystem::path& series,
                                                  std::size_t first) {
    std::vector<std::filesystem::path> files;
    std::error_code none;
    for (const auto& entry : std::filesystem::directory_iterator(
             std::filesystem::path(series).replace_extension(), none)) {
        const auto step = step_of(entry.path().filename().string(), series.stem().string());
        if (step && *step >= first)
            files.push_back(entry.path());
    }
    return files;
}

Series::Series(std::filesystem::path path, const Discretization& mesh, PageText text,
               const std::vector<double>& times, std::uint64_t run)
    : path_(std::move(path)),
      mesh_(mesh),
      run_(run),
      exceptions_(std::uncaught_exceptions()),
      page_{.text = std::move(text)} {
    const std::string extension = lower_extension(path_);
    is_page_ = extension == ".html" || extension == ".png" || extension == ".svg";
    if (!is_page_ && extension != ".pvd")
        refuse_writing(path_, "a series needs the extension .pvd, .html for a page, or .png or "
                              ".svg for a picture of one step");
    if (!is_page_)
        check_lists_files(path_);
    check_replaceable(path_);
    if (is_page_ && !times.empty())
        throw InvalidInput(
            fmt::format("cannot continue {}: a page is written from all steps at once; write a "
                        ".pvd file, and convert it to a page at the end",
                        printable(path_.string())),
            {.path = path_});
    const bool replaces = std::filesystem::exists(path_); // else steps of this name are not ours
    keep_steps(times);
    if (is_page_)
        return;
    make_folder(path_);
    std::error_code error;
    if (replaces || begun_ > 0)
        for (const auto& file : files_of_steps(path_, begun_))
            std::filesystem::remove(file, error);
}

std::string Series::file_of_step(std::size_t step) const {
    const std::string stem = path_.stem().string();
    return stem + "/" + name_of_step(stem, step);
}

std::string mark_of(std::uint64_t run) {
    return fmt::format("<!-- run {:016x} -->", run);
}

void Series::check_run() const {
    const bool is_there = std::filesystem::is_regular_file(path_);
    if (is_there && read_source_file(path_).text.find(mark_of(run_)) != std::string::npos)
        return;
    throw InvalidInput(
        fmt::format(
            "{} {}: give the series of the resumed run, or start a new series under another name",
            printable(path_.string()), is_there ? "was written by another run" : "is not there"),
        {.path = path_});
}

/// The list, before anything is removed: never are steps listed that are not there.
void Series::keep_steps(const std::vector<double>& times) {
    if (run_ != 0 && !times.empty())
        check_run();
    for (const double time : times) {
        check_time(time);
        const std::string file = file_of_step(steps_.size());
        const auto path = path_.parent_path() / file;
        if (!std::filesystem::is_regular_file(path))
            throw InvalidInput(
                fmt::format("{}, a step of the resumed series, does not exist: start a new series",
                            printable(path.string())),
                {.path = path});
        std::string text;
        append_number(text, time);
        steps_.push_back({text, file});
        last_ = time;
    }
    begun_ = steps_.size();
    std::error_code error;
    if (begun_ > 0)
        write_due(true);
    else if (run_ != 0 && !is_page_)
        write_list();
    else if (!is_page_)
        std::filesystem::remove(path_, error);
}

Series::~Series() {
    try {
        if (!is_page_ || std::uncaught_exceptions() == exceptions_)
            close();
    } catch (const std::exception&) { // who wants to know of it closes it before
    }
}

void Series::check_time(double time) const {
    if (is_closed_)
        throw InvalidInput("the series is closed: add no more steps");
    if (!std::isfinite(time) || (!steps_.empty() && time <= last_))
        throw InvalidInput(fmt::format(
            "step {} of a series has the time {}: expected a time after the previous step",
            steps_.size(), time));
}

void Series::check_arrays(const VtuData& data) const {
    for (const auto list : vtu_lists) {
        const auto &arrays = data.*list, &first = page_.grid.*list;
        if (!std::equal(arrays.begin(), arrays.end(), first.begin(), first.end(),
                        [](const VtuArray& a, const VtuArray& b) {
                            return a.is_like(b) && a.size() == b.size();
                        }))
            throw InvalidInput(fmt::format("step {} of a series has other arrays than the previous "
                                           "steps: expected the same names, kinds and sizes",
                                           steps_.size()));
    }
}

/// The page before its first step.
Page Series::begun(const std::vector<NamedForm>& fields) const {
    Page page;
    page.mesh = mesh_;
    if (is_page_) {
        page = draw_page(mesh_, fields);
        for (PageArrows& arrows : page.arrows)
            arrows.lines = {}; // they would stand still
    } else {
        page.grid = draw_cells(mesh_, drawn_degree(mesh_, fields));
    }
    static_cast<VtuData&>(page.grid) = {};
    const PageText own = std::exchange(page.text, page_.text);
    page.text.facts.insert(page.text.facts.end(), own.facts.begin(), own.facts.end());
    page.text.warnings.insert(page.text.warnings.end(), own.warnings.begin(), own.warnings.end());
    return page;
}

PageStep Series::drawn(const Page& page, const std::vector<NamedForm>& fields) const {
    if (is_page_)
        return draw_step(page, {}, fields);
    PageStep step;
    add_fields(step, mesh_, fields);
    return step;
}

void Series::add(double time, const std::vector<NamedForm>& fields) {
    check_time(time);
    if (fields.empty())
        throw InvalidInput(
            fmt::format("step {} of a series has no fields: expected at least one", steps_.size()));
    if (page_.mesh)
        return add_step(time, drawn(page_, fields));
    Page page = begun(fields);
    PageStep step = drawn(page, fields);
    std::swap(page_, page);
    try {
        add_step(time, std::move(step));
    } catch (...) {
        std::swap(page_, page);
        throw;
    }
}

void Series::add_step(double time, PageStep step) {
    if (steps_.size() > begun_)
        check_arrays(step);
    VtuData& shown = page_.grid;
    VtuData before = std::exchange(shown, step);
    append_number(step.time, time);
    try {
        write_step(std::move(step));
    } catch (...) {
        shown = std::move(before);
        throw;
    }
    last_ = time;
    write_due(false);
}

void Series::write_step(PageStep step) {
    Step written{step.time, {}};
    if (is_page_) {
        check_grid("a page", page_.grid);
        page_.steps.push_back(std::move(step));
    } else {
        written.file = file_of_step(steps_.size());
        write_vtu(path_.parent_path() / written.file, page_.grid);
    }
    steps_.push_back(std::move(written));
}

void Series::write_list() {
    AtomicFile list(path_);
    list.write("<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" "
               "byte_order=\"LittleEndian\">\n");
    if (run_ != 0)
        list.write(mark_of(run_) + "\n");
    list.write("<Collection>\n");
    for (const auto& [time, file] : steps_)
        list.write(fmt::format("<DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", time,
                               xml_escaped(file)));
    list.write("</Collection>\n</VTKFile>\n");
    list.commit();
}

/// A list is written in times that are together proportional to those of all steps, a page when all
/// are there: until then an old one stays.
void Series::write_due(bool at_end) {
    const std::size_t missing = steps_.size() - written_;
    const bool is_due = !is_page_ && most_unlisted * missing >= steps_.size();
    if (missing == 0 || (!at_end && !is_due))
        return;
    if (is_page_)
        write_page(path_, page_);
    else
        write_list();
    written_ = steps_.size();
}

void Series::close() {
    if (!std::exchange(is_closed_, true))
        write_due(true);
}

} // namespace polydec
