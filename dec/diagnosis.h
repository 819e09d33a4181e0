// SPDX-License-Identifier: MIT
#pragma once

#include "dec/advice.h"
#include "dec/merging/facet_kinds.h"
#include "dec/well_defined.h"
#include "meshes/unjoined_boundary.h"

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace polydec {

/// What holds of the simplices that were given, and of the merged cells.
template <class Value>
struct BeforeAndAfter {
    Value input = {};
    Value merged = {};
};

/// The diagonal of a Hodge star in the units of the input, as far as it has numbers there.
struct StarNumbers {
    bool is_diagonal = true; ///< or else a matrix, which has other entries
    std::optional<double> min, max, min_abs;
    std::size_t negative = 0, zero = 0;
    std::optional<double> condition; ///< of a diagonal; none if an entry is zero
};

/// What flips and splits have done; added_length is in the units of the input.
struct FlipNumbers {
    IntrinsicStatistics statistics;
    std::vector<Index> cells; ///< of the flipped triangulation, by degree
};

/// What can be done with the Laplacian of primal k-forms and dual (n-k)-forms, which live on the
/// same cells, after merging.
struct LaplacianVerdict {
    int degree = 0;                              ///< k
    WellDefined before = WellDefined::yes;       ///< on the input
    WellDefined matrix = WellDefined::yes;       ///< whether the operator itself makes sense
    std::string matrix_reason = {};              ///< for what is not yes; or empty
    std::array<SpectrumVerdict, 2> spectra = {}; ///< of primal and of dual forms

    const SpectrumVerdict& spectrum(Side side) const {
        return spectra[side == Side::primal ? 0 : 1];
    }

    /// Of the spectrum, or else of the matrix.
    const std::string& reason(Side side) const {
        return spectrum(side).reason.empty() ? matrix_reason : spectrum(side).reason;
    }
};

/// What a mesh is, what calculus can do on it, and what would help.
struct Diagnosis {
    int dimension = 0;
    std::optional<int> ambient_dimension; ///< none if only lengths are known
    BeforeAndAfter<std::vector<Index>> cells, betti;
    BeforeAndAfter<Index> euler;
    Index components = 0, boundary_components = 0;
    bool orientable = true;
    UnjoinedBoundary unjoined;                      ///< nothing where only lengths are known
    std::map<std::size_t, Index> vertices_per_cell; ///< how many merged n-cells have that many
    std::optional<double> volume; ///< in the units of the input, if it is a number there
    DegenerateFacets degenerate;
    MergedPairs merged_pairs;
    std::optional<LooserTolerance> looser;          ///< by which many more cells would merge
    std::optional<FlipNumbers> flips;               ///< where edges were flipped,
    std::optional<FacetKinds> pairs;                ///< and else
    BeforeAndAfter<std::vector<StarNumbers>> stars; ///< by degree; circumcentric on the input
    BeforeAndAfter<std::vector<OperatorVerdict>> operators;
    std::vector<LaplacianVerdict> laplacians; ///< by degree
    std::vector<Advice> advice;
    std::vector<std::string> warnings; ///< of numbers that double precision does not have
};

/// Finds all of that. Each stage (topology, operators) is told as it begins, if anyone listens.
Diagnosis diagnose(const Discretization& discretization,
                   const std::function<void(std::string_view)>& stage = {});

} // namespace polydec
