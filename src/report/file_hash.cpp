// SPDX-License-Identifier: BSD-3-Clause
// SHA-256 of files, by OpenSSL: light fields have gigabytes, of which Qt hashes a quarter a second.
#include "report/file_hash.h"

#include <openssl/evp.h>
#include <QByteArray>
#include <QFile>

#include <array>
#include <memory>
#include <span>

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
    return QByteArray(reinterpret_cast<const char*>(digest.data()), digest.size())
        .toHex()
        .toStdString();
  }

 private:
  std::unique_ptr<EVP_MD_CTX, void (*)(EVP_MD_CTX*)> m_context;
};

std::string hashOf(const fs::path& path, const Progress& progress) {
  QFile file(QString::fromStdString(path.string()));
  if (!file.open(QIODevice::ReadOnly))
    throw InputError(path.string(), "cannot be read", file.errorString().toStdString());
  Hash hash;
  constexpr qint64 block = qint64{1} << 20;
  while (true) {
    hearStop(progress);
    const QByteArray bytes = file.read(block);
    if (bytes.isEmpty()) break;
    hash.add({bytes.data(), std::size_t(bytes.size())});
  }
  if (file.error() != QFileDevice::NoError)
    throw InputError(path.string(), "cannot be read", file.errorString().toStdString());
  return hash.hex();
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
