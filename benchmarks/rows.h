// SPDX-License-Identifier: MIT
#pragma once

#include <benchmark/benchmark.h>
#include <filesystem>
#include <functional>
#include <string>

namespace polydec::benchmarks {

struct Settings {
    bool smoke = false;           ///< small meshes and one round: only whether it runs
    int rounds = 5;               ///< of each row; fast rows take ten times as many
    std::filesystem::path folder; ///< for the files of the rows about files

    /// The subdivisions along one axis.
    int side(int full) const { return smoke ? (full < 64 ? 3 : full / 32) : full; }

    /// The same where memory is judged, which takes meshes that dwarf what is needed in passing.
    int judged_side(int full) const { return smoke ? full * 2 / 3 : full; }
};

using Row = std::function<void(benchmark::State&)>;

/// Registers a row with that many rounds. Errors of the library become errors of the row.
void add_row(const std::string& name, int rounds, Row row);

void add_operator_rows(const Settings& settings); ///< complex, volumes, operators, merging
void add_product_rows(const Settings& settings);  ///< beside Eigen's products
void add_engine_rows(const Settings& settings);   ///< Poisson and spectra beside bare engines
void add_thread_rows(const Settings& settings);   ///< two threads beside one
void add_file_rows(const Settings& settings);     ///< reading, and the whole way from file to file
void add_size_rows(const Settings& settings);     ///< cost against size

} // namespace polydec::benchmarks
