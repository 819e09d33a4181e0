// SPDX-License-Identifier: MIT
#include "benchmarks/bytes.h"

namespace polydec::benchmarks {

double bytes(const CellComplex& complex) {
    double sum = 0;
    for (int k = 0; k <= complex.dimension(); ++k)
        sum += bytes(complex.incidences(k)) + static_cast<double>(complex.size(k)); // counts
    return sum;
}

double bytes(const SimplicialComplex& complex) {
    const int n = complex.dimension();
    double sum = bytes(static_cast<const CellComplex&>(complex));
    for (int k = 0; k <= n; ++k)
        sum += bytes(complex.simplices(k));
    // of each n-simplex the row of the input and the orientation
    return sum + static_cast<double>(complex.size(n)) * (sizeof(Index) + 1);
}

double bytes(const CellVolumes& volumes) {
    double sum = 0;
    for (int k = 0; k <= volumes.dimension(); ++k)
        sum += bytes(volumes.primal(k)) + bytes(volumes.dual(k));
    return sum;
}

double bytes(const CosphericalMerging& merged) {
    return bytes(merged.merging.merged());
}

double bytes(const Discretization& discretization) {
    return bytes(discretization.complex()) + bytes(discretization.volumes());
}

double bytes(const Mesh& mesh) {
    return bytes(mesh.points) + bytes(mesh.simplices);
}

} // namespace polydec::benchmarks
