// SPDX-License-Identifier: MIT
#pragma once

/// What every test may use; it is precompiled. Tests include it, and what polydec does not install.

#include "base/decompositions.h"
#include "base/random.h"
#include "polydec.h"
#include "tests/support/dense_laplacian.h"
#include "tests/support/families.h"
#include "tests/support/forms.h"
#include "tests/support/glued.h"
#include "tests/support/golden_numbers.h"
#include "tests/support/hand_made.h"
#include "tests/support/matrices.h"
#include "tests/support/merged.h"
#include "tests/support/over_meshes.h"
#include "tests/support/refusal.h"
#include "tests/support/says.h"

#include <Eigen/Dense>
#include <Eigen/Sparse>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <numbers>
#include <numeric>
#include <optional>
#include <random>
#include <set>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>
