// SPDX-License-Identifier: MIT
#include "dec/boundary/form_space.h"
#include "dec/discretization/diagnosis.h"
#include "dec/discretization/mesh_warnings.h"
#include "dec/merging/facet_defects.h"
#include "dec/stars/star.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace polydec {

namespace {

/// Defects that make operators ill defined, by degree of cells.
struct Faults {
    std::vector<Index> without_dual; ///< cells whose dual has zero volume
    std::vector<Index> copies;       ///< cells whose dual coincides with another cell's
};

std::string cells_with(std::size_t count, int k) {
    return fmt::format("{} {}-cell{}", count, k, count == 1 ? " has" : "s have");
}

Index count(const std::vector<bool>& marks) {
    return static_cast<Index>(std::count(marks.begin(), marks.end(), true));
}

/// Data for a verdict: pieces, what becomes of them, and the cells whose duals count; at the input
/// stage these are the pieces.
struct View {
    Merging merging;
    CellVolumes volumes;         ///< of the cells
    DegenerateFacets degenerate; ///< of the pieces
    bool of_pieces;

    Index size(int k) const { return static_cast<Index>(volumes.primal(k).size()); }
};

View view(const Discretization& mesh, Stage stage) {
    const bool input = stage == Stage::input;
    if (!input || mesh.passage().is_identity())
        return {mesh.merging(), input ? mesh.geometry().volumes() : mesh.volumes(),
                mesh.degenerate(), input};
    const Geometry& given = mesh.input_geometry();
    const Geometry by_lengths(given.pieces(), {given.pieces(), given.volumes().primal(1)},
                              given.volumes());
    return {Merging(given.pieces()), given.volumes(),
            facet_defects(by_lengths, mesh.options()).degenerate, true};
}

/// The k-cells whose dual has zero volume.
Index without_dual(const View& view, int k) {
    const auto& carriers = view.merging.carriers(k);
    std::vector<bool> marks(static_cast<std::size_t>(view.size(k)), false);
    for (const Index s : star(view.volumes, k).zeros())
        marks[s] = true;
    const bool facets = k == view.merging.merged().dimension() - 1;
    for (std::size_t s = 0; s < carriers.size(); ++s) {
        const bool removed = carriers[s].dimension > k;
        if (view.of_pieces && (removed || (facets && view.degenerate[s])))
            marks[s] = true;
        if (!view.of_pieces && !removed && facets && view.degenerate[s])
            marks[carriers[s].cell] = true;
    }
    return count(marks);
}

/// Marks the n-cells that share a circumcenter with a neighbor across a degenerate facet.
void mark_concentric(const View& view, std::vector<bool>& marks) {
    const Pieces& pieces = view.merging.pieces();
    const int n = pieces.dimension();
    const Cofaces cofaces(pieces, n);
    for (Index f = 0; f < pieces.size(n - 1); ++f) {
        if (!view.degenerate[f] || cofaces.of(f).size() != 2)
            continue;
        if (!view.of_pieces && view.merging.carriers(n - 1)[f].dimension == n)
            continue;
        for (const Coface& t : cofaces.of(f))
            marks[view.of_pieces ? t.cell : view.merging.carriers(n)[t.cell].cell] = true;
    }
}

/// The k-cells whose dual coincides with another cell's: pieces of one merged cell.
Index copies(const View& view, int k) {
    std::vector<bool> marks(static_cast<std::size_t>(view.size(k)), false);
    for (Index cell = 0; view.of_pieces && cell < view.merging.merged().size(k); ++cell)
        if (const auto pieces = view.merging.pieces_of(k, cell); pieces.size() > 1)
            for (const Index piece : pieces)
                marks[piece] = true;
    if (k == view.merging.merged().dimension())
        mark_concentric(view, marks);
    return count(marks);
}

Faults find_faults(const View& view) {
    Faults faults;
    for (int k = 0; k <= view.merging.merged().dimension(); ++k) {
        faults.without_dual.push_back(without_dual(view, k));
        faults.copies.push_back(copies(view, k));
    }
    return faults;
}

/// For chosen stars: they are not duals, so there are no copies.
Faults find_faults(const HodgeStars& stars) {
    Faults faults;
    for (int k = 0; k <= stars.dimension(); ++k)
        faults.without_dual.push_back(static_cast<Index>(stars[k].zeros().size()));
    faults.copies.assign(faults.without_dual.size(), 0);
    return faults;
}

/// Collects verdicts: an operator is as good as its stars.
class Table {
public:
    explicit Table(Faults faults) : faults_(std::move(faults)) {}

    /// Stars are applied to primal forms of some degrees, and inverted in others.
    void add(std::string name, int degree, Side side, const std::vector<int>& stars,
             const std::vector<int>& inverses) {
        OperatorVerdict verdict{std::move(name), degree, side};
        for (const int k : stars)
            if (verdict.verdict == WellDefined::yes && has(faults_.copies, k))
                verdict = spoiled(verdict, WellDefined::restricted, k, faults_.copies[k]);
        for (const int k : inverses)
            if (verdict.verdict != WellDefined::no && has(faults_.without_dual, k))
                verdict = spoiled(verdict, WellDefined::no, k, faults_.without_dual[k]);
        verdicts_.push_back(std::move(verdict));
    }

    void judge_by(Faults faults) { faults_ = std::move(faults); }

    std::vector<OperatorVerdict> take() { return std::move(verdicts_); }

private:
    static bool has(const std::vector<Index>& cells, int k) {
        return k >= 0 && k < static_cast<int>(cells.size()) && cells[k] > 0;
    }

    static OperatorVerdict spoiled(OperatorVerdict verdict, WellDefined how, int k, Index cells) {
        verdict.verdict = how;
        verdict.cell_degree = k;
        verdict.cells = cells;
        return verdict;
    }

    Faults faults_;
    std::vector<OperatorVerdict> verdicts_;
};

} // namespace

std::vector<OperatorVerdict> operator_verdicts(const Discretization& discretization, Stage stage) {
    const int n = discretization.dimension();
    const Faults of_duals = find_faults(view(discretization, stage));
    const bool by_duals =
        stage == Stage::input || discretization.chosen_stars().kind == StarKind::circumcentric;
    Table table(by_duals ? of_duals : find_faults(discretization.stars()));
    for (int k = 0; k < n; ++k) {
        table.add("d", k, Side::primal, {}, {});
        table.add("d", k, Side::dual, {}, {});
    }
    for (int k = 0; k <= n; ++k) {
        table.add("star", k, Side::primal, {k}, {});
        table.add("star", k, Side::dual, {}, {k});
    }
    for (int k = 1; k <= n; ++k) {
        table.add("codifferential", k, Side::primal, {k}, {k - 1});
        table.add("codifferential", k, Side::dual, {n - k + 1}, {n - k});
    }
    for (int k = 0; k <= n; ++k)
        for (const Side side : {Side::primal, Side::dual}) {
            // the Laplacian inverts the star of its own cells only if there is a degree above
            const int cells = side == Side::primal ? k : n - k;
            const int own = cells < n ? cells : -1;
            table.add("laplacian", k, side, {cells > 0 ? cells : -1, cells + 1}, {cells - 1, own});
        }
    table.judge_by(of_duals);
    table.add("wedge", 1, Side::primal, {}, {});
    table.add("flat ppp", 1, Side::primal, {}, {});
    table.add("flat pdp", 1, Side::primal, {}, {});
    table.add("flat dpp", 1, Side::dual, {}, {1});
    table.add("flat ppd", 1, Side::primal, {}, {});
    table.add("flat pdd", 1, Side::primal, {}, {});
    table.add("flat dpd", 1, Side::dual, {}, {});
    table.add("sharp pp", 1, Side::primal, {}, {0});
    table.add("sharp pd", 1, Side::primal, {}, {});
    return table.take();
}

std::string reason(const OperatorVerdict& verdict) {
    if (verdict.verdict == WellDefined::yes)
        return "";
    const auto cells = fmt::format("{} of the {}-cells {}", verdict.cells, verdict.cell_degree,
                                   verdict.cells == 1 ? "has" : "have");
    return verdict.verdict == WellDefined::no
               ? fmt::format("it divides by dual volumes, and {} a dual without volume", cells)
               : fmt::format("{} the same dual as another", cells);
}

std::vector<SpectrumVerdict> spectrum_verdicts(const HodgeStars& stars) {
    const int n = stars.dimension();
    std::vector<std::size_t> zero, negative;
    for (int k = 0; k <= n; ++k) {
        zero.push_back(stars[k].zeros().size());
        negative.push_back(stars[k].negatives().size());
    }
    std::vector<SpectrumVerdict> verdicts;
    for (int k = 0; k <= n; ++k) {
        SpectrumVerdict verdict{k};
        const std::size_t spurious = k == 0 ? 0 : negative[k - 1] + (k < n ? negative[k + 1] : 0);
        const bool empty = stars[k].size() == 0;
        verdict.exists = !empty && zero[k] == 0 && negative[k] == 0 && (k == 0 || zero[k - 1] == 0);
        if (empty)
            verdict.reason =
                fmt::format("no {}-cell has a free value: the conditions give all values", k);
        else if (negative[k] > 0)
            verdict.reason = fmt::format("the mass is not positive: {} a negative dual",
                                         cells_with(negative[k], k));
        else if (zero[k] > 0)
            verdict.reason = fmt::format("the mass is not positive: {} a dual without volume",
                                         cells_with(zero[k], k));
        else if (!verdict.exists)
            verdict.reason =
                fmt::format("an inverse star divides by zero: {} a dual without volume",
                            cells_with(zero[k - 1], k - 1));
        else if (spurious > 0)
            verdict.reason =
                spurious == 1
                    ? "1 negative dual causes about one spurious negative eigenvalue"
                    : fmt::format(
                          "{} negative duals cause about as many spurious negative eigenvalues",
                          spurious);
        verdicts.push_back(std::move(verdict));
    }
    return verdicts;
}

std::vector<SpectrumVerdict> spectrum_verdicts(const Discretization& discretization, Side side) {
    const int n = discretization.dimension();
    const auto judged = [&](int degree) {
        return spectrum_verdicts(FormSpace(discretization, side, degree).inside().stars());
    };
    auto verdicts = judged(side == Side::primal ? 0 : n);
    if (side == Side::primal)
        verdicts[n] = judged(n)[n];
    const auto branching = branching_facets(discretization.complex());
    if (side == Side::dual && branching > 0)
        verdicts[n] = {
            n, false,
            fmt::format("three or more cells meet at {}, so dual 0-forms have no "
                        "differences there",
                        branching == 1 ? "1 facet" : fmt::format("{} facets", branching))};
    return verdicts;
}

} // namespace polydec
