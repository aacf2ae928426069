// SPDX-License-Identifier: BSD-3-Clause
// Pieces of work on several threads, each piece on one of them.
#pragma once

#include <cstddef>
#include <functional>

namespace hogelscope {

/// Calls `work(k, worker)` for every k below `count`, in their order, on `workers` threads numbered
/// from 0. What a piece throws stops the others before their next piece, and is thrown here.
void sideBySide(std::size_t count, int workers,
                const std::function<void(std::size_t k, std::size_t worker)>& work);

}  // namespace hogelscope
