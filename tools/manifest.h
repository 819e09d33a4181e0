// SPDX-License-Identifier: MIT
#pragma once

#include "tools/common.h"

#include <filesystem>
#include <string>
#include <vector>

namespace polydec::tools {

/// An input file: its SHA-256, in hexadecimal digits, detects changes.
struct Fingerprint {
    std::filesystem::path file;
    std::uintmax_t bytes = 0;
    std::string sha256;

    bool operator==(const Fingerprint&) const = default;
};

/// The fingerprints of a mesh's existing files. Throws IoError.
std::vector<Fingerprint> fingerprints(const std::filesystem::path& mesh);

/// Throws IoError, naming a file, if the files of a mesh have changed.
void check_unchanged(const std::filesystem::path& mesh, const std::vector<Fingerprint>& before);

/// The inputs of a folder of results.
struct Manifest {
    std::string command;
    std::vector<Fingerprint> mesh;
    const MeshArguments& options;
    int dimension = 0;
    std::vector<std::string> warnings;
};

/// Writes manifest.json into the folder: the manifest, and name and size of each file there. Write
/// it last: a folder without it is incomplete.
void write_manifest(const std::filesystem::path& folder, const Manifest& manifest);

/// The names of the result files in a folder: the files listed in its manifest, and manifest.json.
/// Empty without a manifest from write_manifest.
std::vector<std::string> files_of_result(const std::filesystem::path& folder);

} // namespace polydec::tools
