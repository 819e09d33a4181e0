// SPDX-License-Identifier: MIT
#pragma once

#include "benchmarks/bytes.h"
#include "benchmarks/measure.h"

#include <functional>
#include <memory>
#include <vector>

namespace polydec::benchmarks {

/// The operators of a complex beside its d_k, which the complex itself holds.
struct Operators {
    std::vector<Vector> stars; ///< star_0 .. star_n
    SparseMatrix laplacian;    ///< of 0-forms, symmetric
};

Operators all_operators(const CellComplex& complex, const CellVolumes& volumes);
double bytes(const Operators& operators);

/// From points and top simplices to all operators: d_k in the complex, volumes, the others.
struct Chain {
    SimplicialComplex complex;
    CellVolumes volumes;
    Operators operators;
};

Chain chain(const Mesh& mesh);

inline double bytes(const Chain& chain) {
    return bytes(chain.complex) + bytes(chain.volumes) + bytes(chain.operators);
}

/// A mesh that is made when it is first asked for.
class LazyMesh {
public:
    explicit LazyMesh(std::function<Mesh()> make) : make_(std::move(make)) {}

    const Mesh& get() const;
    Amount amount() const; ///< its cells, and the bytes of points and cells
    void drop() const { mesh_.reset(); }

private:
    std::function<Mesh()> make_;
    mutable std::unique_ptr<const Mesh> mesh_;
};

using SharedMesh = std::shared_ptr<const LazyMesh>;

/// A mesh for several rows, kept until another one is asked for, so that only one is in memory.
SharedMesh shared_mesh(std::function<Mesh()> make);

} // namespace polydec::benchmarks
