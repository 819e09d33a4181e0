// SPDX-License-Identifier: MIT
#include "dec/fields/de_rham.h"

#include "base/checks.h"
#include "dec/discretization/glued_box.h"
#include "dec/fields/cell_centers.h"
#include "dec/fields/flat_pieces.h"
#include "dec/fields/transfer.h"
#include "dec/forms/input_units.h"
#include "dec/metric/centers.h"
#include "dec/metric/exterior_product.h"
#include "dec/metric/inverse_star.h"
#include "dec/metric/simplex_faces.h"
#include "dec/metric/simplex_geometry.h"
#include "dec/surfaces/places.h"

#include <cmath>
#include <utility>

namespace polydec {

namespace {

/// The mean of the coefficients over the simplex whose corners are the rows.
Vector mean_of(const SmoothForm& form, const SimplexQuadrature& rule, const DenseMatrix& corners,
               Index coefficients) {
    Vector mean = Vector::Zero(coefficients);
    for (Index q = 0; q < rule.weights.size(); ++q) {
        const Vector point = (rule.points.row(q) * corners).transpose();
        mean += rule.weights[q] * checked_value(form, point, coefficients, "form");
    }
    return mean;
}

/// Integrals of one k-form over simplices given by their corners.
class Integral {
public:
    Integral(const SmoothForm& form, Index N, int k, int quadrature_degree)
        : form_(form),
          rule_(grundmann_moeller(k, quadrature_degree)),
          product_(static_cast<int>(N), k),
          factorial_(std::tgamma(k + 1.0)) {
        check_callable("the function of a smooth form", form);
    }

    /// Over the simplex whose corners are the k+1 rows.
    double operator()(const DenseMatrix& corners) const {
        const DenseMatrix edges = corners.bottomRows(corners.rows() - 1).rowwise() - corners.row(0);
        return product_(edges).dot(mean_of(form_, rule_, corners, product_.size())) / factorial_;
    }

private:
    const SmoothForm& form_;
    SimplexQuadrature rule_;
    ExteriorProduct product_;
    double factorial_;
};

/// Integrals over the duals of the k-simplices, accumulated downwards from each n-simplex, or over
/// the duals' parts within the boundary, from each boundary facet.
class DualIntegrals {
public:
    /// For duals that end at simplices of degree `top`; centers_of(i): the centers of the
    /// i-simplices in space.
    template <class CentersOf>
    DualIntegrals(const Pieces& complex, int k, int top, const Integral& integral,
                  CentersOf centers_of)
        : complex_(complex),
          integral_(integral),
          k_(k),
          top_(top),
          result_(Vector::Zero(complex.size(k))) {
        for (int i = 0; i <= top; ++i)
            centers_.push_back(i < k ? Points() : centers_of(i));
        corners_.resize(top - k + 1, centers_.back().cols());
    }

    Vector all() {
        for (Index t = 0; t < complex_.size(top_); ++t)
            descend(top_, t, 1);
        return std::move(result_);
    }

    Vector on_the_boundary(const std::vector<SignedFace>& facets) {
        for (const auto& [f, sign] : facets)
            descend(top_, f, sign);
        return std::move(result_);
    }

private:
    /// Visits all flags that continue below i-simplex s.
    void descend(int i, Index s, double sign) {
        corners_.row(i - k_) = centers_[i].row(s);
        if (i == k_) {
            result_[s] += sign * integral_(corners_);
            return;
        }
        for (int omitted = i; omitted >= 0; --omitted) {
            const double step = (i % 2 == 0 ? 1 : -1) * complex_.sign(i, s, omitted);
            descend(i - 1, complex_.face(i, s, omitted), sign * step);
        }
    }

    const Pieces& complex_;
    const Integral& integral_;
    int k_, top_;
    DenseMatrix corners_;
    Vector result_;
    std::vector<Points> centers_; // per degree
};

/// Mean coefficients of a j-form over the simplices of degree n-j, one row each.
DenseMatrix means_over(const Pieces& complex, const Points& points, int j, const SmoothForm& form,
                       int quadrature_degree) {
    const int k = complex.dimension() - j;
    const Index coefficients = ExteriorProduct(static_cast<int>(points.cols()), j).size();
    const auto rule = grundmann_moeller(k, quadrature_degree);
    DenseMatrix result(complex.size(k), coefficients);
    for (Index s = 0; s < complex.size(k); ++s)
        result.row(s) =
            mean_of(form, rule, points(vertices(complex.simplices(k), s), Eigen::indexing::all),
                    coefficients);
    return result;
}

/// Integrals of a j-form on the boundary against the Whitney forms of its k-simplices,
/// k! sum over i of (-1)^i lambda_i d lambda_0 ^ .. without i .. ^ d lambda_k.
class WhitneyMoments {
public:
    WhitneyMoments(const Pieces& pieces, const Points& points, int j, const SmoothForm& form,
                   int quadrature_degree)
        : pieces_(pieces),
          points_(points),
          form_(form),
          m_(pieces.dimension() - 1),
          k_(m_ - j),
          coefficients_(ExteriorProduct(static_cast<int>(points.cols()), j).size()),
          rule_(grundmann_moeller(m_, quadrature_degree + 1)),
          star_(static_cast<int>(points.cols()), m_, j),
          faces_(pieces, m_, k_),
          result_(Vector::Zero(pieces.size(k_))) {}

    Vector on_the_boundary(const std::vector<SignedFace>& facets) {
        for (const auto& [f, sign] : facets)
            add(f, sign);
        return std::move(result_);
    }

private:
    /// The means of the form's coefficients over facet f, times each barycentric coordinate.
    DenseMatrix means(const DenseMatrix& corners) const {
        DenseMatrix result = DenseMatrix::Zero(m_ + 1, coefficients_);
        for (Index q = 0; q < rule_.weights.size(); ++q) {
            const Vector point = (rule_.points.row(q) * corners).transpose();
            result += rule_.weights[q] * rule_.points.row(q).transpose() *
                      checked_value(form_, point, coefficients_, "form").transpose();
        }
        return result;
    }

    void add(Index f, int orientation) {
        const auto vertices_of_facet = vertices(pieces_.simplices(m_), f);
        const DenseMatrix corners = points_(vertices_of_facet, Eigen::indexing::all);
        star_.look_at(corners, orientation);
        const DenseMatrix gradients = barycentric_gradients(points_, vertices_of_facet),
                          by_corner = means(corners);
        const auto& list = faces_.of(f);
        for (std::size_t s = 0; s < list.size(); ++s)
            for (int i = 0; i <= k_; ++i) {
                auto others = faces_.positions()[s];
                const int corner = others[i];
                others.erase(others.begin() + i);
                const double sign = i % 2 == 0 ? 1 : -1;
                result_[list[s]] +=
                    sign * std::tgamma(k_ + 1.0) * star_.volume() *
                    star_.at(gradients(others, Eigen::indexing::all)).dot(by_corner.row(corner));
            }
    }

    const Pieces& pieces_;
    const Points& points_;
    const SmoothForm& form_;
    int m_, k_;
    Index coefficients_;
    SimplexQuadrature rule_;
    InverseStar star_;
    SimplexFaces faces_;
    Vector result_;
};

} // namespace

Vector de_rham(const Pieces& complex, const Points& points, int k, const SmoothForm& form,
               int quadrature_degree) {
    cell_degree(complex, Side::primal, k);
    require_straight(complex, points, "the de Rham map");
    const Integral integral(form, static_cast<Index>(points.cols()), k, quadrature_degree);
    Vector result(complex.size(k));
    DenseMatrix corners;
    for (Index s = 0; s < complex.size(k); ++s) {
        corners = points(vertices(complex.simplices(k), s), Eigen::indexing::all);
        result[s] = orientation(complex, k, s) * integral(corners);
    }
    return result;
}

namespace {

/// The form as a function of places in the unit of the mesh.
SmoothForm in_unit_of(const Discretization& mesh, const SmoothForm& form) {
    check_callable("the function of a smooth form", form);
    const double unit = mesh.unit();
    return unit == 1 ? form : [&form, unit](const Vector& place) {
        const Vector point = unit * place;
        const Vector value = form(point);
        return checked_value([&](const Vector&) { return value; }, point,
                             static_cast<Index>(value.size()), "form");
    };
}

/// Integrals of j-forms over cells of dimension j.
Vector in_input_units_of(const Discretization& mesh, int j, const Vector& integrals) {
    return form_in_input_units(integrals, mesh.unit(), j, "integrals of a form");
}

/// Inverse stars over the simplices of the input.
Vector inverse_star_de_rham(const Discretization& mesh, int j, const SmoothForm& form,
                            int quadrature_degree) {
    const int k = mesh.dimension() - j;
    const auto [points, corners] = mesh.places();
    const DenseMatrix at_places =
        means_over(placed(mesh).input(), points, j, form, quadrature_degree);
    // coefficients have no orientation, unlike simplices
    const Vector signs = from_places(mesh, k, Vector::Ones(at_places.rows()));
    const DenseMatrix means = signs.asDiagonal() * from_places(mesh, k, at_places);
    return inverse_star_means(mesh.input(), points, corners, j,
                              [&](Index, Index s) { return means.row(s); });
}

/// Values at sites_of_pieces, averaged by volume over the pieces of a cell.
Cochain values_at_sites(const Discretization& mesh, const SmoothForm& form) {
    Points rows = sites_of_pieces(mesh);
    fill_flat_pieces(mesh, rows);
    Vector values(rows.rows());
    for (Index t = 0; t < rows.rows(); ++t)
        values[t] = checked_value(form, rows.row(t).transpose(), 1, "form")[0];
    return on_cells(mesh, {Side::dual, 0, values});
}

/// The facets of the simplices of placed(mesh) on the boundary of the mesh, without the seams, with
/// their signs in the n-simplices beside them.
std::vector<SignedFace> boundary_facets(const Discretization& mesh) {
    const Pieces& pieces = placed(mesh).pieces();
    const int n = mesh.dimension();
    const auto& counts = mesh.pieces().coface_counts(n - 1);
    std::vector<SignedFace> result;
    for (Index t = 0; t < pieces.size(n); ++t)
        for (int omitted = 0; omitted <= n; ++omitted)
            if (const Index f = pieces.face(n, t, omitted);
                counts[mesh.box() ? mesh.box()->map(n - 1).onto[f] : f] == 1)
                result.push_back({f, pieces.sign(n, t, omitted)});
    return result;
}

/// For forms of places in the unit of the mesh.
Cochain dual_integrals(const Discretization& mesh, int j, const SmoothForm& form,
                       int quadrature_degree) {
    const auto N = mesh.ambient_dimension();
    require_points(N, "the de Rham map");
    const int k = cell_degree(mesh.pieces(), Side::dual, j);
    if (!mesh.chosen_stars().is_over_duals(k)) {
        const Vector primal = inverse_star_de_rham(mesh, j, form, quadrature_degree);
        return {Side::dual, j,
                mesh.geometric_star(k) * to_merged(mesh, {Side::primal, k, primal}).values};
    }
    if (j == 0)
        return values_at_sites(mesh, form); // integrals over duals use the volumes
    const Discretization& at = placed(mesh);
    const Integral integral(form, N, j, quadrature_degree);
    const Places places(at.passage(), at.measured_points());
    const auto centers_of = [&](int i) { return at_centers(at, places, at.measured_points(), i); };
    const Vector values = DualIntegrals(at.pieces(), k, at.dimension(), integral, centers_of).all();
    return on_cells(mesh, {Side::dual, j, sums_from_places(mesh, k, values)});
}

/// The same within the boundary.
Vector boundary_integrals(const Discretization& mesh, int j, const SmoothForm& form,
                          int quadrature_degree) {
    const auto N = mesh.ambient_dimension();
    const int n = mesh.dimension();
    const Discretization& at = placed(mesh);
    const auto boundary = boundary_facets(mesh);
    const int k = n - 1 - j;
    if (j > 0 && !mesh.stars()[n - j].is_diagonal()) {
        WhitneyMoments moments(at.pieces(), at.measured_points(), j, form, quadrature_degree);
        return mesh.merged().lift()[k].transpose() *
               sums_from_places(mesh, k, moments.on_the_boundary(boundary));
    }
    const Integral integral(form, N, j, quadrature_degree);
    const Places places(at.passage(), at.measured_points());
    const Centers of_facets = j == 0 && !mesh.stars()[n - 1].is_diagonal()
                                  ? Centers::centroids()
                                  : at.geometry().centers();
    const auto centers_of = [&](int i) {
        return places.at(i, center_coordinates(at.pieces(), at.geometry().metric(), of_facets, i),
                         at.measured_points());
    };
    DualIntegrals duals(at.pieces(), k, n - 1, integral, centers_of);
    const Vector of_pieces = sums_from_places(mesh, k, duals.on_the_boundary(boundary));
    const Vector result = on_cells(mesh, {Side::dual, j + 1, of_pieces}).values;
    if (j > 0)
        return result;
    // within the boundary, the dual of a facet is a point without orientation
    const Vector outward =
        mesh.complex().boundary(n).cast<double>() * Vector::Ones(mesh.complex().size(n));
    return result.cwiseProduct(outward);
}

} // namespace

Cochain de_rham(const Discretization& mesh, int k, const SmoothForm& form, int quadrature_degree) {
    const Discretization& at = placed(mesh);
    const Vector values = in_input_units_of(mesh, k,
                                            de_rham(at.input(), at.measured_input_points(), k,
                                                    in_unit_of(mesh, form), quadrature_degree));
    return to_merged(mesh, {Side::primal, k, from_places(mesh, k, values)});
}

Cochain dual_de_rham(const Discretization& mesh, int j, const SmoothForm& form,
                     int quadrature_degree) {
    Cochain result = dual_integrals(mesh, j, in_unit_of(mesh, form), quadrature_degree);
    result.values = in_input_units_of(mesh, j, result.values);
    return result;
}

Vector boundary_de_rham(const Discretization& mesh, int j, const SmoothForm& form,
                        int quadrature_degree) {
    require_points(mesh.ambient_dimension(), "the de Rham map");
    check_number("boundary data of dual forms of degree", j, 0, mesh.dimension() - 1);
    return in_input_units_of(
        mesh, j, boundary_integrals(mesh, j, in_unit_of(mesh, form), quadrature_degree));
}

} // namespace polydec
