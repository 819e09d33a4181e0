// SPDX-License-Identifier: MIT
#include "tests/solvers/cases.h"

namespace polydec::test {

namespace {

constexpr double coefficient = 1.7;

/// Cubes of which the lowest quarter is pressed together to thin layers.
Mesh partly_thin(int n, int cells) {
    Mesh mesh = kuhn(n, cells);
    const double part = 0.25, whole = part / 1e5;
    for (double& y : mesh.points.col(n - 1))
        y = y <= part ? y / 1e5 : whole + (y - part) / (1 - part) * (1 - whole);
    return mesh;
}

} // namespace

Discretization with_stars(const Mesh& mesh, StarKind star) {
    auto result = circumcentric(mesh);
    return star == StarKind::circumcentric ? result : result.with_stars(star);
}

Mesh unit_cube(const std::string& pattern, int cells) {
    static const std::map<std::string, Mesh (*)(int)> patterns{
        {"interval", [](int m) { return kuhn(1, m); }},
        {"squares", [](int m) { return grid(m, m); }},
        {"thin_squares", [](int m) { return partly_thin(2, m); }},
        {"triangles", [](int m) { return well_centered(m); }},
        {"shaken_triangles", [](int m) { return shaken_inside(well_centered(m), 0.03 / m); }},
        {"hexagons", [](int m) { return hexagons(m); }},
        {"cubes", [](int m) { return kuhn(3, m); }},
        {"thin_cubes", [](int m) { return partly_thin(3, m); }},
        {"split_cubes",
         [](int m) {
             return split_boxes({m, m, m});
         }},
        {"bcc", [](int m) { return bcc(m); }},
        {"shaken_bcc", [](int m) { return shaken_inside(bcc(m), 0.03 / m); }},
        {"fcc", [](int m) { return fcc(m); }},
        {"tesseracts", [](int m) { return kuhn(4, m); }},
        {"d4", [](int m) { return d4(m); }},
        {"cubes5", [](int m) { return kuhn(5, m); }}};
    return patterns.at(pattern)(cells);
}

std::string Case::name() const {
    return star == StarKind::circumcentric ? pattern
                                           : pattern + "_" + std::string(polydec::name(star));
}

const Discretization& Case::mesh(int cells) const {
    static std::map<std::tuple<std::string, int, StarKind>, std::unique_ptr<Discretization>> made;
    auto& entry = made[{pattern, cells, star}];
    if (!entry)
        entry = std::make_unique<Discretization>(with_stars(unit_cube(pattern, cells), star));
    return *entry;
}

double order(const Case& of, const std::function<double(const Discretization&)>& error) {
    return std::log(error(of.mesh(of.coarse)) / error(of.mesh(of.fine))) /
           std::log(static_cast<double>(of.fine) / of.coarse);
}

Vector orders(const Case& of, const std::function<Vector(const Discretization&)>& errors) {
    const Vector ratios = errors(of.mesh(of.coarse)).cwiseQuotient(errors(of.mesh(of.fine)));
    return ratios.array().log() / std::log(static_cast<double>(of.fine) / of.coarse);
}

/// Robin's condition opposite to essential facets.
BoundaryConditions conditions_of(const Discretization& mesh, Where where, double end) {
    if (where == Where::essential)
        return {BoundaryCondition::essential};
    if (where == Where::natural)
        return {BoundaryCondition::natural};
    const auto mixed = essential_where(cell_centers(mesh, mesh.dimension() - 1),
                                       [end](const Vector& site) { return site[0] < end; });
    return where == Where::mixed ? mixed : robin_elsewhere(mixed, coefficient);
}

Cochain exact_form(const Discretization& mesh, Side side, const WaveForm& wave) {
    const int n = mesh.dimension();
    if (side == Side::primal || mesh.stars()[n - wave.degree()].is_diagonal())
        return wave.on(mesh, side);
    const double twice = wave.degree() * (n - wave.degree()) % 2 == 0 ? 1 : -1;
    return twice * star(mesh, de_rham(mesh, n - wave.degree(), wave.star()));
}

double size_of(const Discretization& mesh, const Cochain& form) {
    const int n = mesh.dimension(), k = form.side == Side::primal ? form.degree : n - form.degree;
    const HodgeStar star = mesh.stars()[k];
    if (!star.is_diagonal())
        return norm(mesh, form);
    const Vector weights = star.diagonal().cwiseAbs();
    const Vector inverse = (weights.array() > 1e-9).select(weights.cwiseInverse(), 0);
    return std::sqrt((form.side == Side::primal ? weights : inverse).dot(form.values.cwiseAbs2()));
}

BoundaryForms data_of(const Discretization& mesh, Side side, const WaveForm& wave, Where where) {
    BoundaryForms data = wave.boundary(mesh, side);
    if (where != Where::robin || data.derivative_flow.size() == 0)
        return data;
    data.derivative_flow += coefficient * wave.boundary_star(mesh, side);
    if (side == Side::dual && data.values.size() > 0)
        data.values = boundary_de_rham(mesh, wave.degree(), [=](const Vector& x) -> Vector {
            return (x[0] < 1e-9 ? 1 : 0) * wave.form()(x);
        });
    return data;
}

BoundaryForms random_data(const CellComplex& complex, Side side, int degree) {
    const int k = cell_degree(complex, side, degree);
    const auto values = [&](int on, unsigned seed) {
        return on < 0 ? Vector() : random_vector(complex.size(on), seed);
    };
    if (side == Side::primal)
        return {values(k, 1), values(k - 1, 2), values(k - 1, 3), values(k, 4)};
    return {values(k - 1, 1), values(k, 2), values(k, 3), values(k - 1, 4)};
}

FormSpace functions(const Cells& cells, Side side, const BoundaryConditions& conditions) {
    return {cells, side, 0, conditions};
}

PoissonSolution solved(const PoissonSolver& solver, const Vector& f, const Vector& values,
                       const Vector& derivatives) {
    const FormSpace& space = solver.space();
    BoundaryForms data{.values = values};
    if (derivatives.size() > 0)
        data.derivative_flow = outward_flow(space.cells(), space.side(), derivatives);
    return solver.solve({space.side(), 0, f}, data);
}

Cochain heated(const FormSpace& space, const Cochain& start, double time_step, int steps,
               const std::string& integrator) {
    space.check(start);
    Evolution run({{.space = space, .start = start.values, .diffusion = 1}}, {},
                  {.integrator = integrator, .steps = {.fixed_step = time_step}});
    run.march(steps * time_step);
    return run.form(0);
}

Vector at(const Points& sites, const std::function<double(const Vector&)>& function) {
    Vector result(sites.rows());
    for (Index i = 0; i < result.size(); ++i)
        result[i] = function(sites.row(i).transpose());
    return result;
}

double l2_norm(const Discretization& mesh, Side side, const Vector& values) {
    const Vector& volumes =
        side == Side::primal ? mesh.volumes().dual(0) : mesh.volumes().primal(mesh.dimension());
    return std::sqrt(volumes.cwiseAbs().dot(values.cwiseAbs2()));
}

DenseMatrix outward_normals(const Discretization& mesh) {
    const int n = mesh.dimension();
    const Vector cells =
        de_rham(mesh, n, [](const Vector&) { return Vector(Vector::Ones(1)); }).values.cwiseSign();
    const Vector outward = mesh.complex().coboundary(n - 1).cast<double>().transpose() * cells;
    DenseMatrix result(outward.size(), n);
    for (int axis = 0; axis < n; ++axis) {
        const Vector flux = euclidean_star(n, 1, Vector::Unit(n, axis));
        result.col(axis) =
            outward.cwiseProduct(de_rham(mesh, n - 1, [&](const Vector&) { return flux; }).values);
    }
    return mesh.volumes().primal(n - 1).cwiseInverse().asDiagonal() * result;
}

} // namespace polydec::test
