// SPDX-License-Identifier: MIT
#include "tools/joining.h"

#include "io/meshes/mesh_files.h"
#include "meshes/weld.h"
#include "tools/options.h"

#include <optional>

namespace polydec::tools {

namespace {

constexpr const char* rounding = "rounding"; // what --weld alone stands for

bool is_number(const std::string& text) {
    const auto numbers = vector_of(text);
    return numbers && numbers->size() == 1;
}

} // namespace

void add_joining(CLI::App& command, JoiningArguments& arguments) {
    command
        .add_flag("--weld{rounding}", arguments.weld,
                  "[LENGTH]\tjoin vertices within LENGTH of each other (default: 1e-9 of the "
                  "mesh's size)")
        ->check([](const std::string& text) {
            return text == rounding ? std::string() : check_not_negative(text);
        });
    command.add_flag("--join-hanging", arguments.hanging,
                     "weld, then split cells at boundary vertices inside their edges and facets");
}

Mesh read_joined(const std::filesystem::path& file, const JoiningArguments& arguments) {
    Mesh mesh = read_mesh(file);
    if (!arguments.are_given())
        return mesh;
    std::optional<double> length;
    if (is_number(arguments.weld))
        length = (*vector_of(arguments.weld))[0];
    auto joined =
        arguments.hanging ? join_hanging(std::move(mesh), length) : weld(std::move(mesh), length);
    return std::move(joined.mesh);
}

std::vector<std::string> words_of(int argc, char** argv) {
    std::vector<std::string> words;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        if (!words.empty() && words.back() == "--weld" && is_number(word))
            words.back() += "=" + word;
        else
            words.push_back(word);
    }
    return words;
}

} // namespace polydec::tools
