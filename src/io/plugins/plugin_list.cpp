// SPDX-License-Identifier: BSD-3-Clause
#include "io/plugins/plugin_list.h"

#include <elf.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <span>

#include "core/base/error.h"
#include "core/base/plugin_params.h"
#include "io/files/atomic_file.h"
#include "io/files/folders.h"
#include "io/files/random_access_file.h"
#include "io/json/json_parameters.h"
#include "sdk/hogelscope/plugin.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

std::vector<fs::path>& addedFolders() {
  static std::vector<fs::path> folders;
  return folders;
}

}  // namespace

void addPluginFolder(const fs::path& folder) {
  if (!isFolder(folder))
    throw InputError(folder.string(), "", "is not a folder; each plugin is a folder in it");
  std::error_code error;
  addedFolders().push_back(fs::canonical(folder, error));
}

std::vector<fs::path> pluginFolders() {
  const std::string ours = "plugins-" + std::to_string(plugin::abi);
  std::vector<fs::path> folders = addedFolders();
  const char* const home = std::getenv("HOME");
  const bool hasHome = home != nullptr && fs::path(home).is_absolute();
  const fs::path own = hasHome ? fs::path(home) / ".local/lib/hogelscope" : fs::path();
  if (hasHome) folders.push_back(own / ours);
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (!error) {
    const fs::path prefix = program.parent_path().parent_path();  // the program is in PREFIX/bin
    folders.push_back(prefix / HOGELSCOPE_LIBRARIES / "hogelscope" / ours);
    folders.push_back(prefix / ours);
  }
  // Plugins for older programs are rejected by their number, with advice.
  for (auto older = plugin::abi - 1; hasHome && older > 0; --older)
    if (const fs::path folder = own / ("plugins-" + std::to_string(older)); isFolder(folder))
      folders.push_back(folder);
  std::vector<fs::path> once;
  for (const fs::path& folder : folders)
    if (std::ranges::find(once, folder) == once.end()) once.push_back(folder);
  return once;
}

namespace fs = std::filesystem;

namespace {

constexpr const char* jsonName = "plugin.json";

/// The document beside a library, written by cmake/hogelscope_add_plugin.cmake.
struct PluginDocument {
  std::string name;
  std::string version;
  int abi = 0;
  std::string build;
  std::string file;
  int bytes = 0;
};

void describe(ParameterVisitor& v, PluginDocument& p) {
  auto& [name, version, abi, build, file, bytes] = p;
  constexpr double most = std::numeric_limits<int>::max();
  v.group("plugin", "A library beside this document.");
  v.field("name", name, "The name in sessions.");
  v.field("version", version, "The plugin's own.");
  v.field("abi", abi, {1, most}, "", "The number of the SDK.");
  v.field("build", build, "The C++ ABI of the compiler.");
  v.field("file", file, "The library's file name.");
  v.field("bytes", bytes, {1, most}, "", "The library's size.");
}

std::vector<PluginKind> readKinds(const Json* list) {
  std::vector<PluginKind> kinds;
  const std::string known = "is not a list of \"content\", \"lens\", \"metric\"";
  if (list == nullptr || !list->is_array() || list->empty()) throw InputError("kinds", known);
  for (const Json& item : *list) {
    const auto at =
        std::ranges::find_if(pluginKindNames, [&](std::string_view name) { return item == name; });
    if (at == pluginKindNames.end()) throw InputError("kinds", known);
    kinds.push_back(PluginKind(at - pluginKindNames.begin()));
  }
  return kinds;
}

/// Checks the numbers first, because another SDK's document may have another form.
void checkNumbers(const Json& document) {
  if (!document.is_object()) throw InputError("", "is not an object: { \"name\": value, … }");
  if (const auto abi = document.find("abi"); abi == document.end() || *abi != plugin::abi)
    throw InputError("abi", (abi == document.end() ? "is missing" : abi->dump().substr(0, 20)) +
                                ", this program needs " + std::to_string(plugin::abi) +
                                ": build the plugin again with this program's SDK");
  if (const auto build = document.find("build");
      build == document.end() || *build != HOGELSCOPE_PLUGIN_BUILD)
    throw InputError("build", "is not " HOGELSCOPE_PLUGIN_BUILD
                              ": build the plugin with the compiler that built this program");
}

/// Whether a library's header names parts beyond its end: dlopen() would end the process. What is
/// no library of 64 bits is left to dlopen(), which refuses it.
bool isCutOff(const fs::path& library) {
  const RandomAccessFile file(library);
  Elf64_Ehdr header{};
  const std::size_t read = file.readSome(0, std::as_writable_bytes(std::span(&header, 1)));
  if (read < sizeof header || std::memcmp(header.e_ident, ELFMAG, SELFMAG) != 0 ||
      header.e_ident[EI_CLASS] != ELFCLASS64)
    return false;
  const auto isBeyond = [&file](std::uint64_t at, std::uint64_t bytes) {
    return at > file.size() || bytes > file.size() - at;
  };
  if (isBeyond(header.e_shoff, std::uint64_t(header.e_shentsize) * header.e_shnum) ||
      isBeyond(header.e_phoff, sizeof(Elf64_Phdr) * header.e_phnum))
    return true;
  std::vector<Elf64_Phdr> parts(header.e_phnum);
  file.read(header.e_phoff, std::as_writable_bytes(std::span(parts)));
  return std::ranges::any_of(
      parts, [&](const Elf64_Phdr& part) { return isBeyond(part.p_offset, part.p_filesz); });
}

/// Throws InputError unless the library is a whole file of the size in plugin.json, in the plugin's
/// own folder.
void checkLibrary(const fs::path& folder, const PluginDocument& document) {
  const fs::path file = document.file;
  if (file.empty() || file != file.filename() || file == "." || file == "..")
    throw InputError("file", "\"" + document.file + "\" is not the name of a file beside it");
  std::error_code error;
  const fs::path real = fs::canonical(folder / file, error);
  if (error) throw InputError("file", document.file + ": " + error.message());
  if (real.parent_path() != fs::canonical(folder, error) || error)
    throw InputError("file", document.file + " leads out of the plugin's folder");
  const std::uintmax_t bytes = fs::is_regular_file(real, error) ? fs::file_size(real, error) : 0;
  if (error || bytes == 0) throw InputError("file", document.file + " is not a file with content");
  if (bytes != std::uintmax_t(document.bytes))
    throw InputError("bytes", document.file + " has " + std::to_string(bytes) + " bytes, not " +
                                  std::to_string(document.bytes) +
                                  ": it is damaged or was replaced; install the plugin again");
  if (isCutOff(real))
    throw InputError("file", document.file + " is cut off: install the plugin again");
}

void readPlugin(FoundPlugin& found) {
  const fs::path file = found.folder / jsonName;
  constexpr std::uintmax_t largest = 65536;
  std::error_code error;
  if (fs::is_regular_file(file, error) && fs::file_size(file, error) > largest)
    throw InputError("", "is larger than 64 KiB: not a document of a plugin");
  const Json json = parseJson(readTextFile(file));
  checkNumbers(json);
  PluginDocument document;
  JsonReader reader(json, "");
  describe(reader, document);
  found.kinds = readKinds(reader.section("kinds"));
  reader.refuseUnknown();
  checkPluginName(document.name, "name");
  found.name = document.name;
  found.version = document.version;
  checkLibrary(found.folder, document);
  found.library = found.folder / document.file;
}

void addPlugin(const fs::path& folder, std::vector<FoundPlugin>& plugins) {
  std::error_code error;
  FoundPlugin found{folder.filename().string(), {}, {}, folder, {}, {}};
  if (fs::symlink_status(folder / jsonName, error).type() == fs::file_type::not_found) return;
  try {
    readPlugin(found);
  } catch (const InputError& problem) {
    found.refusal = problem.in((folder / jsonName).string()).what();
  }
  const auto same = std::ranges::find(plugins, found.name, &FoundPlugin::name);
  if (found.refusal.empty() && same != plugins.end())
    found.refusal = InputError(folder.string(), "", "is hidden by " + same->folder.string()).what();
  plugins.push_back(std::move(found));
}

}  // namespace

std::string nameOf(PluginKind kind) {
  return std::string(pluginKindNames[std::size_t(kind)]);
}

std::vector<FoundPlugin> listPlugins() {
  std::vector<FoundPlugin> plugins;
  for (const fs::path& folder : pluginFolders()) {
    if (!isFolder(folder)) continue;
    try {
      for (const fs::path& entry : entriesOf(folder)) addPlugin(entry, plugins);
    } catch (const InputError& problem) {
      plugins.push_back({folder.filename().string(), {}, {}, folder, {}, problem.what()});
    }
  }
  return plugins;
}

std::vector<fs::path> pluginFiles(const std::vector<std::string>& names) {
  std::vector<fs::path> files;
  if (std::ranges::all_of(names, &std::string::empty)) return files;
  for (const FoundPlugin& plugin : listPlugins())
    if (plugin.refusal.empty() && std::ranges::find(names, plugin.name) != names.end()) {
      files.push_back(plugin.folder / "plugin.json");
      files.push_back(plugin.library);
    }
  return files;
}

}  // namespace hogelscope
