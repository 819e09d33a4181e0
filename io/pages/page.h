// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"
#include "dec/forms/cochain.h"
#include "io/pictures/vtu.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace polydec {

/// Numbers that belong to a picture, as text.
struct PageTable {
    std::vector<std::string> columns = {};
    std::vector<std::vector<std::string>> rows = {};
    std::vector<std::string> fields = {}; ///< of each row the array that choosing it shows; or none
    std::string below = {};               ///< what holds for all rows, e.g. a certificate
};

/// What is said beside a picture. Any text is shown as it is; nothing in it is a mark.
struct PageText {
    std::string title = {};
    std::string command = {};            ///< what made the page
    std::vector<std::string> facts = {}; ///< paragraphs
    std::vector<std::string> warnings = {};
    PageTable table = {};
};

/// Vectors at places, which are shown with an array of the grid: those of a 1-form, say. Without
/// any, lines stand for themselves, and are seen first: paths.
struct PageArrows {
    std::string field;   ///< name of the array
    Points sites = {};   ///< a row for each
    Points vectors = {}; ///< the same rows
    /// Segments that run along them, as streamlines gives them; or none.
    Mesh lines = {};
};

/// Arrays at another time, of the names and sizes that the grid has.
struct PageStep {
    std::string time;
    std::vector<VtuArray> point_data = {};
    std::vector<VtuArray> cell_data = {};
};

/// What a page shows: the grid that write_vtu would write, and what is known besides.
struct Page {
    PageText text = {};
    VtuGrid grid = {};      ///< cells, and fields on them or on their corners
    std::string shown = {}; ///< name of the array that is seen first; empty: cells without values
    /// Whose cells the grid has, in any degree, as draw_cells makes them; adds edges that were
    /// merged away and the dual mesh. Without it the grid is shown by itself.
    std::optional<Discretization> mesh = {};
    std::vector<Index> groups = {}; ///< of each polygon, without mesh: the cell that it is part of
    std::vector<PageArrows> arrows = {};
    std::vector<PageStep> steps = {}; ///< instead of the grid's arrays, one after the other
};

/// Adds the vectors that a 1-form, primal or dual, is the work of, for the array of this name: by
/// sharp_pd and flux_sharp; on surfaces also lines along them. Nothing for other forms, and where a
/// sharp cannot be had.
void add_arrows(Page& page, const std::string& field, const Discretization& mesh,
                const Cochain& form);

/// The page: one HTML file that needs nothing else, no network and no time; the same for the same
/// page. Where there is no script or no WebGL, it has a still picture and all text. Coordinates
/// are good to 7 digits of the extent (5 above 100 000 points), values to 7 digits, but above
/// 600 000 values to 1/65535 of their range, which the page says.
/// Throws InvalidInput like write_vtu for a grid that does not fit, for arrows or steps that do not
/// fit to it, and for what makes more than 64 MB.
std::string to_html(const Page& page);

/// Writes it; the file appears whole or not at all. Throws like to_html; IoError if writing fails.
void write_page(const std::filesystem::path& path, const Page& page);

} // namespace polydec
