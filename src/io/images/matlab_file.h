// SPDX-License-Identifier: BSD-3-Clause
// MATLAB's files before version 7.3, which are no HDF5 (MAT-File Format, The MathWorks).
#pragma once

#include <filesystem>

namespace hogelscope {

/// Throws InputError that names such a file, and the shapes of its variables as far as they are not
/// compressed; any other file is accepted.
void refuseMatlab(const std::filesystem::path& file);

}  // namespace hogelscope
