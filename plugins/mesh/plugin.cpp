// SPDX-License-Identifier: BSD-3-Clause
// The exported symbol of the plugin.
#include "mesh_source.h"

namespace {

hogelscope::plugin::ContentSource* makeMeshSource() {
  return new hogelscope::mesh::MeshSource;
}

}  // namespace

HOGELSCOPE_PLUGIN("mesh", "1.0", makeMeshSource, nullptr, nullptr);
