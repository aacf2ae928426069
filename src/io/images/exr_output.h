// SPDX-License-Identifier: BSD-3-Clause
// Writes an EXR of floats through OpenEXR itself, which brings five libraries where OpenImageIO
// brings 230: every report ends with pictures of floats.
#pragma once

#include "io/images/codecs.h"

namespace hogelscope {

class ExrOutput : public ImageOutput {
 public:
  /// Of StoredType::real alone. `name` is for errors, `bytes` has to outlive the output. Throws
  /// InputError.
  ExrOutput(std::string name, const ImageSpec& spec, ByteOutput& bytes);
  ~ExrOutput() override;
  void write(const StoredRows& values, std::size_t rows) override;
  void finish() override;

 private:
  struct File;

  std::string m_name;
  ImageSpec m_spec;
  std::unique_ptr<File> m_file;
  std::size_t m_row = 0;
};

}  // namespace hogelscope
