// SPDX-License-Identifier: MIT
#include "io/pages/series.h"

#include "base/atomic_file.h"
#include "base/errors.h"
#include "base/printable.h"
#include "io/number_text.h"
#include "io/pictures/draw_cells.h"
#include "io/source_file.h"
#include "io/xml_text.h"

#include <fmt/format.h>

#include <cmath>
#include <exception>
#include <system_error>
#include <utility>

namespace polydec {

namespace {

constexpr std::size_t most_unlisted = 32; ///< one of so many steps may be missing in the list

/// The folder of the steps, without those of an earlier series.
void make_folder(const std::filesystem::path& folder, const std::string& stem) {
    std::error_code error;
    std::filesystem::create_directory(folder, error);
    if (!std::filesystem::is_directory(folder))
        throw IoError(fmt::format("{} cannot be made, the folder for the steps of a series{}",
                                  printable(folder.string()),
                                  error ? ": " + error.message() : std::string()),
                      {.path = folder});
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        const auto digits = name.size() > stem.size() + 5
                                ? name.substr(stem.size() + 1, name.size() - stem.size() - 5)
                                : std::string();
        if (!digits.empty() && digits.find_first_not_of("0123456789") == std::string::npos &&
            name == fmt::format("{}_{}.vtu", stem, digits))
            std::filesystem::remove(entry.path(), error);
    }
}

} // namespace

Series::Series(std::filesystem::path path, const Discretization& mesh, std::string title)
    : Series(std::move(path), Page{.text = {.title = std::move(title)}}) {
    mesh_ = mesh;
}

Series::Series(std::filesystem::path path, Page page)
    : path_(std::move(path)), page_(std::move(page)) {
    const std::string extension = lower_extension(path_);
    if (extension != ".pvd" && extension != ".html")
        throw InvalidInput(fmt::format("cannot write {}: a series is a .pvd file, or a page, .html",
                                       printable(path_.string())),
                           {.path = path_});
    is_page_ = extension == ".html";
    check_replaceable(path_);
    page_.steps.clear();
    page_.arrows.clear();
    if (!is_page_) {
        std::error_code error;
        std::filesystem::remove(path_, error); // first: never are steps listed that are not there
        make_folder(std::filesystem::path(path_).replace_extension(), path_.stem().string());
    }
}

Series::~Series() {
    try {
        close();
    } catch (const std::exception&) { // who wants to know of it closes it before
    }
}

void Series::check_time(double time) const {
    if (is_closed_)
        throw InvalidInput("a step after the end of a series: it is closed");
    if (!std::isfinite(time) || (!steps_.empty() && time <= last_))
        throw InvalidInput(fmt::format("step {} of a series at the time {}: expected a time above "
                                       "that of the step before",
                                       steps_.size(), time));
}

void Series::check_arrays(const std::vector<VtuArray>& arrays,
                          const std::vector<VtuArray>& first) const {
    bool fits = arrays.size() == first.size();
    for (std::size_t i = 0; fits && i < arrays.size(); ++i)
        fits = arrays[i].name == first[i].name && arrays[i].components == first[i].components &&
               arrays[i].values.index() == first[i].values.index() &&
               arrays[i].size() == first[i].size();
    if (!fits)
        throw InvalidInput(
            fmt::format("step {} of a series has not the arrays of the steps before: "
                        "expected the same names, kinds and sizes",
                        steps_.size()));
}

void Series::add(double time, const std::vector<NamedForm>& forms) {
    check_time(time);
    if (!page_.mesh && !mesh_)
        throw InvalidInput("forms in a series that was begun without a mesh: add arrays");
    if (mesh_) {
        Page page = draw_page(*mesh_, forms, page_.text.title);
        page.arrows.clear();
        auto points = std::exchange(page.grid.point_data, {});
        auto cells = std::exchange(page.grid.cell_data, {});
        std::swap(page_, page);
        try {
            add(time, std::move(points), std::move(cells));
        } catch (...) {
            std::swap(page_, page);
            throw;
        }
        mesh_.reset();
        return;
    }
    VtuGrid arrays;
    for (const auto& [name, form, about] : forms)
        add_form(arrays, *page_.mesh, name, form, about);
    add(time, std::move(arrays.point_data), std::move(arrays.cell_data));
}

void Series::add(double time, std::vector<VtuArray> point_data, std::vector<VtuArray> cell_data) {
    check_time(time);
    if (!steps_.empty()) {
        check_arrays(point_data, page_.grid.point_data);
        check_arrays(cell_data, page_.grid.cell_data);
    }
    auto points_before = std::exchange(page_.grid.point_data, std::move(point_data));
    auto cells_before = std::exchange(page_.grid.cell_data, std::move(cell_data));
    std::string text;
    append_number(text, time);
    try {
        write_step(text);
    } catch (...) {
        page_.grid.point_data = std::move(points_before);
        page_.grid.cell_data = std::move(cells_before);
        throw;
    }
    last_ = time;
    write_due(false);
}

void Series::write_step(const std::string& time) {
    std::string file;
    if (is_page_) {
        check_grid("a page", page_.grid);
        page_.steps.push_back({time, page_.grid.point_data, page_.grid.cell_data});
    } else {
        const std::string stem = path_.stem().string();
        file = fmt::format("{0}/{0}_{1:04}.vtu", stem, steps_.size());
        write_vtu(path_.parent_path() / file, page_.grid);
    }
    steps_.push_back({time, std::move(file)});
}

void Series::write_list() {
    AtomicFile list(path_);
    list.write("<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" "
               "byte_order=\"LittleEndian\">\n<Collection>\n");
    for (const auto& [time, file] : steps_)
        list.write(fmt::format("<DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", time,
                               xml_escaped(file)));
    list.write("</Collection>\n</VTKFile>\n");
    list.commit();
}

/// In times that are together proportional to those of all steps.
void Series::write_due(bool at_end) {
    const std::size_t missing = steps_.size() - written_;
    const bool is_due = is_page_ ? missing >= written_ : most_unlisted * missing >= steps_.size();
    if (missing == 0 || (!at_end && !is_due))
        return;
    if (is_page_)
        write_page(path_, page_);
    else
        write_list();
    written_ = steps_.size();
}

void Series::close() {
    if (std::exchange(is_closed_, true))
        return;
    write_due(true);
}

} // namespace polydec
