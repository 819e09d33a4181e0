// SPDX-License-Identifier: MIT
#pragma once

#include "io/pages/draw_page.h"
#include "io/pages/page.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace polydec {

/// Pictures of one mesh at ascending times, as a file by its extension: .pvd, a list of .vtu files
/// in a folder beside it that has its name, as ParaView reads them; or .html, a page in which the
/// time can be chosen and played. Every file appears whole or not at all. The files of a .pvd are
/// written while steps are added: what a killed program leaves can be read, and lacks at most the
/// last 1 of 32 steps, whose files are there. A page is written at the end, in place of an old one.
class Series {
public:
    /// Removes an earlier series of this name: the list, then its steps. Throws InvalidInput for
    /// another extension; IoError if nothing can be written there.
    Series(std::filesystem::path path, const Discretization& mesh, std::string title = {});

    /// With more text than a title, behind which a page tells what the mesh is. With times, goes on
    /// with a .pvd file to which steps at these times were added before, of which any may
    /// not be listed yet: their files stay, all later ones go. Throws likewise; InvalidInput too
    /// for a page, which holds all its steps in memory, and where one of the files is not there.
    /// `run`, if not 0, is kept in the .pvd file: what is gone on with must have the same, or
    /// InvalidInput is thrown, since its steps are another run's.
    Series(std::filesystem::path path, const Discretization& mesh, PageText text,
           const std::vector<double>& times = {}, std::uint64_t run = 0);

    /// The same for cells as write_vtu writes them, in the grid of this page; its arrays and steps
    /// are replaced by those that are added, arrows are left out.
    Series(std::filesystem::path path, Page page);

    /// Closes it, but tells of no error; a page is not written where an exception ends it.
    ~Series();
    Series(const Series&) = delete;
    Series& operator=(const Series&) = delete;

    /// Forms as draw_page takes them, with the same names, sides and degrees at every time. Throws
    /// InvalidInput, naming the step, if a form is another one than before or a time is not above
    /// the last one, and like draw_page; IoError if writing fails. Then the step is not there.
    void add(double time, const std::vector<NamedForm>& forms);

    /// The same for arrays of points and of cells.
    void add(double time, std::vector<VtuArray> point_data, std::vector<VtuArray> cell_data);

    /// Writes what is not written yet. Throws like add. Nothing can be added afterwards.
    void close();

    std::size_t size() const { return steps_.size(); }

private:
    struct Step {
        std::string time, file;
    };

    Series(std::filesystem::path path, Page page, const std::vector<double>& times,
           std::uint64_t run);
    void check_run() const;
    std::string file_of_step(std::size_t step) const;
    void keep_steps(const std::vector<double>& times);
    void check_time(double time) const;
    void check_arrays(const std::vector<VtuArray>& arrays,
                      const std::vector<VtuArray>& first) const;
    void write_step(const std::string& time);
    void write_list();
    void write_due(bool at_end);

    std::filesystem::path path_;
    std::uint64_t run_ = 0;
    int exceptions_; ///< in flight as it was begun
    bool is_page_ = false, is_closed_ = false;
    std::optional<Discretization> mesh_ = {}; ///< whose cells are not drawn yet
    Page page_;
    double last_ = 0;
    std::vector<Step> steps_ = {};
    std::size_t written_ = 0; ///< steps that the list or the page has
    std::size_t begun_ = 0;   ///< steps of an earlier run
};

} // namespace polydec
