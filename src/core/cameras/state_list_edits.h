// SPDX-License-Identifier: BSD-3-Clause
// What is done to the list of a session's camera states. Names stay different from each other.
#pragma once

#include "core/optics/session.h"

namespace hogelscope {

/// `wanted`, or with the first of " 2", " 3", … that no state has.
std::string freeName(const Session& session, const std::string& wanted);

/// On the panel's axis, where the panel fills most of the picture; named "View".
CameraState inFrontOf(const DisplayParams& display);

/// After the others; its name becomes a free one. Returns its index.
std::size_t addState(Session& session, CameraState state);
/// Behind the original. Returns its index.
std::size_t duplicateState(Session& session, std::size_t index);
/// By their indices. Throws InputError for all of them.
void removeStates(Session& session, const std::vector<std::size_t>& indices);
/// Those at `indices` come to stand together, in their order, before the one that is at `before`
/// now; their number is the end.
void moveStates(Session& session, const std::vector<std::size_t>& indices, std::size_t before);
/// Throws InputError: taken, or not a file's name.
void renameState(Session& session, std::size_t index, const std::string& name);
/// All of them, in their order, with free names.
void mergeStates(Session& session, const std::vector<CameraState>& states);

}  // namespace hogelscope
