// SPDX-License-Identifier: BSD-3-Clause
// Which temporary files there are, for what ends the process before their owners remove them.
#pragma once

#include <filesystem>

namespace hogelscope {

/// For the whole process, since a signal ends the whole process. From any thread.
void registerTemporary(const std::filesystem::path& file);
void forgetTemporary(const std::filesystem::path& file);

/// Before the process ends: removes them all. Nobody can register or forget a file afterwards: who
/// tries waits, so that no new one comes and none is missed.
void removeTemporaries();

}  // namespace hogelscope
