// SPDX-License-Identifier: MIT
#include "complex/homology.h"
#include "complex/merging.h"
#include "complex/relative.h"
#include "complex/simplicial_complex.h"
#include "complex/surfaces/ordered_surface.h"
#include "tests/fuzz/decoder.h"
#include "tests/fuzz/laws.h"
#include "tests/fuzz/targets.h"

#include <optional>

namespace polydec::fuzz {

namespace {

SparseMatrix real(const IncidenceMatrix& incidences) {
    return incidences.cast<double>();
}

bool is_zero(const SparseMatrix& matrix) {
    return matrix.coeffs().size() == 0 || matrix.coeffs().abs().maxCoeff() == 0;
}

void require_cycles(const SimplicialComplex& complex) {
    const auto betti = betti_numbers(complex);
    for (int k = 0; k <= complex.dimension(); ++k) {
        SparseMatrix generators;
        if (!accepts([&] { generators = homology_generators(complex, k); }))
            continue;
        require(generators.cols() == betti[k], "there are as many generators as the Betti number");
        const SparseMatrix ends = real(complex.boundary(k)) * generators;
        require(is_zero(ends), "generators are cycles");
    }
}

} // namespace

void require_topology(const CellComplex& complex) {
    for (int k = 0; k + 1 < complex.dimension(); ++k) {
        const SparseMatrix square = real(complex.coboundary(k + 1)) * real(complex.coboundary(k));
        require(is_zero(square), "d d = 0");
    }
    const auto betti = betti_numbers(complex);
    Index sum = 0;
    for (std::size_t k = 0; k < betti.size(); ++k) {
        require(betti[k] >= 0, "Betti numbers count");
        sum += k % 2 == 0 ? betti[k] : -betti[k];
    }
    require(sum == euler_characteristic(complex), "Betti numbers add up to Euler's");
}

/// Dimension and simplices.
void complex(std::string_view bytes) {
    Decoder decoder(bytes);
    const int n = 1 + decoder.below(5);
    constexpr int vertices = 12;
    const Simplices tops = decoder.simplices(n + 1, vertices);
    std::optional<SimplicialComplex> complex;
    if (!accepts([&] { complex.emplace(tops); }))
        return;
    require_topology(*complex);
    require_cycles(*complex);
    require_topology(relative_to_boundary(*complex).complex);
    require_topology(Merging(*complex).merged());
    accepts([&] {
        const GluedSurface surface(*complex);
        const Pieces cells = in_order(surface, std::vector<Index>(surface.vertices())).pieces;
        require_topology(cells);
        require(betti_numbers(cells) == betti_numbers(*complex), "gluing keeps the topology");
    });
}

} // namespace polydec::fuzz
