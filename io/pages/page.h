// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization/discretization.h"
#include "dec/forms/cochain.h"
#include "io/pictures/draw_fields.h"
#include "io/pictures/vtu.h"
#include "solvers/spectra/spectrum.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace polydec {

/// A table beside a picture, as text.
struct PageTable {
    std::vector<std::string> columns = {};
    std::vector<std::vector<std::string>> rows = {};
    std::vector<std::string> fields = {}; ///< for each row, the array that it selects; or empty
    std::string below = {};               ///< a note on all rows, e.g. a certificate
};

/// The text beside a picture, and its conventions. Text is shown literally; markup has no effect.
struct PageText {
    std::string title = {};
    std::string command = {};            ///< the command that made the page
    std::vector<std::string> facts = {}; ///< paragraphs
    std::vector<std::string> warnings = {};
    PageTable table = {};
    /// The mesh file, if known: the convention of its format determines the upward axis (see
    /// up_axis).
    std::filesystem::path file = {};
    std::optional<int> up = {};   ///< another axis, 0 to 2, to point up
    std::string length_unit = {}; ///< name of the unit of length, such as mm; empty: unknown
};

/// Vectors at points, shown together with an array of the grid, e.g. the vectors of a 1-form.
/// Without vectors, the lines are shown by themselves, and first: paths.
struct PageArrows {
    std::string field;   ///< name of the array
    Points sites = {};   ///< one row per vector
    Points vectors = {}; ///< one row per site
    /// Segments along the vectors, e.g. from streamlines; or empty.
    Mesh lines = {};

    bool is_path() const { return sites.rows() == 0; }
};

/// Arrays at another time, with the names and sizes of the grid's, field data with a degree; and
/// the vectors of the page's arrows, in their order.
struct PageStep : VtuData {
    std::string time = {};
    std::vector<Points> vectors = {};
};

/// The contents of a page: a grid as for write_vtu, and more.
struct Page {
    PageText text = {};
    VtuGrid grid = {};      ///< cells, and fields on them, on their corners, edges or faces
    std::string shown = {}; ///< name of the array shown first; empty: cells without values
    /// The mesh whose cells, of any degree, the grid shows, as made by draw_cells. It adds merged
    /// edges and the dual mesh. Without it, the grid alone is shown.
    std::optional<Discretization> mesh = {};
    std::vector<Index> groups = {}; ///< without mesh: for each polygon, the cell that contains it
    std::vector<PageArrows> arrows = {};
    /// Replace the grid's arrays, one after the other. The page opens at the step with the largest
    /// range of values.
    std::vector<PageStep> steps = {};
};

/// Adds the vectors_at_cells of a form, for the array of this name; on surfaces also lines along
/// them. Does nothing for forms without such vectors, and where no sharp exists.
void add_arrows(Page& page, const std::string& field, const Discretization& mesh,
                const Cochain& form);

/// The page as one self-contained HTML file without network access or timestamps; equal pages give
/// equal files. Without script or WebGL, it shows a still picture and all text. Coordinates have 7
/// digits of the extent (5 above 100 000 points), values 7 digits; above 600 000 values, they are
/// rounded to 1/65535 of their range, and the page says so. Throws InvalidInput like write_vtu for
/// an invalid grid, for arrows or steps that do not fit it, and above 64 MB.
std::string to_html(const Page& page);

/// Writes the page; the file appears whole or not at all. By the extension it is .png or .svg, a
/// picture of the page as it opens, made without a browser; .mp4, a film of its steps made by the
/// program ffmpeg; else the page itself. Throws like to_html; InvalidInput for a film without steps
/// and a picture without lines or faces; IoError if writing fails or ffmpeg is missing.
void write_page(const std::filesystem::path& path, const Page& page);

/// The cells and all arrays of a .vtu file, unchanged; arrays of 4 to 9 components are split into
/// single components. Voxels, wedges and pyramids become polyhedra; other VTK types that VtuGrid
/// lacks are errors. Reads what read_mesh reads of such files, and polyhedra. A .pvtu file is the
/// .vtu files of its pieces, one after the other. Throws InvalidInput, naming the file; IoError if
/// it cannot be read.
VtuGrid read_grid(const std::filesystem::path& path);

/// The grids of a .pvd file, which lists .vtu files with times: cells and points of the first one,
/// and a step for each. Throws like read_grid, and if the files have different arrays, or more than
/// one part.
Page read_series(const std::filesystem::path& path);

/// Combines several pages into one HTML file that shows one page at a time; hidden pages are not
/// drawn. The album itself needs no script. `pages` are results of to_html, in order, and keep
/// their titles. Throws InvalidInput for no pages; with its number, for a text that is not a page;
/// and above 64 MB.
std::string album_html(const std::string& title, const std::vector<std::string>& pages);

/// The album of these files; it appears whole or not at all. Throws like album_html, naming the
/// file; IoError if a page cannot be read or the album cannot be written.
void write_album(const std::filesystem::path& path, const std::string& title,
                 const std::vector<std::filesystem::path>& pages);

/// A page of the merged cells, with selectable tags, volumes and numbers of corners; after
/// intrinsic flips, the cells are drawn over the input's triangles. Throws like draw_cells.
Page draw_page(const Discretization& mesh, std::string title = {});

/// A page of any number of fields together, which shows the first one first. Vectors have arrows,
/// and so have 1-forms and (n-1)-forms, see add_arrows. Throws InvalidInput without fields, and
/// like draw_fields.
Page draw_page(const Discretization& mesh, const std::vector<NamedForm>& fields,
               std::string title = {});

/// The same fields at another time, for the steps of a page that draw_page made of fields with
/// these names and of these kinds. Throws like draw_fields.
PageStep draw_step(const Page& page, std::string time, const std::vector<NamedForm>& fields);

/// A page of modes, named as in draw_modes, with the table of eigenvalues, radii and residuals, and
/// the certificate. Throws like draw_cells.
Page draw_page(const Discretization& mesh, const Spectrum& spectrum, std::string title = {});

/// A certificate's statement in words.
std::string in_words(const Certificate& certificate);

} // namespace polydec
