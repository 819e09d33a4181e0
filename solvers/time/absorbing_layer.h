// SPDX-License-Identifier: MIT
#pragma once

#include "dec/boundary/form_space.h"
#include "dec/discretization/discretization.h"

#include <array>
#include <vector>

namespace polydec {

/// The method that absorbs waves.
enum class LayerKind {
    stretched,  ///< perfectly matched: coordinates are stretched into the complex plane, for waves
                ///< of every direction; cells in the layer must be parallel to the axes
    conducting, ///< E and B decay at the same rate, matched at normal incidence; any cells
    automatic,  ///< stretched where the cells allow it
};

/// "stretched", "conducting" or "automatic".
const char* name(LayerKind kind);

/// A layer along the sides of the bounding box in which outgoing waves decay before they reach the
/// boundary and reflect. The wave speed there is taken to be 1.
struct AbsorbingLayer {
    Discretization mesh; ///< carries the waves; with points
    double width;        ///< of the layer, in units of length
    LayerKind kind = LayerKind::automatic;
    /// The low and the high side of each coordinate; empty: all sides.
    std::vector<std::array<bool, 2>> sides = {};
    double reflection = 1e-6; ///< at normal incidence, in the limit of infinitely small cells
    double power = 3;         ///< exponent of the depth in the rate of decay
};

/// The convolution terms of d or its transpose in a layer with stretched coordinates. Each
/// derivative in a direction a is divided by 1 + rate_a / (i omega), which in time is a convolution
/// with exp(-rate_a t). Source: Roden, Gedney 2000.
class LayerMemory {
public:
    LayerMemory() = default;

    /// `parts` has a row for each pair of a layer cell and a direction: the part of d that
    /// differentiates in it. `cells` are the cells of the rows; `decays` are the factors per step.
    LayerMemory(SparseMatrix parts, std::vector<Index> cells, Vector decays)
        : parts_(std::move(parts)), cells_(std::move(cells)), decays_(std::move(decays)) {}

    bool is_empty() const { return cells_.empty(); }

    /// The memory before the first step: zeros.
    Vector at_start() const { return Vector::Zero(decays_.size()); }

    /// Advances the memory by a step with these values, and adds its terms to their derivative.
    void add(const Vector& values, Vector& memory, Vector& derivative) const;

private:
    SparseMatrix parts_;
    std::vector<Index> cells_;
    Vector decays_;
};

/// The memory terms of a leapfrog step in a layer with stretched coordinates, and the rates of
/// decay in a conducting one.
struct LayerParts {
    LayerKind kind = LayerKind::stretched;
    LayerMemory of_E, of_B; ///< added to the rates of E and of B
    Vector E_loss, B_loss;
};

/// For waves with E on the free e_degree-cells of a space and B on the b_degree-cells. d maps
/// values of E to values of B; the step is in the unit of the mesh. Throws InvalidInput for an
/// invalid width, reflection, power or list of sides; for a mesh without coordinates or of other
/// cells; and, naming the cell, for stretched coordinates if a cell in the layer is not parallel to
/// the axes.
LayerParts layer_parts(const AbsorbingLayer& layer, const FormSpace& space, const SparseMatrix& d,
                       int e_degree, int b_degree, double time_step);

} // namespace polydec
