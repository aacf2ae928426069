// SPDX-License-Identifier: BSD-3-Clause
// Triangles that stand in a file twice.
#pragma once

#include <vector>

#include "mesh.h"

namespace hogelscope::mesh {

/// Returns the triangles without those whose three places (x, y, z of each point), in any order,
/// are an earlier one's: which of two such is met first would depend on the way through the scene.
/// `materialOf` loses the same entries.
std::vector<Corners> withoutRepeated(const std::vector<Corners>& triangles,
                                     const std::vector<float>& points,
                                     std::vector<std::uint32_t>& materialOf);

}  // namespace hogelscope::mesh
