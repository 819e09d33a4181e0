// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization/discretization.h"

#include <utility>

namespace polydec::test {

/// The mesh with circumcentric stars, where they are positive and where they are not.
template <class AnyMesh>
Discretization circumcentric(AnyMesh mesh, DiscretizeOptions options = {}) {
    options.star = StarKind::circumcentric;
    return discretize(std::move(mesh), options);
}

} // namespace polydec::test
