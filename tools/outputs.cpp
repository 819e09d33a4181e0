// SPDX-License-Identifier: MIT
#include "tools/outputs.h"

#include "base/errors.h"
#include "base/printable.h"
#include "io/pages/series.h"
#include "io/pictures/draw_cells.h"
#include "io/source_file.h"
#include "system/atomic_file.h"
#include "system/regular_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace polydec::tools {

namespace {

using Path = std::filesystem::path;

void check_folder(const Path& out, const Path& folder) {
    struct stat status {};
    const auto name = printable(folder.string());
    if (::stat(folder.c_str(), &status) != 0)
        refuse_to_write(out, fmt::format("{}; create the folder {} first", system_reason(), name));
    if (!S_ISDIR(status.st_mode))
        refuse_to_write(out, fmt::format("{} is not a folder", name));
    if (!is_writable(folder) || ::access(folder.c_str(), X_OK) != 0)
        refuse_to_write(out, fmt::format("the folder {} is not writable", name));
}

void check_extension(const Path& out, const std::vector<const char*>& extensions) {
    const auto extension = lower_extension(out);
    if (std::find(extensions.begin(), extensions.end(), extension) == extensions.end())
        throw InvalidInput(fmt::format("cannot write {}: the extension '{}' is not supported here; "
                                       "use {}",
                                       printable(out.string()), printable(extension),
                                       fmt::join(extensions, " ")));
}

Paths& noted_inputs() {
    static Paths inputs;
    return inputs;
}

/// The file itself, and the steps of a series or the pieces of a .pvtu file, in the folder beside.
Paths replaced_by(const Path& out) {
    Paths files{out};
    const auto extension = lower_extension(out);
    if (extension == ".pvd")
        for (const Path& step : files_of_steps(out))
            files.push_back(step);
    std::error_code none;
    if (extension == ".pvtu")
        for (const auto& piece :
             std::filesystem::directory_iterator(Path(out).replace_extension(), none))
            files.push_back(piece.path());
    return files;
}

} // namespace

Paths mesh_files(const Path& mesh) {
    Paths files{mesh};
    const auto extension = lower_extension(mesh);
    if (extension == ".node" || extension == ".ele")
        for (const char* other :
             {".node", ".ele", ".face", ".edge", ".NODE", ".ELE", ".FACE", ".EDGE"})
            files.push_back(Path(mesh).replace_extension(other));
    return files;
}

void note_input(const Path& file) {
    const Paths files = mesh_files(file);
    noted_inputs().insert(noted_inputs().end(), files.begin(), files.end());
}

void check_output_file(const Path& out, const std::vector<const char*>& extensions) {
    check_extension(out, extensions);
    const Path target = followed(out);
    check_folder(out, out.has_parent_path() ? out.parent_path() : Path("."));
    check_folder(out, target.parent_path());
    std::error_code different;
    for (const Path& file : replaced_by(out))
        for (const Path& input : noted_inputs())
            if (std::filesystem::equivalent(file, input, different))
                throw InvalidInput(
                    fmt::format("cannot write {}: {} is the input {}, which would be lost; name "
                                "another file",
                                printable(out.string()),
                                file == out ? "it" : printable(file.string()),
                                printable(input.string())),
                    {.path = out});
    check_replaceable(out);
}

void check_output_folder(const Path& out) {
    Path target = followed(out);
    struct stat status {};
    while (::stat(target.c_str(), &status) != 0 && target.has_relative_path())
        target = target.parent_path();
    if (!S_ISDIR(status.st_mode))
        throw IoError(fmt::format("cannot create the folder {}: the file {} is in the way",
                                  printable(out.string()), printable(target.string())),
                      {.path = out});
    check_folder(out, target);
}

void check_replaced_folder(const Path& out) {
    check_output_folder(out);
    const Path target = followed(out);
    struct stat status {};
    if (::stat(target.c_str(), &status) == 0)
        check_folder(out, (target.has_filename() ? target : target.parent_path()).parent_path());
}

void check_drawable(const Discretization& mesh) {
    if (mesh.ambient_dimension() == 0)
        return polydec::check_drawable(mesh.dimension(), 0);
    try {
        polydec::check_drawable(mesh.dimension(), mesh.ambient_dimension());
    } catch (const InvalidInput& error) {
        throw InvalidInput(fmt::format("{}; omit -o", error.what()), error.place());
    }
}

} // namespace polydec::tools
