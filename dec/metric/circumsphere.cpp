// SPDX-License-Identifier: MIT
#include "dec/metric/circumsphere.h"

#include "base/checks.h"
#include "base/errors.h"
#include "dec/metric/simplex_geometry.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace polydec {

template <class Number, int k_fixed, int N_fixed>
void Circumsphere::look(int k, int N, const double* const* corners, double error) {
    auto& room = std::get<std::vector<Number>>(rooms_);
    if constexpr (k_fixed < 0)
        room.resize(static_cast<std::size_t>(k * (N + k + 4)));
    sphere_kernel::look<Number, k_fixed, N_fixed>(sphere_, k, N, corners, error, room.data());
}

bool Circumsphere::look_at(const Corners& corners) {
    check_number("vertices of a simplex", std::ssize(corners.vertices), 1, most_vertices);
    const auto k = static_cast<int>(corners.vertices.size()) - 1;
    const auto N = static_cast<int>(corners.points.cols());
    dimension_ = k;
    sphere_.volume = 0;
    if (k > N) // too many to be independent
        return false;
    std::array<const double*, most_vertices> places;
    for (int i = 0; i <= k; ++i)
        places[i] = corners.place(corners.vertices[i]);
    sphere_kernel::for_dimensions(k, N, [&]<int k_fixed, int N_fixed> {
        look<double, k_fixed, N_fixed>(k, N, places.data(), corners.error);
    });
    if (constexpr double largest = 1e145; // its square is finite
        !(volume() < largest && volume() > 1 / largest))
        look<TwoDoubles, -1, -1>(k, N, places.data(), corners.error);
    if (corners.by_lengths && volume() > 0)
        sphere_kernel::measure_distances<double>(sphere_, k, N, places.data());
    return volume() > 0;
}

void Circumsphere::look_at(SimplexLayout& layout, int k, Index s) {
    if (look_at(layout.at(k, s)))
        return;
    const auto vertices = layout.complex().vertex_numbers(k, s);
    throw InvalidInput(fmt::format("the {}-simplex with vertices {} has no volume, and so no "
                                   "circumsphere: remove it or move a vertex",
                                   k, fmt::join(vertices, ", ")),
                       {.degree = k, .vertices = vertices});
}

void Circumsphere::refuse_flat() {
    throw InvalidInput("a simplex without volume has no circumsphere: remove it or move a vertex");
}

} // namespace polydec
