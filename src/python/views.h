// SPDX-License-Identifier: BSD-3-Clause
// How a call of Python names a light field.
#pragma once

#include <memory>
#include <string>
#include <variant>

#include "python/content.h"

namespace hogelscope {

/// The session's own; one that is open; a file, a folder or a session, as --test takes it.
using LightChoice = std::variant<std::monostate, std::shared_ptr<Content>, std::string>;

/// The session with a file as its light field. Throws InputError that names the file.
Session sessionWith(const Session& session, const std::string& file);

}  // namespace hogelscope
