// SPDX-License-Identifier: BSD-3-Clause
// Reads overrides of a pattern's parameters in the same way as a section of a document.
#include "io/documents/pattern_params.h"

#include "core/base/error.h"
#include "io/json/json_parameters.h"

namespace hogelscope {

PatternParams patternParams(const std::vector<std::string>& overrides) {
  Json document = Json::object();
  for (const std::string& text : overrides) {
    const Override change = parseOverride(text);
    document[change.section][change.field] = change.value;
  }
  PatternParams params;
  inFile("override", [&] {
    JsonReader reader(document, "");
    readSection(reader, "pattern", params);
    reader.refuseUnknown();
  });
  return params;
}

}  // namespace hogelscope
