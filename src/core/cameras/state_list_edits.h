// SPDX-License-Identifier: BSD-3-Clause
// Edits of the list of a session's camera states. Names stay unique.
#pragma once

#include <optional>

#include "core/optics/session.h"

namespace hogelscope {

/// Returns the index of the state with the name, in any case; none if the name is free.
std::optional<std::size_t> stateNamed(const Session& session, const std::string& name);

/// Returns `wanted`, with the first of "", " 2", " 3", … that makes it unique.
std::string freeName(const Session& session, const std::string& wanted);

/// Returns a state named "View" on the panel's axis, where the panel fills most of the image.
CameraState inFrontOf(const PanelParams& display);

/// Appends a state, under a free name. Returns its index.
std::size_t addState(Session& session, CameraState state);
/// Inserts a copy after the original. Returns its index.
std::size_t duplicateState(Session& session, std::size_t index);
/// Removes states by their indices. Throws InputError if these are all states.
void removeStates(Session& session, const std::vector<std::size_t>& indices);
/// Moves the states at `indices`, in their order, before the one that is at `before` now; the
/// number of states means the end.
void moveStates(Session& session, const std::vector<std::size_t>& indices, std::size_t before);
/// Moves a state by one place, as long as it is not the first, or the last. Returns its index.
std::size_t moveStateUp(Session& session, std::size_t index);
std::size_t moveStateDown(Session& session, std::size_t index);
/// Renames a state. Throws InputError if the name is taken or not a valid file name.
void renameState(Session& session, std::size_t index, const std::string& name);
/// Appends all of `states`, in their order, under free names.
void mergeStates(Session& session, const std::vector<CameraState>& states);

}  // namespace hogelscope
