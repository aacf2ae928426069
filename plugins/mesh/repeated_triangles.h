// SPDX-License-Identifier: BSD-3-Clause
// Triangles that occur twice in a file.
#pragma once

#include <vector>

#include "mesh.h"

namespace hogelscope::mesh {

/// Returns the triangles without those whose three positions (x, y, z of each point), in any order,
/// are those of an earlier one; otherwise the first hit of two would depend on the traversal of the
/// scene. `materialOf` loses the same entries.
std::vector<Corners> withoutRepeated(const std::vector<Corners>& triangles,
                                     const std::vector<float>& points,
                                     std::vector<std::uint32_t>& materialOf);

}  // namespace hogelscope::mesh
