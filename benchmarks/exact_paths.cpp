// SPDX-License-Identifier: MIT
//
// Exact distances from one vertex of a mesh, of polydec and of CGAL, in turn.
//   polydec_benchmark_paths MESH [PAIRS]
#include "complex/simplicial_complex.h"
#include "dec/metric/simplex_metric.h"
#include "io/meshes/mesh_files.h"
#include "shape/geodesics.h"

#include <fmt/format.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <stdexcept>
#include <vector>

namespace {

using namespace polydec;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Paths =
    CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<Kernel, SurfaceMesh>>;

template <class Work>
double seconds(Work work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

void compare(const char* file, int pairs) {
    const Mesh mesh = read_mesh(file);
    const SimplicialComplex complex(mesh.simplices);
    const Triangles surface(complex);
    const Points points = vertex_points(complex, mesh.points);
    const Vector lengths = edge_lengths(complex, points);
    SurfaceMesh other;
    std::vector<SurfaceMesh::Vertex_index> vertices;
    for (Index v = 0; v < complex.size(0); ++v)
        vertices.push_back(other.add_vertex({points(v, 0), points(v, 1), points(v, 2)}));
    for (Index h = 0; h < 3 * surface.triangles(); h += 3)
        if (!other
                 .add_face(vertices[surface.tail(h)], vertices[surface.tail(h + 1)],
                           vertices[surface.tail(h + 2)])
                 .is_valid())
            throw std::runtime_error("CGAL takes manifolds alone");

    const std::vector<Index> source{0};
    std::vector<double> ours, theirs;
    Vector distances, of_cgal(surface.vertices());
    for (int pair = 0; pair < pairs; ++pair) {
        ours.push_back(seconds([&] { distances = exact_distance(surface, lengths, source); }));
        theirs.push_back(seconds([&] {
            Paths paths(other);
            paths.add_source_point(vertices[0]);
            for (Index v = 0; v < surface.vertices(); ++v)
                of_cgal[v] = paths.shortest_distance_to_source_points(vertices[v]).first;
        }));
    }
    fmt::print("{}: {} triangles, polydec {:.3g} s, CGAL {:.3g} s, greatest difference {:.1e} of "
               "the distance\n",
               file, surface.triangles(), median(ours), median(theirs),
               (distances - of_cgal).cwiseAbs().maxCoeff() / distances.maxCoeff());
}

} // namespace

int main(int argc, char** argv) {
    try {
        if (argc < 2) {
            fmt::print(stderr, "polydec_benchmark_paths MESH [PAIRS]\n");
            return 1;
        }
        compare(argv[1], argc > 2 ? std::max(1, std::atoi(argv[2])) : 5);
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 2;
    }
}
