// SPDX-License-Identifier: MIT
//
// What makes complexes, volumes and systems, asked with tables that fit and with tables that do
// not: see Asking.
#include "dec/merging/merged_tags.h"
#include "tests/io/doors.h"
#include "tests/io/support.h"

namespace polydec::test {
namespace {

/// The simplices of a sample with its points, the last of which is missing if the input is flawed:
/// a mesh may have more of them than its simplices use.
Mesh mesh_of(const Sample& s, Inputs& in) {
    const auto& points = s.mesh.input_points();
    const bool right = in.points(s.K().size(0), 1).rows() == s.K().size(0);
    return {points.topRows(right ? points.rows() : points.rows() - 1), s.K().simplices(s.n()), {}};
}

/// Tags for its simplices, one too few or too many where the input is flawed.
Mesh tagged_mesh_of(const Sample& s, Inputs& in) {
    Inputs right;
    Mesh mesh = mesh_of(s, right);
    mesh.tags = in.list<Index>(mesh.simplices.rows(), 3);
    return mesh;
}

void ask_of_makers(const Asking& ask, const Sample& s, int k) {
    const int n = s.n();
    const auto all_of = [n](auto of) {
        std::vector<Vector> result;
        for (int degree = 0; degree <= n; ++degree)
            result.push_back(of(degree));
        return result;
    };

    ask("CellVolumes", [&](Inputs& in) {
        auto primal = all_of([&](int j) { return s.V().primal(j); });
        const auto dual = all_of([&](int j) { return s.V().dual(j); });
        primal[k] = in.vector(s.size(k));
        return fit(CellVolumes(primal, dual).dual(k), s.size(k));
    });
    ask("CellVolumes::numbered", [&](Inputs& in) {
        std::vector<std::vector<Index>> numbers;
        for (int j = 0; j <= n; ++j)
            numbers.emplace_back(s.size(j), 5);
        numbers[k] = in.list<Index>(s.size(k), 7);
        return fit(s.V().numbered(numbers).number(k, 0) == 7);
    });
    ask("Centers", [&](Inputs& in) {
        std::vector<Points> coordinates;
        for (int j = 0; j <= n; ++j)
            coordinates.emplace_back(Points::Constant(s.pieces().size(j), j + 1, 1.0 / (j + 1)));
        const auto given = in.matrix(s.pieces().size(k), k + 1);
        coordinates[k] = Points::Constant(given.rows(), given.cols(), 1.0 / (k + 1));
        const Centers centers(coordinates);
        centers.check_fit(s.pieces());
        return fit(dual_volumes(s.pieces(), s.mesh.geometry().metric(), centers).dual(k),
                   s.pieces().size(k));
    });
    ask("CellComplex", [&](Inputs& in) {
        std::vector<IncidenceMatrix> d;
        for (int j = 0; j < n; ++j)
            d.push_back(s.K().coboundary(j));
        if (0 < k && k < n) // columns of d_k are rows of d_(k-1)
            d[k].conservativeResize(d[k].rows(), in.vector(d[k].cols()).size());
        return fit(CellComplex(d).size(k) == s.K().size(k));
    });
    ask("Pieces", [&](Inputs& in) {
        const auto& K = s.pieces();
        std::vector<Simplices> faces;
        for (int j = 1; j <= n; ++j) {
            faces.emplace_back(K.size(j), j + 1);
            for (Index t = 0; t < K.size(j); ++t)
                for (int i = 0; i <= j; ++i)
                    faces.back()(t, i) = K.face(j, t, i);
        }
        std::vector<std::int8_t> orientations = in.list<std::int8_t>(K.size(n), 1);
        for (std::size_t t = 0; t < std::min(orientations.size(), std::size_t(K.size(n))); ++t)
            orientations[t] = static_cast<std::int8_t>(K.orientation(Index(t)));
        std::vector<Index> vertices(std::size_t(K.size(0)));
        std::iota(vertices.begin(), vertices.end(), 0);
        if (k > 0) { // a table of one column too many, or with a face that there is not
            const auto width = in.matrix(K.size(k), k + 1);
            if (width.rows() != K.size(k))
                faces[k - 1](0, 0) = K.size(k - 1);
            faces[k - 1].conservativeResize(K.size(k), width.cols());
        }
        return fit(Pieces(faces, orientations, vertices).size(k) == K.size(k));
    });
    ask("Discretization::Parts", [&](Inputs& in) {
        const auto& mesh = s.mesh;
        const Points given = in.points(mesh.input_points().rows(), mesh.input_points().cols());
        Discretization::Parts parts{.input = mesh.input_geometry(),
                                    .passage = mesh.passage(),
                                    .merged = mesh.merged(),
                                    .input_points = std::make_shared<const Points>(given),
                                    .points = std::make_shared<const Points>(mesh.points()),
                                    .tags = in.list<Index>(s.size(s.n()), 1),
                                    .isolated = mesh.isolated(),
                                    .facet_tags = {in.list<Index>(s.size(s.n() - 1), 1)}};
        return fit(Discretization(parts).complex().size(k) == s.size(k));
    });
    ask("check_fit", [&](Inputs& in) {
        const Vector dual = in.vector(s.size(k));
        check_fit(s.P(), s.V().with_dual(k, dual));
        return fit(true);
    });
    ask("HodgeStar of a matrix", [&](Inputs& in) {
        const SparseMatrix M(in.vector(s.size(k)).cwiseAbs2().asDiagonal());
        const auto stars = s.mesh.stars().with(in.degree(s, k), M);
        return fit(stars[k].matrix(), s.size(k), s.size(k));
    });
    ask("choose_stars", [&](Inputs&) {
        const auto chosen = s.mesh.with_stars(static_cast<StarKind>(k)).chosen_stars();
        return fit(chosen.galerkin_share() <= 1 && std::ssize(chosen.galerkin) == s.size(s.n()) &&
                   fit(chosen.stars[k].matrix(), s.size(k), s.size(k)).empty());
    });
}

void ask_of_meshes(const Asking& ask, const Sample& s) {
    const int n = s.n();
    const auto rows = [&s] { return s.K().size(s.n()); };

    ask("discretize", [&](Inputs& in) {
        return fit(discretize(mesh_of(s, in), {MergeCriterion::none}).complex().size(n) ==
                   s.K().size(n));
    });
    ask("discretize with tags", [&](Inputs& in) {
        return fit(std::ssize(discretize(tagged_mesh_of(s, in), {MergeCriterion::none}).tags()) ==
                   s.K().size(n));
    });
    ask("tidy",
        [&](Inputs& in) { return fit(tidy(tagged_mesh_of(s, in)).simplices.rows() == rows()); });
    ask("shuffled", [&](Inputs& in) {
        return fit(shuffled(tagged_mesh_of(s, in), 1).mesh.simplices.rows() == rows());
    });
    ask("along_morton_curve", [&](Inputs& in) {
        return fit(along_morton_curve(tagged_mesh_of(s, in)).mesh.simplices.rows() == rows());
    });
    ask("tags_of_cells", [&](Inputs& in) {
        return fit(std::ssize(tags_of_cells(s.K(), in.list<Index>(s.K().size(n), 2))) ==
                   s.K().size(n));
    });
    ask("tags_of_facets", [&](Inputs& in) {
        std::vector<std::string> warnings;
        const TaggedSimplices facets{s.K().simplices(n - 1), in.list<Index>(s.K().size(n - 1), 2)};
        return fit(std::ssize(tags_of_facets(s.K(), facets, warnings).tags) == s.K().size(n - 1));
    });
    ask("vertex_points", [&](Inputs& in) {
        Index last = 0;
        for (Index v = 0; v < s.K().size(0); ++v)
            last = std::max(last, s.K().vertex_number(v));
        Points table = in.points(last + 1, 3);
        if (table.rows() > last + 1) // may have vertices that no cell uses
            table.conservativeResize(last, Eigen::NoChange);
        return fit(vertex_points(s.K(), table), s.K().size(0), 3);
    });
    ask("unit_of_length", [&](Inputs&) {
        Inputs right;
        const Mesh mesh = mesh_of(s, right);
        return fit(unit_of_length(mesh)) + fit(in_units(mesh, 4).points.allFinite()) +
               fit(in_input_units(Vector::Ones(2), 4, 0.5, "lengths"), 2);
    });
    ask("write_mesh and read_mesh", [&](Inputs& in) {
        const test::TemporaryFolder folder;
        write_mesh(folder.path("a.nsc"), mesh_of(s, in));
        return fit(read_mesh(folder.path("a.nsc")).simplices.rows() == rows());
    });
    ask("write_mesh with tags", [&](Inputs& in) {
        const test::TemporaryFolder folder;
        write_mesh(folder.path("a.mesh"), tagged_mesh_of(s, in));
        return fit(std::ssize(read_mesh(folder.path("a.mesh")).tags) == rows());
    });
    ask("write_lengths and read_lengths", [&](Inputs& in) {
        const auto& edges = s.K().simplices(1);
        const LengthMesh lengths{s.K().simplices(s.n()), s.K().size(0), edges,
                                 in.vector(edges.rows())};
        const test::TemporaryFolder folder;
        write_lengths(folder.path("a.nsl"), lengths);
        return fit(read_lengths(folder.path("a.nsl")).lengths, s.K().size(1));
    });
    ask("write_vtu", [&](Inputs& in) {
        VtuGrid grid = draw_cells(s.mesh, 0);
        grid.point_data.push_back(vtu_array("a", in.vector(grid.points.rows())));
        const test::TemporaryFolder folder;
        write_vtu(folder.path("a.vtu"), grid);
        return fit(!test::read_text(folder.path("a.vtu")).empty());
    });
    ask("split_polygons", [&](Inputs& in) {
        PolygonMesh polygons = polygon_mesh(s.mesh);
        const auto faces = polygons.size();
        if (n == 1) // no polygons, and nothing to be flawed
            return fit(split_polygons(polygons).simplices.rows() == 0);
        polygons.tags = in.list<Index>(faces, 3);
        const auto corners = in.vector(std::ssize(polygons.corners)).size();
        polygons.corners.resize(static_cast<std::size_t>(corners), 0);
        const Mesh mesh = split_polygons(polygons);
        return fit(mesh.simplices.rows() >= faces && faces > 0 &&
                   std::ssize(mesh.tags) == mesh.simplices.rows());
    });
    ask("add_cell", [&](Inputs& in) {
        VtuGrid grid;
        grid.points = Points::Zero(8, 3);
        std::vector<Index> corners(static_cast<std::size_t>(in.vector(3).size()));
        std::iota(corners.begin(), corners.end(), 0);
        add_cell(grid, VtuCell::triangle, corners);
        const test::TemporaryFolder folder;
        write_vtu(folder.path("a.vtu"), grid);
        return fit(!test::read_text(folder.path("a.vtu")).empty());
    });
    ask("read_matrix_market_array", [&](Inputs& in) {
        const test::TemporaryFolder folder;
        std::string text =
            "%%MatrixMarket matrix array real general\n" + std::to_string(s.size(0)) + " 2\n";
        const auto values = in.matrix(s.size(0), 2);
        for (const double value : values.reshaped())
            text += std::to_string(value) + "\n";
        return fit(read_matrix_market_array(folder.write("a.mtx", text)), s.size(0), 2);
    });
    ask("write_matrix_market", [&](Inputs&) {
        const test::TemporaryFolder folder;
        const SparseMatrix d = derivative(s.P(), 0);
        write_matrix_market(folder.path("d.mtx"), d);
        return fit(read_matrix_market(folder.path("d.mtx")), s.size(1), s.size(0));
    });
}

void ask_of_engines(const Asking& ask, const Sample& s) {
    const Index size = s.size(0);
    const auto stiffness = [&s] {
        return SparseMatrix(derivative(s.P(), 0).transpose() * derivative(s.P(), 0));
    };

    ask("ConstrainedSolver", [&](Inputs& in) {
        std::vector<bool> fixed = in.list(size, false);
        fixed.front() = true;
        const ConstrainedSolver solver(
            {stiffness(), fixed, in.list(size, false), in.vector(size).cwiseAbs()}, "eigen.ldlt");
        const Vector b = in.vector(size);
        return fit(solver.solve(b, in.vector(size)).values, size);
    });
    ask("LinearSolver", [&](Inputs& in) {
        SparseMatrix A = stiffness();
        const Vector diagonal = in.vector(size).cwiseAbs();
        SparseMatrix more(diagonal.size(), diagonal.size());
        more.setIdentity();
        A.conservativeResize(size, diagonal.size());
        const auto solver = make_linear_solver("eigen.lu");
        solver->factorize(diagonal.size() == size ? SparseMatrix(A + more) : A, {});
        return fit(Vector(solver->solve(in.vector(size))), size);
    });
    ask("CertifiedEigensolver", [&](Inputs& in) {
        CertifiedEigensolver solver(stiffness(), in.vector(size).cwiseAbs());
        return fit(solver.smallest(1).vectors, size, 1);
    });
}

TEST(doors, of_makers_meshes_and_engines_answer_rightly_or_refuse) {
    for (const Sample& s : samples()) {
        const bool all = s.name == "triangles";
        ask_of_meshes({s.name, all}, s);
        ask_of_engines({s.name, all}, s);
        for (int k = 0; k <= s.n(); ++k)
            ask_of_makers({s.name + ", degree " + std::to_string(k), all}, s, k);
    }
}

} // namespace
} // namespace polydec::test
