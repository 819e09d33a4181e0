// SPDX-License-Identifier: MIT
#pragma once

#include "tests/support/families.h"
#include "tests/support/merged.h"

#include <gtest/gtest.h>

#include <string>

namespace polydec::test {

/// Fixture of laws that hold for every mesh of the family; the parameter is the mesh's name.
class OverMeshes : public testing::TestWithParam<std::string> {
protected:
    const Merged& mesh() const { return merged(GetParam()); }
};

inline std::string parameter_name(const testing::TestParamInfo<std::string>& instance) {
    return instance.param;
}

/// Instantiates a suite for every mesh of the family.
#define POLYDEC_OVER_MESHES(suite)                                                                 \
    INSTANTIATE_TEST_SUITE_P(Family, suite, testing::ValuesIn(names_of_meshes()), parameter_name)

} // namespace polydec::test
