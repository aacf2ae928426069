// SPDX-License-Identifier: BSD-3-Clause
#include "io/store/store_output.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "core/base/error.h"
#include "io/files/atomic_file.h"
#include "io/files/files_in_use.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

fs::path partOf(const fs::path& file) {
  std::error_code none;
  if (fs::exists(file, none) && !fs::is_regular_file(file, none))
    throw InputError(file.string(), "cannot be written", "it is there, and is not a file");
  requireUnused(file);
  fs::path part = file;
  part += ".part";
  requireOwnFile(part, tiffHeader().substr(0, firstLinkAt));
  return part;
}

Descriptor lockedPart(const fs::path& part, const fs::path& file) {
  auto descriptor = openLocked(part);
  if (!descriptor)
    throw InputError(file.string(), "cannot be written", "another run is writing it");
  return std::move(*descriptor);
}

/// Throws unless the file is a store; any BigTIFF begins like one, so its first page is checked.
void requireStore(const RandomAccessFile& part) {
  try {
    const std::uint64_t first = firstLink(part).next;
    if (first == 0 || parseStoreHeader(readPage(part, first).texts.description)) return;
  } catch (const InputError&) {
  }
  throw InputError(part.path().string(), "cannot be written",
                   "it is there, and is not an unfinished store: move it away");
}

}  // namespace

StoreOutput::StoreOutput(const fs::path& file, const StoreHeader& header)
    : m_file(file),
      m_part(partOf(file)),
      m_description(textOf(header)),
      m_descriptor(lockedPart(m_part, file)) {
  const RandomAccessFile part(m_part);
  requireStore(part);
  try {
    goOn(part);
  } catch (const InputError&) {  // an unreadable file is restarted
    m_pages = 0;
  }
  if (m_pages == 0) {
    m_end = 0;
    m_linkAt = firstLinkAt;
  }
  if (::ftruncate(m_descriptor.get(), static_cast<off_t>(m_end)) != 0) fail(errno);
  if (m_pages == 0) append(tiffHeader().data(), tiffHeader().size());
}

/// Follows the chain of pages to its end.
void StoreOutput::goOn(const RandomAccessFile& part) {
  TiffLink link = firstLink(part);
  while (link.next != 0) {
    const DecodedPage page = readPage(part, link.next);
    if (m_pages == 0 && page.texts.description != m_description) return;
    link = page.link;
    m_linkAt = link.nextAt;
    m_end = link.nextAt + sizeof(link.next);
    ++m_pages;
  }
}

void StoreOutput::fail(int error) const {
  throw InputError(m_file.string(), "cannot be written", std::strerror(error));
}

void StoreOutput::writeAt(std::uint64_t at, const void* bytes, std::size_t count) const {
  const auto* rest = static_cast<const char*>(bytes);
  while (count > 0) {
    const ssize_t written = ::pwrite(m_descriptor.get(), rest, count, static_cast<off_t>(at));
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail(errno);
    at += std::uint64_t(written);
    rest += written;
    count -= std::size_t(written);
  }
}

void StoreOutput::append(const void* bytes, std::size_t count) {
  writeAt(m_end, bytes, count);
  m_end += count;
}

void StoreOutput::sync() const {
  syncToDisk(m_descriptor.get(), m_file);
}

void StoreOutput::add(const TileBytes& tiles) {
  if (!tiles.black.empty() && m_blackAt == 0) {
    m_blackAt = m_end;
    append(tiles.black.data(), tiles.black.size());
  }
  std::uint64_t at = m_end;
  for (const std::uint32_t count : tiles.counts) {
    m_offsets.push_back(count == 0 ? m_blackAt : at);
    m_counts.push_back(count == 0 ? std::uint32_t(tiles.black.size()) : count);
    at += count;
  }
  append(tiles.bytes.data(), tiles.bytes.size());
  m_hash.add(tiles.bytes);
}

void StoreOutput::finishPage(const TiffPage& page) {
  const std::string padding((8 - m_end % 8) % 8, '\0');
  append(padding.data(), padding.size());
  const PageTexts texts{m_pages == 0 ? m_description : "", pageName()};
  const EncodedPage encoded = encodedPage(page, m_offsets, m_counts, texts, m_end);
  append(encoded.bytes.data(), encoded.bytes.size());
  sync();
  writeAt(m_linkAt, &encoded.directoryAt, sizeof(encoded.directoryAt));
  m_linkAt = m_end - sizeof(std::uint64_t);
  m_offsets.clear();
  m_counts.clear();
  m_hash = {};
  m_blackAt = 0;
  ++m_pages;
}

/// Returns the hash of the page. Black tiles count with size 0, because their places are content.
std::string StoreOutput::pageName() {
  std::vector<std::uint32_t> sizes = m_counts;
  for (std::size_t k = 0; k < sizes.size(); ++k)
    if (m_offsets[k] == m_blackAt) sizes[k] = 0;
  m_hash.add(std::as_bytes(std::span(sizes)));
  return pageNameOf(m_hash);
}

void StoreOutput::commit() {
  sync();
  requireUnused(m_file);
  std::error_code error;
  fs::rename(m_part, m_file, error);
  if (error) fail(error.value());
  fs::path folder = m_file.parent_path();
  if (folder.empty()) folder = ".";
  const Descriptor opened(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (opened.get() >= 0) (void)::fsync(opened.get());  // syncs the name, where supported
}

}  // namespace hogelscope
