// SPDX-License-Identifier: MIT
#include "benchmarks/chain.h"

#include "dec/forms/laplacian.h"
#include "dec/forms/star.h"
#include "dec/metric/circumcentric_volumes.h"

namespace polydec::benchmarks {

namespace {

const LazyMesh* in_memory = nullptr;

} // namespace

Operators all_operators(const CellComplex& complex, const CellVolumes& volumes) {
    Operators result;
    for (int k = 0; k <= complex.dimension(); ++k)
        result.stars.push_back(star(volumes, k).diagonal());
    result.laplacian = symmetric_laplacian(complex, volumes, 0);
    return result;
}

double bytes(const Operators& operators) {
    return bytes(operators.stars) + bytes(operators.laplacian);
}

Chain chain(const Mesh& mesh) {
    SimplicialComplex complex(mesh.simplices);
    CellVolumes volumes = circumcentric_volumes(complex, mesh.points);
    Operators operators = all_operators(complex, volumes);
    return {std::move(complex), std::move(volumes), std::move(operators)};
}

const Mesh& LazyMesh::get() const {
    if (in_memory && in_memory != this)
        in_memory->drop();
    in_memory = this;
    if (!mesh_)
        mesh_ = std::make_unique<const Mesh>(make_());
    return *mesh_;
}

Amount LazyMesh::amount() const {
    return {static_cast<double>(get().simplices.rows()), bytes(get())};
}

SharedMesh shared_mesh(std::function<Mesh()> make) {
    return std::make_shared<const LazyMesh>(std::move(make));
}

} // namespace polydec::benchmarks
