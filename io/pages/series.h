// SPDX-License-Identifier: MIT
#pragma once

#include "io/pages/page.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace polydec {

/// The existing files of the steps from the first-th on of a .pvd series: a new series that
/// replaces one at this path removes them.
std::vector<std::filesystem::path> files_of_steps(const std::filesystem::path& series,
                                                  std::size_t first = 0);

/// Pictures of one mesh at ascending times, in the format of the extension. .pvd lists .vtu files
/// in a folder of the same name beside it, for ParaView, as from draw_fields; .html is a page with
/// a time slider and playback, as from draw_page, with arrows at every time; .png and .svg are the
/// page's still picture, at the step with the largest range of values. Every file appears
/// whole or not at all. A .pvd series is written as steps are added. After a crash it is readable;
/// its list lacks at most the last 1/32 of the steps, whose files exist. A page is written at the
/// end, and replaces an old one.
class Series {
public:
    /// Removes an earlier series of this name: the list, then its steps. A page appends a
    /// description of the mesh to the text. With `times`, resumes a .pvd file that has steps at
    /// these times, some possibly not listed yet: their files stay, all later ones are removed.
    /// Throws InvalidInput for another extension, to resume a page, which holds all its steps in
    /// memory, and if one of the files is missing; IoError if the path is not writable. The .pvd
    /// file stores `run`, if not 0; resuming with another run throws InvalidInput.
    Series(std::filesystem::path path, const Discretization& mesh, PageText text = {},
           const std::vector<double>& times = {}, std::uint64_t run = 0);

    /// Closes the series, ignoring errors; does not write a page during stack unwinding.
    ~Series();
    Series(const Series&) = delete;
    Series& operator=(const Series&) = delete;

    /// Adds fields as for draw_fields, with the same names and of the same kinds at every time.
    /// Throws InvalidInput, naming the step, if a field differs from those before or a time is not
    /// above the last one, and like draw_fields; IoError if writing fails. A failed step is not
    /// added.
    void add(double time, const std::vector<NamedForm>& fields);

    /// Writes everything not yet written. Throws like add. Nothing can be added afterwards.
    void close();

    std::size_t size() const { return steps_.size(); }

private:
    struct Step {
        std::string time, file;
    };

    void check_run() const;
    std::string file_of_step(std::size_t step) const;
    void keep_steps(const std::vector<double>& times);
    void check_time(double time) const;
    void check_arrays(const VtuData& data) const;
    Page begun(const std::vector<NamedForm>& fields) const;
    PageStep drawn(const Page& page, const std::vector<NamedForm>& fields) const;
    void add_step(double time, PageStep step);
    void write_step(PageStep step);
    void write_list();
    void write_due(bool at_end);

    std::filesystem::path path_;
    Discretization mesh_;
    std::uint64_t run_;
    int exceptions_; ///< in flight at construction
    bool is_page_ = false, is_closed_ = false;
    Page page_; ///< without cells before the first step
    double last_ = 0;
    std::vector<Step> steps_ = {};
    std::size_t written_ = 0; ///< steps in the list or the page
    std::size_t begun_ = 0;   ///< steps of an earlier run
};

} // namespace polydec
