// SPDX-License-Identifier: BSD-3-Clause
#include "io/plugins/display_json.h"

#include "core/base/error.h"
#include "io/plugins/plugin_library.h"

namespace hogelscope {

LensParams lensParamsOf(const std::string& source) {
  const PluginLibrary library = loadPlugin(source, PluginKind::lens);
  return LensParams([library] { return library.makeLens(); });
}

DisplayParams withLensParams(const DisplayParams& before, DisplayParams after) {
  if (after.lens != HogelLensModel::plugin) {
    after.lensSource.clear();
    after.lensParams = {};
    return after;
  }
  if (after.lens != before.lens) after.lensSource = "measured-lens";
  if (after.lensSource != before.lensSource) after.lensParams = lensParamsOf(after.lensSource);
  for (const std::size_t axis : {0, 1}) (void)lensOf(after, axis);
  return after;
}

DisplayParams readDisplay(const Json& object) {
  DisplayParams params;
  JsonReader reader(object, "display");
  describe(reader, params);
  if (params.lens == HogelLensModel::plugin) {
    if (params.lensSource.empty())
      throw InputError("display.lensSource", "is missing: name the plugin of the lens");
    params.lensParams = lensParamsOf(params.lensSource);
    readSection(reader, params.lensSource.c_str(), params.lensParams);
  }
  reader.refuseUnknown();
  return params;
}

Json writtenDisplay(const DisplayParams& params) {
  Json object = written(params);
  if (params.lensParams.isGiven()) object[params.lensSource] = written(params.lensParams);
  return object;
}

}  // namespace hogelscope
