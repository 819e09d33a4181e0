// SPDX-License-Identifier: MIT
#include "io/pages/film.h"

#include "base/errors.h"
#include "base/printable.h"
#include "io/pages/still.h"
#include "io/source_file.h"
#include "system/atomic_file.h"
#include "system/child_process.h"
#include "system/temporary_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace polydec {

namespace {

/// Films last about eight seconds, with 2 to 25 steps in each.
int steps_a_second(std::size_t steps) {
    return static_cast<int>(std::clamp(std::round(static_cast<double>(steps) / 8), 2.0, 25.0));
}

std::filesystem::path ffmpeg(const std::filesystem::path& path) {
    const auto program = find_program("ffmpeg");
    if (!program)
        throw IoError(fmt::format("cannot write {}: films need the program ffmpeg, which is not "
                                  "in PATH; install it (apt-get install ffmpeg), or write a page, "
                                  ".html, which plays",
                                  printable(path.string())),
                      {.path = path});
    return *program;
}

/// Options of ffmpeg with their values, and the file.
std::vector<std::string> ffmpeg_words(std::size_t steps, const std::filesystem::path& file) {
    const std::vector<std::vector<std::string>> options{
        {"loglevel", "error"},
        {"y"},
        {"framerate", std::to_string(steps_a_second(steps))},
        {"i", "%06d.png"},
        {"c:v", "libx264"},
        {"crf", "20"},
        {"pix_fmt", "yuv420p"},
        {"movflags", "+faststart"},
        {"f", "mp4"}};
    std::vector<std::string> words;
    for (const auto& option : options) {
        words.push_back("-" + option.front());
        words.insert(words.end(), option.begin() + 1, option.end());
    }
    words.push_back("file:" + file.string());
    return words;
}

} // namespace

void check_film(const std::filesystem::path& path) {
    ffmpeg(path);
}

void write_film(const std::filesystem::path& path, const Page& page) {
    const auto program = ffmpeg(path);
    if (page.steps.empty())
        refuse_writing(path, "a film shows the steps of a series; give a .pvd file, or write a "
                             ".png picture");
    const TemporaryFolder folder;
    std::size_t count = 0;
    draw_steps(page, [&](const std::string& png) {
        AtomicFile file(folder.path() / fmt::format("{:06}.png", count++));
        file.write(png);
        file.commit();
    });
    AtomicFile film(path);
    const auto target = std::filesystem::absolute(film.unfinished());
    const auto outcome =
        run_child(program, ffmpeg_words(count, target), folder.path(), {.seconds = 3600});
    if (outcome.end != ChildEnd::exited || outcome.code != 0)
        throw IoError(fmt::format("cannot write {}: ffmpeg failed: {}", printable(path.string()),
                                  printable(outcome.output)),
                      {.path = path});
    film.commit();
}

} // namespace polydec
