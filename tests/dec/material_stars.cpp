// SPDX-License-Identifier: MIT
#include "dec/discretization/material_stars.h"

#include "meshes/generate.h"
#include "tests/support/circumcentric.h"
#include "tests/support/families.h"
#include "tests/support/matrices.h"
#include "tests/support/refusal.h"

#include <gtest/gtest.h>

#include <vector>

namespace polydec::test::in_material_stars {
namespace {

TEST(MaterialStars, of_1_are_those_of_galerkin) {
    for (const char* title : {"obtuse_planar", "hex4", "kuhn3", "split_cubes", "segments4"}) {
        const auto mesh = circumcentric(mesh_named(title));
        const int n = mesh.dimension();
        const auto stars = mesh.with_stars(StarKind::galerkin).stars();
        const Vector ones = Vector::Ones(mesh.complex().size(n));
        for (int k = 0; k < n; ++k)
            EXPECT_CLOSE(material_star(mesh, k, CellData::on_cells(ones)), stars[k].matrix(), 1e-13)
                << title;
        const std::vector<DenseMatrix> tensors(mesh.input().size(n),
                                               2 * DenseMatrix::Identity(n, n));
        EXPECT_CLOSE(material_star(mesh, tensors), SparseMatrix(stars[n - 1].matrix() / 2), 1e-12)
            << title;
    }
}

TEST(MaterialStars, refuse_what_is_no_conductivity) {
    const auto mesh = circumcentric(grid(2, 2));
    std::vector<DenseMatrix> tensors(8, DenseMatrix::Identity(2, 2));
    tensors[2](0, 1) = 1;
    EXPECT_REFUSED(material_star(mesh, tensors), "conductivity", "2-cell 2", "2 x 2", "symmetric");
    EXPECT_REFUSED(material_star(mesh, 1, CellData::on_cells(Eigen::Vector4d(1, 0, 1, 1))),
                   "weight", "2-cell 1", "0");
    const auto sphere = circumcentric(icosphere(1));
    EXPECT_REFUSED(material_star(sphere, std::vector<DenseMatrix>(sphere.complex().size(2),
                                                                  DenseMatrix::Identity(2, 2))),
                   "number", "cell");
}

} // namespace
} // namespace polydec::test::in_material_stars
