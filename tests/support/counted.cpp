// SPDX-License-Identifier: MIT
#include "tests/support/test.h"

namespace polydec::test {

std::set<std::vector<Index>> faces(const Mesh& mesh, int k) {
    std::set<std::vector<Index>> found;
    const auto corners = static_cast<int>(mesh.simplices.cols());
    for (Index t = 0; t < mesh.simplices.rows(); ++t)
        for (int chosen = 0; chosen < 1 << corners; ++chosen) {
            std::vector<Index> face;
            for (int i = 0; i < corners; ++i)
                if (chosen >> i & 1)
                    face.push_back(mesh.simplices(t, i));
            std::sort(face.begin(), face.end());
            if (static_cast<int>(face.size()) == k + 1)
                found.insert(face);
        }
    return found;
}

double total_volume(const Mesh& mesh) {
    const int n = mesh.dimension();
    double sum = 0;
    for (Index t = 0; t < mesh.simplices.rows(); ++t) {
        DenseMatrix edges(mesh.ambient_dimension(), n);
        for (int i = 0; i < n; ++i)
            edges.col(i) =
                mesh.points.row(mesh.simplices(t, i + 1)) - mesh.points.row(mesh.simplices(t, 0));
        sum += std::abs(triangular_factor(edges).diagonal().prod());
    }
    return sum / std::tgamma(n + 1.0);
}

std::vector<Index> sizes(const CellComplex& complex) {
    std::vector<Index> result;
    for (int k = 0; k <= complex.dimension(); ++k)
        result.push_back(complex.size(k));
    return result;
}

Index binomial(Index n, int k) {
    if (k < 0 || k > n)
        return 0;
    Index result = 1;
    for (int i = 1; i <= k; ++i)
        result = result * (n - k + i) / i;
    return result;
}

} // namespace polydec::test
