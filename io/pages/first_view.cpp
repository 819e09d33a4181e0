// SPDX-License-Identifier: MIT
#include "io/pages/first_view.h"

#include "io/meshes/mesh_files.h"
#include "io/pictures/upright_view.h"

namespace polydec {

int upward_axis(const Page& page) {
    const int axis = page.text.up.value_or(up_axis(page.text.file));
    upright_view(axis); // throws for other axes
    return axis;
}

bool is_flat(const Points& points) {
    return points.cols() < 3 || points.rows() == 0 ||
           points.col(2).minCoeff() == points.col(2).maxCoeff();
}

SolidView first_view(const Points& points, int up) {
    SolidView view = upright_view(up);
    if (is_flat(points)) {
        view.eye = Eigen::Vector3d::UnitZ();
        view.up = Eigen::Vector3d::UnitY();
    }
    return view;
}

} // namespace polydec
