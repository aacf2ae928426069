// SPDX-License-Identifier: BSD-3-Clause
// The order of a light field's views as a document for other programs.
#include "io/documents/light_field_params.h"
#include "io/json/json_parameters.h"
#include "io/opening/light_field_order.h"

namespace hogelscope {

namespace {

Json lensletsJson(const FoundLenslets& lenslets) {
  const LensletLattice& lattice = lenslets.lattice;
  Json object = Json::object();
  object["pitch"] = lattice.pitch();
  object["rotation"] = lattice.rotation();
  object["origin"] = {lattice.origin.real(), lattice.origin.imag()};
  object["count"] = lenslets.count;
  if (lenslets.count > 0) object["residual"] = lenslets.residual;
  return object;
}

}  // namespace

AssumedOrder assumedOrder(const LightFieldParams& used, const LightFieldSize& size,
                          const LightFieldOrder& order) {
  AssumedOrder assumed;
  assumed.used = used;
  assumed.size = size;
  assumed.rows = order.rows;
  assumed.columns = order.columns;
  assumed.sureness = order.sureness;
  assumed.warnings = order.warnings;
  if (isGridOfViews(used.layout)) {
    assumed.rows = used.rows;
    assumed.columns = used.columns;
  }
  const std::string contradiction = contradictionOf(used, order);
  if (contradiction.empty()) return assumed;
  assumed.sureness = Sureness::unknown;
  if (!isGridOfViews(used.layout) && used.incoming != order.found.incoming) {
    if (size.dv > 1) assumed.rows = reversed(assumed.rows);
    if (size.du > 1) assumed.columns = reversed(assumed.columns);
  }
  assumed.warnings.push_back(contradiction);
  return assumed;
}

std::string orderDocument(const AssumedOrder& assumed) {
  Json document = Json::object();
  document["layout"] = nameOf(assumed.used.layout);
  document["hogels"] = {assumed.size.nx, assumed.size.ny};
  document["directions"] = {assumed.size.du, assumed.size.dv};
  document["rows"] = nameOf(assumed.rows);
  document["columns"] = nameOf(assumed.columns);
  document["shear"] = assumed.used.shear;
  document["confidence"] = nameOf(assumed.sureness);
  if (assumed.lenslets) document["lenslets"] = lensletsJson(*assumed.lenslets);
  document["warnings"] = assumed.warnings;
  return document.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace hogelscope
