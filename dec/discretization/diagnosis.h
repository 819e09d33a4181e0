// SPDX-License-Identifier: MIT
#pragma once

#include "base/progress.h"
#include "dec/discretization/advice.h"
#include "dec/discretization/discretization.h"
#include "dec/forms/cochain.h"
#include "dec/merging/merge.h"
#include "dec/surfaces/intrinsic_delaunay.h"
#include "meshes/weld.h"

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace polydec {

/// Whether an operator is well defined on a mesh.
enum class WellDefined {
    yes,
    restricted, ///< only on forms with one density on all pieces of a cell (Schier, Eq. 4)
    no,         ///< it divides by duals of zero volume
};

inline const char* name(WellDefined verdict) {
    return verdict == WellDefined::yes ? "yes" : verdict == WellDefined::no ? "no" : "restricted";
}

/// The verdict on one operator, as in Table 1 of Schier's paper for triangle meshes.
struct OperatorVerdict {
    std::string name = {};    ///< d, star, codifferential, laplacian, wedge, flat ppp, sharp pp ..
    int degree = 0;           ///< of the forms it takes; for a star, of the primal cells
    Side side = Side::primal; ///< of the forms it takes (sharp: of the form; flat: of the field)
    WellDefined verdict = WellDefined::yes;
    int cell_degree = -1; ///< of the cells that make it ill defined; -1 if none do
    Index cells = 0;      ///< number of such cells
};

/// Reason for a verdict other than yes: "24 of the 2-cells have a dual without extent, by which it
/// divides"; empty for yes.
std::string reason(const OperatorVerdict& verdict);

/// Whether the Laplacian has a spectrum on the forms that live on cells of one degree.
struct SpectrumVerdict {
    int cell_degree = 0;     ///< k: primal k-forms and dual (n-k)-forms
    bool exists = true;      ///< whether there is a norm and no division by zero
    std::string reason = {}; ///< why not, or a reservation; empty if there is nothing to say
};

/// The complex that a verdict applies to.
enum class Stage { input, merged };

/// Verdicts on all operators, in the order of Table 1, from the duals of this mesh, not from
/// theory. A dual has zero volume if merging removed its cell, if its facet is degenerate within
/// the tolerance, or if the star entry is zero in the sense of HodgeStar::zeros. With other stars,
/// operators built from them are judged by the zeros of these stars. Flats and sharps, and
/// everything on the input, are always judged by duals.
std::vector<OperatorVerdict> operator_verdicts(const Discretization& discretization, Stage stage);

/// One verdict per degree 0..n of cells, by the same zeros as the stars and the solvers. A
/// Laplacian may be well defined without a spectrum: a negative dual leaves no norm.
std::vector<SpectrumVerdict> spectrum_verdicts(const HodgeStars& stars);

/// The same for forms of one side under the default conditions, on the cells and volumes that
/// spectrum() uses. So boundary facets without dual do no harm to dual 0-forms.
std::vector<SpectrumVerdict> spectrum_verdicts(const Discretization& discretization, Side side);

/// A value for the given simplices and one for the merged cells.
template <class Value>
struct BeforeAndAfter {
    Value input = {};
    Value merged = {};
};

/// Diagonal of a Hodge star in the units of the input, as far as doubles represent it there.
struct StarNumbers {
    bool is_diagonal = true; ///< false: a matrix with off-diagonal entries
    std::optional<double> min, max, min_abs;
    std::size_t negative = 0, zero = 0;
    std::optional<double> condition; ///< of a diagonal; empty if an entry is zero
};

/// Statistics of flips and splits; added_length is in the units of the input.
struct FlipNumbers {
    IntrinsicStatistics statistics;
    std::vector<Index> cells; ///< number of cells of the flipped triangulation, by degree
};

/// Verdict on the Laplacian of primal k-forms and dual (n-k)-forms, which live on the same cells,
/// after merging.
struct LaplacianVerdict {
    int degree = 0;                              ///< k
    WellDefined before = WellDefined::yes;       ///< on the input
    WellDefined matrix = WellDefined::yes;       ///< whether the operator itself is well defined
    std::string matrix_reason = {};              ///< why it is not; empty if it is
    std::array<SpectrumVerdict, 2> spectra = {}; ///< of primal and of dual forms

    const SpectrumVerdict& spectrum(Side side) const {
        return spectra[side == Side::primal ? 0 : 1];
    }

    /// Reason for the verdict on the spectrum, or if that is empty, on the matrix.
    const std::string& reason(Side side) const {
        return spectrum(side).reason.empty() ? matrix_reason : spectrum(side).reason;
    }
};

/// What a mesh is, which operators are well defined on it, and what would help.
struct Diagnosis {
    int dimension = 0;
    std::optional<int> ambient_dimension; ///< empty if only lengths are known
    BeforeAndAfter<std::vector<Index>> cells, betti;
    BeforeAndAfter<Index> euler;
    Index components = 0, boundary_components = 0;
    bool orientable = true;
    UnjoinedBoundary unjoined; ///< empty where only lengths are known
    std::map<std::size_t, Index>
        vertices_per_cell;        ///< merged n-cells by number of distinct vertices
    std::optional<double> volume; ///< in the units of the input, if a double can hold it
    DegenerateFacets degenerate;
    MergedPairs merged_pairs;
    std::optional<LooserTolerance> looser;          ///< where many more cells would merge
    std::optional<FlipNumbers> flips;               ///< where edges were flipped
    std::optional<FacetKinds> pairs;                ///< where none were
    BeforeAndAfter<std::vector<StarNumbers>> stars; ///< by degree; circumcentric on the input
    BeforeAndAfter<std::vector<OperatorVerdict>> operators;
    std::vector<LaplacianVerdict> laplacians; ///< by degree
    std::vector<Advice> advice;
    std::vector<std::string> warnings; ///< about numbers that double precision cannot hold
};

/// Computes the diagnosis. Calls `stage`, if given, as each stage (topology, operators) begins.
Diagnosis diagnose(const Discretization& discretization, const Progress& stage = {});

} // namespace polydec
