// SPDX-License-Identifier: MIT
#pragma once

#include "polydec.h"

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace polydec::test {

/// Everything a function may ask for, of one mesh.
struct Sample {
    std::string name;
    Discretization mesh;

    explicit Sample(std::string title, const Mesh& input)
        : name(std::move(title)), mesh(discretize(input)) {}

    int n() const { return mesh.dimension(); }
    const SimplicialComplex& K() const { return mesh.input(); }
    const CellComplex& P() const { return mesh.complex(); }
    const CellVolumes& V() const { return mesh.volumes(); }
    const CellVolumes& W() const { return mesh.input_volumes(); }
};

inline const std::vector<Sample>& samples() {
    static const std::vector<Sample> all = [] {
        std::vector<Sample> made;
        made.emplace_back("an interval", kuhn(1, 3));
        made.emplace_back("a merged square", kuhn(2, 2));
        made.emplace_back("a merged cube", kuhn(3, 2));
        made.emplace_back("triangles", well_centered(3));
        made.emplace_back("a sphere", icosphere(2));
        made.emplace_back("four dimensions", kuhn(4, 1));
        return made;
    }();
    return all;
}

inline const Discretization& flipped() {
    static const Discretization mesh = discretize(icosphere(2), {.delaunay = Delaunay::flips});
    return mesh;
}

/// A form of one value for each cell that would carry it.
inline Cochain form(const Sample& s, Side side, int degree) {
    return {side, degree, Vector::Ones(s.P().size(side == Side::primal ? degree : s.n() - degree))};
}

/// What comes of a call: `refused` with InvalidInput, `accepted`, or another error.
inline std::string outcome(const std::function<void()>& call) {
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

} // namespace polydec::test
