// SPDX-License-Identifier: BSD-3-Clause
// The light field of a Python call.
#pragma once

#include <memory>
#include <string>
#include <variant>

#include "python/content.h"

namespace hogelscope {

/// The session's own; an open one; or a file, a folder or a session, as for --test.
using LightChoice = std::variant<std::monostate, std::shared_ptr<Content>, std::string>;

/// Returns the session with a file as its light field. Throws InputError that names the file.
Session sessionWith(const Session& session, const std::string& file);

}  // namespace hogelscope
