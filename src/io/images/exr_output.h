// SPDX-License-Identifier: BSD-3-Clause
// EXR output of floats through OpenEXR itself, which brings five libraries instead of OpenImageIO's
// 230; every report ends with images of floats.
#pragma once

#include "io/images/codecs.h"

namespace hogelscope {

class ExrOutput : public ImageOutput {
 public:
  /// Creates an image of StoredType::real only. `name` is for errors; `bytes` must outlive the
  /// output. Throws InputError.
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
