// SPDX-License-Identifier: BSD-3-Clause
// Queries of files and folders that throw only InputError, and checks, before work starts, that
// results can be written.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace hogelscope {

/// Whether a path is a folder; false if unknown, because reading the path will then report the
/// reason.
bool isFolder(const std::filesystem::path& path);

/// Returns the entries of a folder, sorted by name. Throws InputError (missing, no permission).
std::vector<std::filesystem::path> entriesOf(const std::filesystem::path& folder);

/// Returns the entries that are not folders, sorted by name, including broken links. Throws
/// InputError.
std::vector<std::filesystem::path> filesIn(const std::filesystem::path& folder);

/// Returns a file name in a document that lies in `folder` relative to the current folder.
std::string besideDocument(const std::filesystem::path& folder, const std::string& file);

/// Returns a file name relative to the folder of a document.
std::string relativeTo(const std::filesystem::path& document, const std::string& file);

/// Throws InputError if no file can be written into the folder because of permissions or a
/// read-only or full disk. Leaves nothing behind.
void checkWritable(const std::filesystem::path& folder);

/// Creates the folder of the file and its parents. Throws InputError as checkWritable() does.
void makeFolderOf(const std::filesystem::path& file);

}  // namespace hogelscope
