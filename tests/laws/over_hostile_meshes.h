// SPDX-License-Identifier: MIT
#pragma once

#include "tests/support/hostile.h"
#include "tests/support/test.h"

#include <rapidcheck.h>

namespace polydec::test {

/// What accepting a mesh leads to; none if it is refused with a reason. Every other way out, an
/// error of another kind among them, is a failure.
template <std::invocable Make>
auto unless_refused(Make make) -> std::optional<decltype(make())> {
    try {
        return make();
    } catch (const InvalidInput& refusal) {
        RC_ASSERT(std::string(refusal.what()).size() > 10U);
        RC_ASSERT(std::string(refusal.what()).size() < 1000U);
        return std::nullopt;
    } catch (const SolverFailure& refusal) {
        RC_ASSERT(std::string(refusal.what()).size() > 10U);
        return std::nullopt;
    }
}

/// Whether the law holds for random hostile meshes; tells the simplest counterexample if not. The
/// environment variable RC_PARAMS="max_success=1000000" asks for more of them than a hundred.
template <class Law>
bool holds_on_hostile_meshes(const std::string& what, Law law) {
    return rc::check(what, [&] {
        constexpr int choices = 220; // more than the largest of these meshes asks for
        const auto bytes =
            *rc::gen::resize(rc::kNominalSize, rc::gen::container<std::vector<std::uint8_t>>(
                                                   choices, rc::gen::arbitrary<std::uint8_t>()));
        const Mesh mesh = hostile_mesh(bytes);
        RC_LOG() << "points\n" << mesh.points << "\nsimplices\n" << mesh.simplices << "\n";
        law(mesh);
    });
}

/// The same for those that are accepted, at least a quarter of them, made ready for calculus.
template <class Law>
bool holds_on_hostile_discretizations(const std::string& what, Law law,
                                      const DiscretizeOptions& options = {}) {
    int meshes = 0, accepted = 0;
    const bool holds = holds_on_hostile_meshes(what, [&](const Mesh& mesh) {
        const auto made = unless_refused([&] { return discretize(mesh, options); });
        ++meshes;
        accepted += made ? 1 : 0;
        if (made)
            law(*made);
    });
    return holds && 4 * accepted >= meshes;
}

} // namespace polydec::test
