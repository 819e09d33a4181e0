// SPDX-License-Identifier: MIT
#include "dec/cell_centers.h"

#include "dec/circumsphere.h"

namespace polydec {

Points cell_centers(const Merging& merging, const Points& points, const CellVolumes& volumes,
                    int k) {
    const Points centers = circumcenters(points, merging.input().simplices(k));
    const SparseMatrix pieces = merging.diamond(k).cast<double>().cwiseAbs();
    const Vector volume = pieces * volumes.primal[k];
    const Points weighted = volumes.primal[k].asDiagonal() * centers;
    return volume.cwiseInverse().asDiagonal() * (pieces * weighted);
}

} // namespace polydec
