// SPDX-License-Identifier: MIT
#include "tests/io/doors.h"

#include <new>

namespace polydec::test {

namespace {

/// Cells of two materials, and facets of which every third has a tag.
Mesh tagged(Mesh mesh) {
    for (Index row = 0; row < mesh.simplices.rows(); ++row)
        mesh.tags.push_back(1 + row % 2);
    const SimplicialComplex K(mesh.simplices);
    const auto& facets = K.simplices(K.dimension() - 1);
    mesh.facet_tags.simplices.resize((facets.rows() + 2) / 3, facets.cols());
    for (Index row = 0; row < mesh.facet_tags.simplices.rows(); ++row) {
        mesh.facet_tags.simplices.row(row) = facets.row(3 * row);
        mesh.facet_tags.tags.push_back(7);
    }
    return mesh;
}

std::vector<Sample> made() {
    const DiscretizeOptions as_they_are{.criterion = MergeCriterion::none};
    const Mesh skew = perturbed(grid(4, 4), 0.08, 3);
    std::vector<Sample> all;
    all.emplace_back("an interval", kuhn(1, 3));
    all.emplace_back("a merged square", kuhn(2, 2));
    all.emplace_back("a merged cube", kuhn(3, 2));
    all.emplace_back("triangles", well_centered(3));
    all.emplace_back("a sphere", icosphere(2));
    all.emplace_back("four dimensions", kuhn(4, 1));
    all.emplace_back("simplices", skew, as_they_are);
    all.emplace_back("tetrahedra", bcc(1), as_they_are);
    all.emplace_back("isolated vertices", with_isolated_vertices());
    all.emplace_back("lengths", discretize(length_mesh(well_centered(3))));
    all.emplace_back("lengths in space", discretize(length_mesh(kuhn(3, 1))));
    all.emplace_back("tags", tagged(kuhn(2, 3)),
                     DiscretizeOptions{.materials = Materials::keep_apart});
    all.emplace_back("tags in space", tagged(kuhn(3, 1)));
    all.emplace_back("centroids", skew, DiscretizeOptions{.centers = Centers::centroids()});
    all.emplace_back("flipped", skew, DiscretizeOptions{.delaunay = Delaunay::flips});
    all.emplace_back("split", skew, DiscretizeOptions{.delaunay = Delaunay::flips_and_splits});
    all.emplace_back("flipped isolated vertices", perturbed(with_isolated_vertices(), 0.08, 3),
                     DiscretizeOptions{.delaunay = Delaunay::flips_and_splits});
    all.emplace_back("flipped lengths",
                     discretize(length_mesh(skew), {.delaunay = Delaunay::flips_and_splits}));
    return all;
}

} // namespace

const std::vector<Sample>& samples() {
    static const std::vector<Sample> all = made();
    return all;
}

const Sample& sample(const std::string& name) {
    for (const Sample& s : samples())
        if (s.name == name)
            return s;
    throw std::out_of_range(name);
}

std::string outcome(const std::function<void()>& call) {
    try {
        call();
    } catch (const InvalidInput&) {
        return "refused";
    } catch (const Error& error) {
        return std::string("another error: ") + error.what();
    } catch (const std::exception& error) {
        return std::string("a foreign error: ") + error.what();
    }
    return "accepted";
}

Inputs::Flaw Inputs::next(bool may_be_not_finite) {
    const bool here = asked_++ == which_ && (may_be_not_finite || flaw_ != Flaw::not_finite);
    flawed_ = flawed_ || here;
    return here ? flaw_ : Flaw::none;
}

DenseMatrix Inputs::matrix(Eigen::Index rows, Eigen::Index columns) {
    const Flaw flaw = next();
    const bool can_shrink = rows > 1; // no values at all are often allowed, and mean a default
    rows += flaw == Flaw::fewer ? (can_shrink ? -1 : 1) : flaw == Flaw::more;
    columns += flaw == Flaw::wider;
    DenseMatrix result(rows, columns);
    for (Eigen::Index i = 0; i < rows; ++i)
        for (Eigen::Index j = 0; j < columns; ++j)
            result(i, j) = 0.6 + 0.3 * std::sin(1.7 * double(i) + 2.3 * double(j));
    return result;
}

Cochain Inputs::form(const Sample& s, Side side, int degree) {
    return form_on(s.P(), side, degree);
}

Cochain Inputs::form_on(const CellComplex& complex, Side side, int degree) {
    const int given = degree_of(complex.dimension(), degree);
    if (given != degree)
        return {side, given, Vector()};
    const int k = side == Side::primal ? degree : complex.dimension() - degree;
    const bool spoiled = asked_ == which_ && flaw_ == Flaw::not_finite && complex.size(k) > 0;
    Cochain result{side, degree, vector(complex.size(k))};
    if (spoiled)
        result.values[complex.size(k) / 2] = std::nan("");
    flawed_ = flawed_ || spoiled;
    return result;
}

Chain Inputs::chain(const Sample& s, Side side, int degree) {
    const Cochain w = form(s, side, degree);
    return {w.side, w.degree, w.values};
}

int Inputs::degree_of(int n, int k, int least, int beyond) {
    const int most = n + beyond, turn = (n + k) % 3;
    using Numbers = std::numeric_limits<int>;
    switch (next(true)) {
    case Flaw::fewer:
        return least - 1;
    case Flaw::more:
        return most + 1;
    case Flaw::wider:
        return std::array{most + 2, 1000, Numbers::max() / 2}[turn];
    case Flaw::not_finite:
        return std::array{least - 2, -1000, Numbers::min() / 2}[turn];
    default:
        return k;
    }
}

std::string fit(const DenseMatrix& found, Eigen::Index rows, Eigen::Index columns) {
    if (found.rows() != rows || found.cols() != columns)
        return std::to_string(found.rows()) + " x " + std::to_string(found.cols()) +
               " numbers instead of " + std::to_string(rows) + " x " + std::to_string(columns);
    return found.allFinite() ? "" : "a number that is not finite";
}

std::string fit(const SparseMatrix& found, Eigen::Index rows, Eigen::Index columns) {
    return fit(DenseMatrix(found), rows, columns);
}

std::string fit(const Cochain& found, const CellComplex& complex, Side side, int degree) {
    if (found.side != side || found.degree != degree)
        return "a form of another kind";
    return fit(found.values,
               complex.size(side == Side::primal ? degree : complex.dimension() - degree));
}

std::string fit(double found) {
    return std::isfinite(found) ? "" : "a number that is not finite";
}

std::string fit(bool right) {
    return right ? "" : "a wrong answer";
}

std::vector<std::string> complaints(const Question& question, bool is_answered) {
    const auto asked_with = [&](Inputs& in) {
        std::string flaw;
        const auto how = outcome([&] { flaw = question(in); });
        return flaw.empty() ? how : flaw;
    };
    std::vector<std::string> all;
    Inputs right;
    const auto answer = asked_with(right);
    if (answer != "accepted" && (answer != "refused" || is_answered))
        all.push_back(answer);
    for (const auto flaw :
         {Inputs::Flaw::fewer, Inputs::Flaw::more, Inputs::Flaw::wider, Inputs::Flaw::not_finite})
        for (int which = 0;; ++which) {
            Inputs wrong(which, flaw);
            const auto found = asked_with(wrong);
            if (!wrong.asked())
                break;
            if (wrong.flawed() && found != "refused")
                all.push_back("input " + std::to_string(which) + " with flaw " +
                              std::to_string(int(flaw)) + ": " + found);
        }
    return all;
}

void Asking::operator()(const char* name, const Question& question) const {
    EXPECT_EQ(complaints(question, all_answered), std::vector<std::string>{})
        << name << " on " << where;
}

TEST(doors, that_answer_wrongly_or_do_not_look_are_found) {
    const Sample& s = sample("triangles");
    const auto twin = [](auto ask) { return complaints(ask, true); };
    EXPECT_EQ(twin([&](Inputs& in) {
                  return fit(d(s.P(), in.form(s, Side::primal, 0)), s.P(), Side::primal, 1);
              }),
              std::vector<std::string>{});
    EXPECT_EQ(twin([](Inputs&) { return fit(std::sqrt(-1.0)); }).size(), 1);
    EXPECT_EQ(twin([](Inputs&) { return fit(Vector::Ones(2), 3); }).size(), 1);
    EXPECT_EQ(twin([](Inputs&) -> std::string { throw InvalidInput("always"); }).size(), 1);
    EXPECT_EQ(twin([](Inputs&) -> std::string { throw std::bad_alloc(); }).size(), 1);
    EXPECT_EQ(twin([](Inputs& in) { return fit(in.vector(3).sum()); }),
              (std::vector<std::string>{"input 0 with flaw 1: accepted",
                                        "input 0 with flaw 2: accepted"}));
    EXPECT_EQ(twin([&](Inputs& in) {
                  const auto w = in.form(s, Side::primal, 0);
                  return fit(w.values.size() == s.size(0) && w.values.size() > 0 ? 1.0 : NAN);
              }).back(),
              "input 1 with flaw 4: accepted");
}

} // namespace polydec::test
