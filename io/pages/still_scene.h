// SPDX-License-Identifier: MIT
#pragma once

#include "io/pages/page_content.h"
#include "io/pictures/color_map.h"

#include <optional>
#include <string>
#include <vector>

namespace polydec {

/// What a still picture shows of a page at one step: the triangles of the surface, or the lines of
/// curves, with values at their corners.
struct StillScene {
    std::vector<double> values;      ///< for each corner; empty: no colors
    std::vector<double> side_values; ///< for each side of the triangles, NaN: none; or empty
    Points sites, vectors;           ///< of arrows, three coordinates each
    std::string time;                ///< or empty
};

/// The scenes of a page, with what all its steps have in common.
class StillScenes {
public:
    /// Throws InvalidInput if the page has no lines or faces. The content must outlive this object.
    explicit StillScenes(const PageContent& content);

    const SolidView& view() const { return content_.opening.view; }
    StillScene at(std::size_t step) const;

    const Page& page() const { return content_.page; }
    const Points& points() const { return content_.points; } ///< three coordinates each
    bool is_curve() const { return visible_.dimension < 2; } ///< lines, not triangles
    const std::vector<Index>& corners() const {
        return is_curve() ? visible_.lines : visible_.corners;
    }
    const std::vector<Index>& sides() const { return visible_.sides; } ///< as in PageFaces
    Index cells() const { return cells_; }                             ///< of largest dimension

    /// The colors over all steps, if there are values.
    const std::optional<ColorRange>& range() const { return range_; }
    std::string name() const;
    const std::string& about() const { return shown_.field->array->about; }

private:
    Points vectors_at(std::size_t step) const;
    std::vector<double> values_at(std::size_t step) const;
    void add_arrows(StillScene& scene, std::size_t step) const;

    const PageContent& content_;
    const ShownField& shown_;
    PageFaces visible_;
    Index cells_;
    std::optional<ColorRange> range_;
};

} // namespace polydec
