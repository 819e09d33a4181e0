// SPDX-License-Identifier: MIT
#include "examples/paper/rivals/bunge_diamond.h"

#include "base/errors.h"
#include "examples/paper/rivals/bunge_virtual_vertex.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <string>
#include <tuple>

namespace polydec::paper {

namespace {

constexpr double least_relative_height = 1e-12;

using Entries = std::vector<Eigen::Triplet<double, Index>>;

/// A face beside an edge from `low` to `high`, and the position of its virtual vertex relative to
/// `low`: distance along the edge, and distance from the edge into the face.
struct Side {
    Index low, high, face;
    double length, along, height;

    bool same_edge(const Side& other) const { return low == other.low && high == other.high; }
};

/// The area vector gives the sign of heights. On a planar mesh the unfolded diamond is therefore
/// the diamond itself, even if a virtual vertex lies beyond an edge.
Side side_of(const PolygonMesh& mesh, Index face, std::size_t corner,
             const Eigen::Vector3d& virtual_vertex, const Eigen::Vector3d& area) {
    const auto around = mesh.face(face);
    const Index from = around[corner], to = around[(corner + 1) % around.size()];
    const auto [low, high] = std::minmax(from, to);

    const Eigen::Vector3d origin = mesh.points.row(low);
    const Eigen::Vector3d edge = mesh.points.row(high).transpose() - origin;
    const Eigen::Vector3d inward = area.cross(from == low ? edge : Eigen::Vector3d(-edge));
    const Eigen::Vector3d offset = virtual_vertex - origin;
    const double distance = edge.cross(offset).norm() / edge.norm();
    return {low,
            high,
            face,
            edge.norm(),
            offset.dot(edge) / edge.norm(),
            offset.dot(inward) < 0 ? -distance : distance};
}

/// All faces, grouped by edge.
std::vector<Side> sides_of(const PolygonMesh& mesh, const Points& virtual_vertices) {
    std::vector<Side> sides;
    sides.reserve(mesh.corners.size());
    for (Index f = 0; f < mesh.size(); ++f) {
        const Eigen::Vector3d area = area_vector(positions(mesh, f));
        for (std::size_t corner = 0; corner < mesh.face(f).size(); ++corner)
            sides.push_back(side_of(mesh, f, corner, virtual_vertices.row(f), area));
    }
    std::sort(sides.begin(), sides.end(), [](const Side& s, const Side& t) {
        return std::tie(s.low, s.high, s.face) < std::tie(t.low, t.high, t.face);
    });
    return sides;
}

[[noreturn]] void refuse_edge(const Side& side, const std::string& what) {
    throw InvalidInput("the edge from vertex " + std::to_string(side.low) + " to " +
                       std::to_string(side.high) + " " + what);
}

/// The diamonds' gradients, areas and shares, by values at vertices and virtual vertices.
class Diamonds {
public:
    explicit Diamonds(const PolygonMesh& mesh)
        : vertices_(static_cast<Index>(mesh.points.rows())),
          P_(prolongation(mesh)),
          shares_(Vector::Zero(P_.rows())) {
        const Points points = P_ * mesh.points;
        const auto sides = sides_of(mesh, points.bottomRows(mesh.size()));
        for (std::size_t i = 0; i < sides.size();) {
            std::size_t end = i + 1;
            while (end < sides.size() && sides[end].same_edge(sides[i]))
                ++end;
            add(sides[i], std::span(sides).subspan(i + 1, end - i - 1));
            i = end;
        }
    }

    PolygonLaplacian laplacian() const {
        SparseMatrix G(2 * static_cast<Index>(areas_.size()), P_.rows());
        G.setFromTriplets(gradients_.begin(), gradients_.end());
        Vector A(G.rows());
        for (Index row = 0; row < G.rows(); ++row)
            A[row] = areas_[static_cast<std::size_t>(row) / 2];

        const SparseMatrix GP = G * P_;
        return {SparseMatrix(GP.transpose()) * SparseMatrix(A.asDiagonal() * GP),
                SparseMatrix(P_.transpose()) * SparseMatrix(shares_.asDiagonal() * P_)};
    }

private:
    void add(const Side& left, std::span<const Side> others) {
        if (others.size() > 1)
            refuse_edge(left, "has " + std::to_string(others.size() + 1) +
                                  " faces; expected at most 2; split the surface there");
        // on the boundary: height 0, at the midpoint of the edge
        const double right_along = others.empty() ? left.length / 2 : others[0].along;
        const double height = left.height + (others.empty() ? 0.0 : others[0].height);
        if (!(height > least_relative_height * left.length))
            refuse_edge(left, "has a diamond without area; split the faces beside it");

        const double area = left.length * height / 2;
        add_gradient(left, others, left.along - right_along, height);
        areas_.push_back(area);
        add_shares(left, others, area);
    }

    /// With t = (u_high - u_low) / length: the part along the edge is t, the part across it
    /// (u_left - u_right - shift t) / height.
    void add_gradient(const Side& left, std::span<const Side> others, double shift, double height) {
        const auto along = 2 * static_cast<Index>(areas_.size()), across = along + 1;
        gradients_.emplace_back(along, left.low, -1 / left.length);
        gradients_.emplace_back(along, left.high, 1 / left.length);

        gradients_.emplace_back(across, vertices_ + left.face, 1 / height);
        gradients_.emplace_back(across, left.low, shift / (left.length * height));
        gradients_.emplace_back(across, left.high, -shift / (left.length * height));
        if (others.empty()) {
            gradients_.emplace_back(across, left.low, -0.5 / height);
            gradients_.emplace_back(across, left.high, -0.5 / height);
        } else {
            gradients_.emplace_back(across, vertices_ + others[0].face, -1 / height);
        }
    }

    void add_shares(const Side& left, std::span<const Side> others, double area) {
        const double share = area / static_cast<double>(3 + others.size());
        shares_[left.low] += share;
        shares_[left.high] += share;
        shares_[vertices_ + left.face] += share;
        for (const Side& other : others)
            shares_[vertices_ + other.face] += share;
    }

    Index vertices_;
    SparseMatrix P_;
    Entries gradients_;
    std::vector<double> areas_;
    Vector shares_;
};

} // namespace

PolygonLaplacian bunge_diamond(const PolygonMesh& mesh) {
    check_surface(mesh);
    return Diamonds(mesh).laplacian();
}

} // namespace polydec::paper
