// SPDX-License-Identifier: MIT
#pragma once

#include "backends/mesher.h"
#include "backends/registry.h"
#include "base/errors.h"
#include "base/temporary_folder.h"
#include "tests/support/refusal.h"
#include "tests/support/says.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string>

namespace polydec {

/// What is said where the program is not there.
inline const test::Words missing{"tetgen", "PATH", "apt-get install tetgen"};

/// A variable of the environment, for a while.
class Variable {
public:
    Variable(const char* name, const std::string& value) : name_(name) {
        const char* before = std::getenv(name);
        was_set_ = before != nullptr;
        before_ = was_set_ ? before : "";
        ::setenv(name, value.c_str(), 1);
    }
    ~Variable() { was_set_ ? ::setenv(name_, before_.c_str(), 1) : ::unsetenv(name_); }
    Variable(const Variable&) = delete;
    Variable& operator=(const Variable&) = delete;

private:
    const char* name_;
    bool was_set_;
    std::string before_;
};

inline bool is_available() {
    for (const auto& engine : engines())
        if (engine.kind == EngineKind::mesher && engine.name == "tetgen")
            return engine.available;
    return false;
}

/// Every test gets a folder for temporary files of its own, and must leave it empty. Where the
/// program is not there, each proposition about meshes becomes: this is told.
class MesherTest : public testing::Test {
protected:
    void TearDown() override { EXPECT_TRUE(std::filesystem::is_empty(folder_.path())); }

    template <typename F>
    void with_tetgen(F proposition) {
        if (is_available())
            proposition();
        else
            EXPECT_TRUE(test::says(test::message_of<BackendUnavailable>(proposition), missing));
    }

private:
    TemporaryFolder folder_;
    Variable temporary_{"TMPDIR", folder_.path().string()};
};

/// The unit cube as six squares; corner i has the bits of i as coordinates.
inline MesherInput cube(double scale = 1.0, double shift = 0.0) {
    MesherInput input;
    input.points.resize(8, 3);
    for (Index i = 0; i < 8; ++i)
        for (int j = 0; j < 3; ++j)
            input.points(i, j) = scale * ((i >> j) & 1) + shift;
    input.corners = {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
    input.offsets = {0, 4, 8, 12, 16, 20, 24};
    return input;
}

inline Points cloud(Index count) {
    constexpr double primes[] = {2.0, 3.0, 7.0};
    Points points(count, 3);
    for (Index i = 0; i < count; ++i)
        for (int j = 0; j < 3; ++j)
            points(i, j) = std::fmod((i + 1) * std::sqrt(primes[j]), 1.0);
    return points;
}

inline std::string refusal_of(const MesherInput& input, const MesherOptions& options = {}) {
    return test::refusal([&] { tetrahedralize(input, options); });
}

} // namespace polydec
