// SPDX-License-Identifier: MIT
#include "tools/manifest.h"

#include "base/errors.h"
#include "base/printable.h"
#include "io/source_file.h"
#include "system/atomic_file.h"
#include "system/folder_names.h"
#include "system/regular_file.h"
#include "tools/outputs.h"
#include "tools/sha256.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <system_error>

namespace polydec::tools {

namespace {

constexpr const char* file_name = "manifest.json";

Fingerprint fingerprint(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    Sha256 hash;
    Fingerprint result{path, 0, {}};
    std::array<char, 1 << 16> part{};
    while (file) {
        file.read(part.data(), part.size());
        hash.add({part.data(), static_cast<std::size_t>(file.gcount())});
        result.bytes += static_cast<std::uintmax_t>(file.gcount());
    }
    if (!file.eof())
        throw IoError(fmt::format("cannot read {}: {}", printable(path.string()), system_reason()),
                      {.path = path});
    result.sha256 = hash.digits();
    return result;
}

void write_options(JsonWriter& json, const MeshArguments& options) {
    const bool by_angle = options.angle_tolerance.has_value();
    json.member("merge", options.merge);
    json.member("tolerance", by_angle ? std::nullopt : std::optional(options.tolerance));
    json.member("angle_tolerance", options.angle_tolerance);
    json.member("delaunay",
                options.delaunay.empty() ? std::nullopt : std::optional(options.delaunay));
    json.member("keep_groups", options.keep_groups);
    json.member("centers", options.centers);
    json.member("star", name(options.star));
    if (!options.joining.weld.empty())
        json.member("weld", options.joining.weld);
    if (options.joining.hanging)
        json.member("join_hanging", true);
    if (options.peel)
        json.member("peel", true);
    if (options.refine)
        json.member("refine", options.refine);
    if (!options.periods.empty())
        json.member("periodic", options.periods);
    if (!options.glue.empty())
        json.member("glue", options.glue);
}

std::string hash_of_options(const MeshArguments& options) {
    JsonWriter json;
    json.object([&] { write_options(json, options); });
    Sha256 hash;
    hash.add(json.view());
    return hash.digits();
}

/// Names and sizes, by name.
std::vector<std::pair<std::string, std::uintmax_t>> files_in(const std::filesystem::path& folder) {
    std::vector<std::pair<std::string, std::uintmax_t>> files;
    std::error_code error;
    for (const auto& name : folder_names(folder, error))
        files.emplace_back(name, std::filesystem::file_size(folder / name));
    if (error)
        throw IoError(fmt::format("cannot read the folder {}: {}", printable(folder.string()),
                                  error.message()));
    return files;
}

void write(JsonWriter& json, const Manifest& manifest, const std::filesystem::path& folder) {
    json.member("program", "polydec");
    json.member("version", POLYDEC_VERSION);
    json.member("command", manifest.command);
    json.objects("mesh", manifest.mesh, [&](const auto& read) {
        json.member("file", read.file.filename().string());
        json.member("bytes", read.bytes);
        json.member("sha256", read.sha256);
    });
    json.object("options", [&] { write_options(json, manifest.options); });
    json.member("options_sha256", hash_of_options(manifest.options));
    json.member("dimension", manifest.dimension);
    json.objects("files", files_in(folder), [&](const auto& written) {
        json.member("name", written.first);
        json.member("bytes", written.second);
    });
    json.member("warnings", manifest.warnings);
}

} // namespace

std::vector<Fingerprint> fingerprints(const std::filesystem::path& mesh) {
    std::vector<Fingerprint> list;
    std::error_code ignored;
    for (const auto& file : mesh_files(mesh))
        if (std::filesystem::is_regular_file(file, ignored) &&
            std::none_of(list.begin(), list.end(),
                         [&](const Fingerprint& other) { return other.file == file; }))
            list.push_back(fingerprint(file));
    return list;
}

void check_unchanged(const std::filesystem::path& mesh, const std::vector<Fingerprint>& before) {
    const auto now = fingerprints(mesh);
    const auto [was, is] = std::mismatch(before.begin(), before.end(), now.begin(), now.end());
    if (was == before.end() && is == now.end())
        return;
    const auto& changed = was == before.end() ? is->file : was->file;
    throw IoError(
        fmt::format("{} changed while polydec read it: try again when the file is complete",
                    printable(changed.string())));
}

std::vector<std::string> files_of_result(const std::filesystem::path& folder) {
    std::error_code none;
    if (!std::filesystem::is_regular_file(folder / file_name, none))
        return {};
    const std::string text = read_source_file(folder / file_name).text;
    // a quote within a text has a backslash before it, so this is found outside of texts alone
    constexpr std::string_view list = R"("files":[)", name = R"({"name":")", size = R"(","bytes":)";
    auto at = text.find(list);
    if (!text.starts_with(R"({"program":"polydec",)") || at == std::string::npos)
        return {};
    std::vector<std::string> names{file_name};
    for (at += list.size(); text.compare(at, name.size(), name) == 0; at += text[at] == ',') {
        at += name.size();
        const auto end = text.find(size, at);
        if (end == std::string::npos)
            return {};
        names.push_back(text.substr(at, end - at));
        at = std::min(text.find('}', end), text.size() - 1) + 1;
    }
    return names;
}

void write_manifest(const std::filesystem::path& folder, const Manifest& manifest) {
    JsonWriter json;
    json.object([&] { write(json, manifest, folder); });
    AtomicFile file(folder / file_name);
    file.write(json.view());
    file.write("\n");
    file.commit();
}

} // namespace polydec::tools
