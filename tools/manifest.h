// SPDX-License-Identifier: MIT
#pragma once

#include "tools/common.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace polydec::tools {

/// A file as it was read: its SHA-256, in hexadecimal digits, tells whether it is still the same.
struct Fingerprint {
    std::filesystem::path file;
    std::uintmax_t bytes = 0;
    std::string sha256;

    bool operator==(const Fingerprint&) const = default;
};

/// Those of the files of a mesh that are there. Throws IoError.
std::vector<Fingerprint> fingerprints(const std::filesystem::path& mesh);

/// Throws IoError, naming a file, if the files of a mesh are no longer what they were.
void check_unchanged(const std::filesystem::path& mesh, const std::vector<Fingerprint>& before);

/// What a folder of results is made from.
struct Manifest {
    std::string command;
    std::vector<Fingerprint> mesh;
    const MeshArguments& options;
    int dimension = 0;
    std::vector<std::string> warnings;
};

/// Writes manifest.json into the folder: the manifest, and name and size of each file that is
/// there. To be written last: a folder without it is not whole.
void write_manifest(const std::filesystem::path& folder, const Manifest& manifest);

/// The names of the files that belong to the result in a folder: those that its manifest lists, and
/// manifest.json. None if there is no manifest, or not as write_manifest writes it.
std::vector<std::string> files_of_result(const std::filesystem::path& folder);

} // namespace polydec::tools
