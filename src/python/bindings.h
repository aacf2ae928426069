// SPDX-License-Identifier: BSD-3-Clause
// The parts of the Python extension module _hogelscope. Its interface has JSON texts, numpy arrays
// and LightField objects; the package around it makes dicts and classes of them. A session keeps
// its light field and lens tables for the next view (SessionViews), under a lock that Ctrl-C
// interrupts.
#pragma once

#include <pybind11/pybind11.h>

#include <string>

#include "core/optics/session.h"

namespace hogelscope {

void addDocuments(pybind11::module_& module);
void addLightFields(pybind11::module_& module);
void addViews(pybind11::module_& module);
void addFigures(pybind11::module_& module);
void addMeasures(pybind11::module_& module);
void addOptimised(pybind11::module_& module);
void addReports(pybind11::module_& module);
void addCampaigns(pybind11::module_& module);
void addPages(pybind11::module_& module);

/// A session held by Python: its text, the base of its relative paths, and its name in messages (""
/// without a file).
struct Document {
  std::string text;
  std::string folder;
  std::string name;
  bool operator==(const Document&) const = default;
};

/// Parses a session. Throws InputError that begins with the document's name.
Session sessionOf(const Document& document);

}  // namespace hogelscope
