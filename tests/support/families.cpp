// SPDX-License-Identifier: MIT
#include "tests/support/read_golden.h"
#include "tests/support/test.h"

namespace polydec::test {

namespace {

std::vector<NamedMesh> golden_meshes() {
    std::vector<NamedMesh> result;
    for (const char* name :
         {"kuhn1d", "grid4", "hex4", "wellcentred4", "star_negative", "ring6", "spike", "kuhn3",
          "kuhn4", "split_cubes", "solid_torus3", "bcc2", "fcc1"})
        result.push_back({name, read_golden(std::string(name) + ".nsc")});
    for (const char* name : {"uv8", "torus8x6", "folded_rect", "branching"})
        result.push_back({name, read_golden(std::string(name) + ".off")});
    return result;
}

std::vector<NamedMesh> generated_meshes() {
    return {{"rectangles", grid(3, 2, 1.5, 1.0)},
            {"hexagons5", hexagons(5)},
            {"well_centered3", well_centered(3)},
            {"uv_sphere7x5", uv_sphere(7, 5)},
            {"icosphere3", icosphere(3)},
            {"goldberg2", goldberg(2)},
            {"torus9x5", torus(9, 5)},
            {"moebius12x2", moebius(12, 2)},
            {"flange8", flange(8)},
            {"segments4", kuhn(1, 4)},
            {"boxes", kuhn({2, 1, 3}, {1.0, 0.7, 2.0})},
            {"bcc1", bcc(1)},
            {"tesseracts2", kuhn({2, 1, 1, 1}, {1.0, 0.5, 0.8, 1.2})},
            {"kuhn5", kuhn(5, 1)},
            {"fcc_box", fcc({2, 1, 1}, 0.5)},
            {"d4_1", d4(1)},
            {"split_tesseracts", split_boxes({2, 1, 1, 1}, {1.0, 2.0, 0.7, 1.1}, 3)},
            {"circles2", sphere_clusters({.dimension = 2, .points_on_sphere = 12})},
            {"sphere3", sphere_clusters({.cells_per_side = 3, .points_on_sphere = 12})},
            {"almost_squares", perturbed(grid(4, 4), 1e-6, 8)},
            {"obtuse4", perturbed(kuhn(4, 1), 0.15, 9)}};
}

std::vector<NamedMesh> hand_made_meshes() {
    return {
        {"polygon_curve", polygon_curve()},
        {"theta_graph", theta_graph()},
        {"two_components", two_components()},
        {"obtuse_planar", obtuse_planar()},
        {"obtuse_solid", obtuse_solid()},
        {"projective_plane", projective_plane()},
        {"klein_bottle", klein_bottle()},
        {"genus_two", genus_two()},
        {"hollow_cube", hollow_cube()},
        {"clifford_torus", clifford_torus()},
        {"cubical_torus2", cubical_torus(2)},
        {"cubical_torus3", cubical_torus(3)},
        {"boundary_of_4_simplex",
         boundary_of(made_of({{0, 0, 0, 0}, {1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}},
                             {{0, 1, 2, 3, 4}}))},
        {"boundary_of_tesseract", boundary_of(kuhn(4, 1))},
        {"tilted_tetrahedra", tilted_tetrahedra()},
        {"pinched", pinched()},
        {"with_isolated_vertices", with_isolated_vertices()},
        {"triangle_soup", triangle_soup()},
        {"annulus9", annulus(9)}};
}

} // namespace

const std::vector<NamedMesh>& meshes() {
    static const auto all = [] {
        auto result = golden_meshes();
        for (auto& more : {generated_meshes(), hand_made_meshes()})
            result.insert(result.end(), more.begin(), more.end());
        return result;
    }();
    return all;
}

const Mesh& mesh_named(std::string_view name) {
    for (const auto& candidate : meshes())
        if (candidate.name == name)
            return candidate.mesh;
    throw std::out_of_range("no mesh is called " + std::string(name));
}

std::vector<std::string> names_of_meshes() {
    std::vector<std::string> names;
    for (const auto& candidate : meshes())
        names.push_back(candidate.name);
    return names;
}

bool is_flat(const Mesh& mesh) {
    return mesh.ambient_dimension() == mesh.dimension();
}

} // namespace polydec::test
