// SPDX-License-Identifier: BSD-3-Clause
// Inspects a light field that is opened without a session: what is assumed, for which reasons, and
// a preview. The user's choices are overrides, as with --set: the window's dialog edits these, and
// the rest is guessed again.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "core/optics/image.h"
#include "io/opening/session_around.h"

namespace hogelscope {

/// The fields that a user gives: values, as in JSON, by names such as "lightField.layout".
using SaidFields = std::map<std::string, std::string>;

struct Assumption {
  std::string what;  ///< such as "Layout"
  std::string value;
  std::string reason;
  Sureness sureness = Sureness::unknown;
  bool isUsual = false;  ///< a default, which nothing contradicts
};

struct Opening {
  OrderedSession around;             ///< without states if it cannot be read yet
  LightFieldSize size;               ///< all 0 if unknown
  std::array<int, 2> picture{0, 0};  ///< the file's width and height if it is one image
  std::vector<Assumption> assumptions;
  std::string problem;  ///< why it cannot be read with the assumptions; "" if it can
};

/// A picture of a light field for a user.
struct Preview {
  Image image;
  bool isStretched = false;  ///< it is a dark capture, whose contrast is stretched
};

/// Inspects a light field and returns what is assumed for fields that are not given. An image of
/// layout "views" stands for its folder. Throws InputError if no fields can make the file a light
/// field; Cancelled.
Opening inspectFile(const std::string& file, const SaidFields& said, const Progress& progress);

/// Returns warnings if the images of a session's light field contradict it: order of views, missing
/// views, lenslets that do not lie on a regular grid, what a quilt's tiles leave over; and what its
/// files say of their pictures. Only the order of views and mosaics is examined. Throws InputError,
/// Cancelled.
std::vector<std::string> examine(const LightFieldParams& lightField, const DisplayParams& display,
                                 const Progress& progress = {});

/// Whether a file or folder whose layout is `own` can have another one. A picture may be one of the
/// views in its folder.
bool mayHave(Layout layout, const std::string& file, Layout own);

/// Whether there is a problem, or a guess that a user should see before it is used.
bool isInDoubt(const Opening& opening);

/// Returns the session with the numbers that its file gives, for a form.
Session shownOf(const Opening& opening);

/// Returns the given fields after an edit of light field or display of the session `shown`. A new
/// layout discards all others. Hogels and directions follow from each other; so does a number down
/// that is not given yet, for square tiles of an image of size `picture`.
SaidFields saidAfter(SaidFields said, const Session& shown, Session edited,
                     const std::array<int, 2>& picture);

/// Returns up to 5×5 views in the assumed order (contactSheet), or the reduced image itself while
/// the numbers of hogels are unknown. Throws InputError, also for a light field that is computed or
/// too large; Cancelled.
Preview previewOf(const Opening& opening, const Progress& progress);

/// Draws up to 5×5 views in colour, as far as they fit into memory, at the places of their cameras:
/// according to `assumed`, the left column was taken from the left, the top row from the top.
/// Arrows in the middle view show how its content moves to the view on the right (yellow) and to
/// the one below (blue). If the order is unknown, a text says what to look for. Throws InputError,
/// or Cancelled.
Preview contactSheet(const LightFieldOrder& order, const AssumedOrder& assumed,
                     const DisplayParams& display, const Progress& progress = {});

}  // namespace hogelscope
