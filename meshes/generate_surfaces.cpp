// SPDX-License-Identifier: MIT
#include "base/errors.h"
#include "meshes/generate.h"
#include "meshes/generate_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace polydec {

namespace {

/// Points (distance from the z axis, z) around a closed curve, counterclockwise.
using Profile = std::vector<Eigen::Vector2d>;

/// Revolves a profile about the z axis; outward orientation.
Mesh revolved(const Profile& profile, Index segments) {
    const auto m = static_cast<Index>(profile.size());
    Mesh mesh;
    mesh.points.resize(static_cast<Eigen::Index>(segments) * m, 3);
    mesh.simplices.resize(2 * mesh.points.rows(), 3);
    for (Index i = 0; i < segments; ++i) {
        const Eigen::Vector2d direction = circle_point(i, segments);
        const Index here = i * m, next = (i + 1) % segments * m;
        for (Index j = 0; j < m; ++j) {
            const Eigen::Vector2d& p = profile[j];
            mesh.points.row(here + j) << p.x() * direction.x(), p.x() * direction.y(), p.y();

            const Index above = (j + 1) % m;
            mesh.simplices.row(2 * (here + j)) << here + j, next + j, next + above;
            mesh.simplices.row(2 * (here + j) + 1) << here + j, next + above, here + above;
        }
    }
    return mesh;
}

/// Into how many pieces a line of the profile is cut, to make faces that are nearly square.
double pieces(const Eigen::Vector2d& a, const Eigen::Vector2d& b, int segments) {
    const double side = std::numbers::pi * (a.x() + b.x()) / segments;
    return std::max(1.0, std::round((b - a).norm() / side));
}

} // namespace

Mesh torus(int major, int minor, double major_radius, double minor_radius) {
    check_count("torus", "major", major, 3);
    check_count("torus", "minor", minor, 3);
    check_length("torus", "major_radius", major_radius);
    check_length("torus", "minor_radius", minor_radius);
    if (minor_radius >= major_radius)
        throw InvalidInput(fmt::format("torus: minor_radius = {} is not below major_radius = {}",
                                       minor_radius, major_radius));
    check_sizes("torus", 1.0 * major * minor, 2.0 * major * minor);

    Profile circle(minor);
    for (Index j = 0; j < minor; ++j)
        circle[j] = minor_radius * circle_point(j, minor) + Eigen::Vector2d(major_radius, 0.0);
    return revolved(circle, major);
}

Mesh moebius(int around, int across, double width) {
    check_count("moebius", "around", around, 3);
    check_count("moebius", "across", across, 1);
    if (!(width > 0.0 && width < 2.0))
        throw InvalidInput(fmt::format("moebius: width = {} is not between 0 and 2", width));
    check_sizes("moebius", around * (across + 1.0), 2.0 * around * across);

    // Behind the last section comes the first one, turned over.
    const auto vertex = [&](Index i, Index j) {
        return i < around ? i * (across + 1) + j : across - j;
    };
    Mesh mesh;
    mesh.points.resize(vertex(around - 1, across) + 1, 3);
    mesh.simplices.resize(static_cast<Eigen::Index>(2) * around * across, 3);
    Index triangle = 0;
    for (Index i = 0; i < around; ++i) {
        const Eigen::Vector2d direction = circle_point(i, around);
        const Eigen::Vector2d half_turn = circle_point(i, 2 * static_cast<std::int64_t>(around));
        for (Index j = 0; j <= across; ++j) {
            const double offset = width * (j - 0.5 * across) / across;
            const double radius = 1.0 + offset * half_turn.x();
            mesh.points.row(vertex(i, j)) << radius * direction.x(), radius * direction.y(),
                offset * half_turn.y();
        }
        for (Index j = 0; j < across; ++j) {
            mesh.simplices.row(triangle++) << vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1);
            mesh.simplices.row(triangle++) << vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1);
        }
    }
    return mesh;
}

Mesh flange(int segments) {
    check_count("flange", "segments", segments, 3);
    const Profile outline{{0.3, 0.0},  {1.0, 0.0},  {1.0, 0.2}, {0.55, 0.2},
                          {0.55, 0.6}, {0.45, 0.7}, {0.3, 0.7}};

    double profile_size = 0.0;
    for (std::size_t c = 0; c < outline.size(); ++c)
        profile_size += pieces(outline[c], outline[(c + 1) % outline.size()], segments);
    check_sizes("flange", segments * profile_size, 2.0 * segments * profile_size);

    Profile profile;
    profile.reserve(profile_size);
    for (std::size_t c = 0; c < outline.size(); ++c) {
        const Eigen::Vector2d& a = outline[c];
        const Eigen::Vector2d& b = outline[(c + 1) % outline.size()];
        const double count = pieces(a, b, segments);
        for (double i = 0.0; i < count; ++i)
            profile.push_back((count - i) / count * a + i / count * b);
    }
    return revolved(profile, segments);
}

} // namespace polydec
