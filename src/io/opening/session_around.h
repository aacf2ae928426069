// SPDX-License-Identifier: BSD-3-Clause
// Sessions around light fields that have none of their own.
#pragma once

#include <string>
#include <vector>

#include "core/optics/session.h"
#include "io/opening/light_field_order.h"

namespace hogelscope {

/// A session around a light field, and what was found out about the order of its views.
struct OrderedSession {
  Session session;
  LightFieldOrder order;
  /// A line for the user on what nobody has said of hogels and directions, but the picture shows;
  /// "" if there is none.
  std::string assumed;
  Sureness hogels = Sureness::sure;  ///< of that
};

/// Makes a session around a light field: an image, a quilt by its name, a folder of views, or a
/// mesh, which is read. The display has its shape; one state is in front of it. Views get the order
/// and shear that their pictures say, unless the overrides do. Of a hogel image the hogels and
/// directions are found in the picture, or remain to be given; a few large tiles are those of a
/// quilt or a mosaic. A store has its display. `overrides` are those of loadSession(). Throws
/// InputError, or Cancelled while a mesh is read or views are looked at.
OrderedSession orderedSessionAround(const std::string& file,
                                    const std::vector<std::string>& overrides = {},
                                    const Progress& progress = {});

/// The session alone.
Session sessionAround(const std::string& file, const std::vector<std::string>& overrides = {},
                      const Progress& progress = {});

/// Returns the session with another light field, for comparisons: an image, a folder of views, or a
/// session, of which the display is used too. Throws InputError.
Session withLightField(const Session& session, const std::string& file);

}  // namespace hogelscope
