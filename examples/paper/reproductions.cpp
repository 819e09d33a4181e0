// SPDX-License-Identifier: MIT
#include "examples/paper/reproductions.h"

namespace polydec::paper {

const std::vector<Reproduction>& reproductions() {
    static const std::vector<Reproduction> list{
        {"table1", "which operators are well defined before and after merging", table1},
        {"table2", "how many triangles of a folder of meshes are concyclic", table2},
        {"fig2", "the six kinds of pairs of triangles and their dual edges", fig2},
        {"fig6", "the four kinds of meshes of the Poisson problem, with their duals", fig6},
        {"fig7", "errors of the Poisson problem under refinement and perturbation", fig7},
        {"fig8", "a spherical harmonic beside four other polygonal Laplacians", fig8},
        {"fig9", "what prescribing a least dual length does to both problems", fig9},
        {"fig10", "mean curvature of UV spheres", fig10},
        {"spectra", "certified spectra of forms of every degree on spheres", spectra},
    };
    return list;
}

} // namespace polydec::paper
