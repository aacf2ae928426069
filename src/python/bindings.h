// SPDX-License-Identifier: BSD-3-Clause
// The parts of the Python extension module _hogelscope. It speaks texts of JSON, numpy arrays and
// LightField objects; the package around it makes dicts and classes of them.
#pragma once

#include <pybind11/pybind11.h>

#include <string>

#include "core/optics/session.h"

namespace hogelscope {

void addDocuments(pybind11::module_& module);
void addLightFields(pybind11::module_& module);
void addViews(pybind11::module_& module);
void addFigures(pybind11::module_& module);
void addReports(pybind11::module_& module);

/// A session as Python holds it: its text, what its files are relative to, and what messages call
/// it ("" where it is no file).
struct Document {
  std::string text;
  std::string folder;
  std::string name;
};

/// Throws InputError that begins with the document's name.
Session sessionOf(const Document& document);

}  // namespace hogelscope
