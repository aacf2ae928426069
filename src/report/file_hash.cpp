// SPDX-License-Identifier: BSD-3-Clause
// SHA-256 of files, by OpenSSL.
#include "report/file_hash.h"

#include <fcntl.h>
#include <openssl/evp.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <memory>
#include <span>

#include "io/files/random_access_file.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

class Hash {
 public:
  Hash() : m_context(EVP_MD_CTX_new(), &EVP_MD_CTX_free) {
    EVP_DigestInit_ex(m_context.get(), EVP_sha256(), nullptr);
  }
  void add(std::span<const char> bytes) {
    EVP_DigestUpdate(m_context.get(), bytes.data(), bytes.size());
  }
  std::string hex() {
    std::array<unsigned char, 32> digest{};
    EVP_DigestFinal_ex(m_context.get(), digest.data(), nullptr);
    std::string text;
    for (const unsigned char byte : digest)
      for (const int digit : {byte >> 4, byte & 15})
        text += "0123456789abcdef"[std::size_t(digit)];  // NOLINT: of 16 characters
    return text;
  }

 private:
  std::unique_ptr<EVP_MD_CTX, void (*)(EVP_MD_CTX*)> m_context;
};

std::string hashOf(const fs::path& path, const Progress& progress) {
  const auto failed = [&path] {
    return InputError(path.string(), "cannot be read", std::strerror(errno));
  };
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.get() < 0) throw failed();
  Hash hash;
  std::vector<char> block(std::size_t{1} << 20);
  while (true) {
    hearStop(progress);
    const ssize_t bytes = ::read(file.get(), block.data(), block.size());
    if (bytes == 0) return hash.hex();
    if (bytes > 0)
      hash.add({block.data(), std::size_t(bytes)});
    else if (errno != EINTR)
      throw failed();
  }
}

}  // namespace

std::string sha256(const std::vector<fs::path>& files, const Progress& progress) {
  if (files.size() == 1) return hashOf(files.front(), progress);
  std::string lines;
  for (const fs::path& file : files)
    lines += hashOf(file, progress) + "  " + file.filename().string() + "\n";
  return sha256(lines);
}

std::string sha256(const std::string& text) {
  Hash hash;
  hash.add(text);
  return hash.hex();
}

}  // namespace hogelscope
