// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"
#include "dec/merging/facet_kinds.h"
#include "dec/well_defined.h"
#include "tools/answer.h"

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace polydec::tools {

/// A number for the input complex and one for the merged.
template <class Value>
struct BeforeAndAfter {
    Value input = {};
    Value merged = {};
};

/// The entries of a Hodge star; none that are no numbers in the units of the file.
struct StarNumbers {
    std::optional<double> min, max, min_abs;
    std::size_t negative = 0, zero = 0;
    std::optional<double> condition; ///< as a diagonal matrix; none if an entry is zero
};

/// What intrinsic flips have done.
struct FlipNumbers {
    IntrinsicStatistics statistics;
    std::vector<Index> cells; ///< of the flipped triangulation
};

/// The verdicts on one operator, on primal and on dual forms; for some there is only one of them.
struct OperatorFacts {
    using Sides = std::array<std::optional<OperatorVerdict>, 2>;
    std::string name;
    int degree = 0;
    BeforeAndAfter<Sides> sides;
};

/// What can be done with the Laplacian of primal k-forms and dual (n-k)-forms, which live on the
/// same cells, after merging.
struct LaplacianFacts {
    int degree = 0;                              ///< k
    WellDefined before = WellDefined::yes;       ///< on the input complex
    WellDefined matrix = WellDefined::yes;       ///< whether the operator itself makes sense
    std::string matrix_reason = {};              ///< for what is not yes; or empty
    std::array<SpectrumVerdict, 2> spectra = {}; ///< of primal and of dual forms

    /// Of the spectrum, or else of the matrix.
    const std::string& reason(Side side) const {
        const auto& own = spectra[side == Side::primal ? 0 : 1].reason;
        return own.empty() ? matrix_reason : own;
    }
};

/// What `polydec info` tells of a mesh.
struct MeshFacts {
    int dimension = 0;
    std::optional<int> ambient_dimension; ///< none if only lengths are known
    BeforeAndAfter<std::vector<Index>> cells;
    BeforeAndAfter<Index> euler;
    BeforeAndAfter<std::vector<Index>> betti;
    Index components = 0, boundary_components = 0;
    bool orientable = true;
    std::optional<double> volume; ///< none if it is no number in the units of the file
    DegenerateFacets facets;
    std::optional<FlipNumbers> flips; ///< of those, or else
    FacetKinds pairs;
    std::vector<StarNumbers> stars, input_stars; ///< by degree, after merging and before
    std::vector<OperatorFacts> operators;
    std::vector<LaplacianFacts> laplacians;         ///< by degree
    std::map<std::size_t, Index> vertices_per_cell; ///< how many merged n-cells have that many
    std::optional<MergedPairs> concyclic;           ///< of a surface
    std::vector<std::string> advice;

    /// Whether numbers are left out that double precision does not have.
    bool lacks_numbers() const;
};

/// Measures all of that.
MeshFacts examine(const Discretization& mesh, Timing& timing);

} // namespace polydec::tools
