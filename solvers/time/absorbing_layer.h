// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"
#include "dec/form_space.h"

#include <array>
#include <vector>

namespace polydec {

/// How a layer swallows waves.
enum class LayerKind {
    stretched,  ///< perfectly matched: coordinates are stretched into the complex plane, for waves
                ///< of every direction; the cells in the layer must be parallel to the axes
    conducting, ///< E and B decay at the same rate, matched for waves that come straight; any cells
    automatic,  ///< stretched where the cells allow it
};

/// "stretched", "conducting" or "automatic".
const char* name(LayerKind kind);

/// A layer along the sides of the box around a mesh in which outgoing waves die away before they
/// reach the boundary and come back. Waves are taken to have the speed 1 there.
struct AbsorbingLayer {
    Discretization mesh; ///< whose cells waves are on, with points
    double width;        ///< of the layer, in units of length
    LayerKind kind = LayerKind::automatic;
    /// Along which sides: the low and the high one of each coordinate; empty: all.
    std::vector<std::array<bool, 2>> sides = {};
    double reflection = 1e-6; ///< of a wave that comes straight, if cells were infinitely small
    double power = 3;         ///< of the depth, with which the rate of decay grows
};

/// What d or its transpose takes from values in a layer whose coordinates are stretched, and what
/// the past adds: each derivative in a direction a is divided by 1 + rate_a / (i omega), which in
/// time is a convolution with exp(-rate_a t). Source: Roden, Gedney 2000.
class LayerMemory {
public:
    LayerMemory() = default;

    /// parts has a row for each pair of a cell of the layer and a direction: the part of d that
    /// differentiates in it; cells are those of the rows, decays what is left of them after a step.
    LayerMemory(SparseMatrix parts, std::vector<Index> cells, Vector decays)
        : parts_(std::move(parts)), cells_(std::move(cells)), decays_(std::move(decays)) {}

    bool is_empty() const { return cells_.empty(); }

    /// Goes on by a step with these values, and adds what it says to their derivative.
    void add(const Vector& values, Vector& memory, Vector& derivative) const;

private:
    SparseMatrix parts_;
    std::vector<Index> cells_;
    Vector decays_;
};

/// The two derivatives of a leapfrog step in a layer of stretched coordinates, and the rates of
/// decay in a conducting one.
struct LayerParts {
    LayerKind kind = LayerKind::stretched;
    LayerMemory of_E, of_B; ///< what is added to the rates of E and of B
    Vector E_loss, B_loss;
};

/// Of waves with E on the free e_degree-cells of a space and B on the b_degree-cells, on which d
/// takes the values of E to those of B; the step in the unit of the mesh. Throws InvalidInput for a
/// width, reflection, power or sides that make no layer, for a mesh without coordinates or of other
/// cells, and, naming the cell, for stretched coordinates if one in the layer is not parallel to
/// the axes.
LayerParts layer_parts(const AbsorbingLayer& layer, const FormSpace& space, const SparseMatrix& d,
                       int e_degree, int b_degree, double time_step);

} // namespace polydec
