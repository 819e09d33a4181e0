// SPDX-License-Identifier: MIT
#pragma once

#include "dec/advice.h"
#include "dec/diagnosis/well_defined.h"
#include "dec/merging/facet_kinds.h"
#include "dec/surfaces/intrinsic_delaunay.h"
#include "meshes/unjoined_boundary.h"

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace polydec {

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
    UnjoinedBoundary unjoined;                      ///< empty where only lengths are known
    std::map<std::size_t, Index> vertices_per_cell; ///< merged n-cells by number of vertices
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
Diagnosis diagnose(const Discretization& discretization,
                   const std::function<void(std::string_view)>& stage = {});

} // namespace polydec
