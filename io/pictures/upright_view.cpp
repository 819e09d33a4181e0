// SPDX-License-Identifier: MIT
#include "io/pictures/upright_view.h"

#include "base/errors.h"

#include <fmt/format.h>

#include <array>

namespace polydec {

SolidView upright_view(int up) {
    if (up < 0 || up > 2)
        throw InvalidInput(fmt::format("axis {} is to point up: expected 0, 1 or 2", up));
    // turned so that right-handed coordinates stay so; models with y up are seen from their front
    const std::array eyes{Eigen::Vector3d(1.2, 1, -2), Eigen::Vector3d(1, 1.2, 2),
                          Eigen::Vector3d(1, -2, 1.2)};
    SolidView view;
    view.eye = eyes[up];
    view.up = Eigen::Vector3d::Unit(up);
    return view;
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
