// SPDX-License-Identifier: MIT
#pragma once

#include "system/temporary_folder.h"
#include "tests/support/test.h"
#include "tests/support/variable.h"

namespace polydec::test {

/// What is said where the program is not there.
inline const Words missing{"tetgen", "PATH", "apt-get install tetgen"};

inline bool is_available() {
    const std::vector<EngineInfo> all = engines();
    return std::ranges::find(all, EngineKind::mesher, &EngineInfo::kind)->available;
}

/// Every test gets a folder for temporary files of its own, and must leave it empty. Where the
/// program is not there, each proposition about meshes becomes: this is told.
class TetgenTest : public testing::Test {
protected:
    void TearDown() override { EXPECT_TRUE(std::filesystem::is_empty(folder_.path())); }

    template <typename F>
    void with_tetgen(F proposition) {
        if (is_available())
            proposition();
        else
            EXPECT_TRUE(says(message_of<BackendUnavailable>(proposition), missing));
    }

private:
    TemporaryFolder folder_;
    Variable temporary_{"TMPDIR", folder_.path().string()};
};

/// A cube of two triangles a side, x = 0 in the fifth pair; corner i has the bits of i as
/// coordinates.
inline Mesh cube(double scale = 1.0, double shift = 0.0) {
    Mesh mesh;
    mesh.points.resize(8, 3);
    for (Index i = 0; i < 8; ++i)
        for (int j = 0; j < 3; ++j)
            mesh.points(i, j) = scale * ((i >> j) & 1) + shift;
    mesh.simplices.resize(12, 3);
    mesh.simplices << 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 4,
        6, 0, 6, 2, 1, 3, 7, 1, 7, 5;
    return mesh;
}

inline std::string refusal_of(const Mesh& surface, const MesherOptions& options = {},
                              const Points& holes = Points(0, 3)) {
    return refusal([&] { tetrahedralize(surface, options, holes); });
}

} // namespace polydec::test
