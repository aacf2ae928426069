// SPDX-License-Identifier: BSD-3-Clause
// A light field that is opened without a session: what is assumed of it, by what, and how it looks
// then.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "core/optics/image.h"
#include "io/opening/session_around.h"

namespace hogelscope {

/// What a user says of the light field: the value, as in JSON, of "lightField.layout" and the like.
using SaidFields = std::map<std::string, std::string>;

struct Assumption {
  std::string what;  ///< "Layout" and the like
  std::string value;
  std::string reason;
  Sureness sureness = Sureness::unknown;
  bool isUsual = false;  ///< what the layout means unless it is said, and nothing contradicts
};

struct Opening {
  OrderedSession around;             ///< without states where it cannot be read yet
  LightFieldSize size;               ///< all 0 where that is not known
  std::array<int, 2> picture{0, 0};  ///< the file's width and height where it is one picture
  std::vector<Assumption> assumptions;
  std::string problem;  ///< why it cannot be read as it is assumed; "" if it can
};

/// Looks at a light field and says what is assumed of what nobody said. A picture of layout "views"
/// stands for the folder that it is in. Throws InputError where nothing that could be said makes a
/// light field of the file; Cancelled.
Opening inspectFile(const std::string& file, const SaidFields& said, const Progress& progress);

/// Returns lines for the user on what the pictures of a session's light field say against it: the
/// order of views, views that are missing, lenslets that do not lie on a regular grid. Looks at
/// views, mosaics and lenslets alone. Throws InputError, Cancelled.
std::vector<std::string> examine(const LightFieldParams& lightField, const DisplayParams& display,
                                 const Progress& progress = {});

/// Whether something is a guess that a user should see before it is used.
bool isInDoubt(const Opening& opening);

/// Returns the session with the numbers that its file says, for a form.
Session shownOf(const Opening& opening);

/// Returns what is said after an edit of light field or display of the session `shown`. A new
/// layout leaves nothing said of the old one; of hogels and directions one follows from the other,
/// and so does a number down that is not given yet, for square tiles of a picture of that size.
SaidFields saidAfter(SaidFields said, const Session& shown, Session edited,
                     const std::array<int, 2>& picture);

/// Returns the views as the opening has them, up to 5×5 (contactSheet), or the picture itself,
/// smaller, while it is not known what it shows. Throws InputError, also for what is computed or
/// too large; Cancelled.
Image previewOf(const Opening& opening, const Progress& progress);

/// Draws up to 5×5 views where their cameras stand: the left column was taken from the left, the
/// top row from the top, as `assumed` has it. Arrows in the view in the middle show how its content
/// moves to the view on the right (yellow) and to the one below (blue). Where the order is not
/// known, words say what to look for. Throws InputError, or Cancelled.
Image contactSheet(const LightFieldOrder& order, const AssumedOrder& assumed,
                   const DisplayParams& display, const Progress& progress = {});

}  // namespace hogelscope
