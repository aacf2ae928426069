// SPDX-License-Identifier: BSD-3-Clause
// Makes sessions for light fields that have none of their own.
#pragma once

#include <string>
#include <vector>

#include "core/optics/session.h"
#include "io/layouts/light_field_file.h"
#include "io/opening/light_field_order.h"

namespace hogelscope {

/// A session around a light field, and the order of its views that was found.
struct OrderedSession {
  Session session;
  LightFieldOrder order;
  /// A line for the user on hogels and directions that were not given, but found in the image; ""
  /// if there is none.
  std::string assumed;
  Sureness hogels = Sureness::sure;  ///< confidence in them
};

/// Returns a session around a light field: an image, a quilt (by its name), a folder of views, or a
/// mesh, which is read. The display has its shape; one state is in front of it. Views get the order
/// and shear found in their images, unless the overrides give them. The hogels and directions of a
/// hogel image are found in it, or remain to be given; a few large tiles are taken for a quilt or a
/// mosaic, spots of light on a regular grid for lenslets. A store has its display. `overrides` are
/// those of loadSession(). Throws InputError, or Cancelled while a mesh is read or views are
/// examined.
OrderedSession orderedSessionAround(const std::string& file,
                                    const std::vector<std::string>& overrides = {},
                                    const Progress& progress = {});

/// Returns a session whose light field is replaced by these views, in the order of the cameras in
/// a file beside them, else in the one found in the pictures. The display stays, but for directions
/// that running numbers need. Throws as orderedSessionAround().
OrderedSession withViews(const Session& session, const LightFieldParams& views,
                         const Progress& progress);

/// Adds the warnings of a light field that are not there already.
void addWarnings(std::vector<std::string>& warnings, const LightFieldFile& file);
/// Adds what the files of a light field say (ImageFile::notes()); nothing for one that cannot be
/// read, which is said when it is.
void addFileWarnings(std::vector<std::string>& warnings, const LightFieldParams& params,
                     const DisplayParams& display);

/// Whether the hogels of a session's light field are known; an image of hogels may not say them.
bool isWhole(const Session& session);
/// Returns hogels and directions of the session's light field, which it opens. Throws InputError.
LightFieldSize sizeOf(const Session& session);
/// Returns what is assumed of a session's light field, with the lenslets of that layout. Throws
/// InputError.
AssumedOrder orderOf(const OrderedSession& subject);

/// Returns only the session.
Session sessionAround(const std::string& file, const std::vector<std::string>& overrides = {},
                      const Progress& progress = {});

/// Returns the lens sheet of a calibration's file at a display's place; a sheet keeps its viewing
/// distance and emitter. Throws InputError.
DisplayParams withCalibration(const DisplayParams& display, const std::string& calibration);
/// Returns a session that shows a quilt on a lens sheet, with one state at the sheet's viewing
/// distance. Throws InputError, also for other layouts.
Session onSheet(const LightFieldParams& quilt, const std::string& calibration);

/// Returns the session with another light field, for comparisons: an image, a folder of views, or a
/// session, whose display is used too. Throws InputError.
Session withLightField(const Session& session, const std::string& file);
/// Whether another light field can be read and shown by the session's display. Throws Cancelled.
bool canCompare(const Session& session, const std::string& file, const Progress& progress);

}  // namespace hogelscope
