// SPDX-License-Identifier: BSD-3-Clause
// Fuzzes the views of HDF5 files, whose library reads them in a process of its own.
#include "io/images/hdf5_views.h"
#include "tests/fuzz/fuzz.h"

using namespace hogelscope;

void fuzz(std::string_view input) {
  constexpr double most = 1e6;  // values; more of them find nothing new
  mayRefuse([&] {
    const Hdf5Views views(fileOf("views.h5", input));
    const LightFieldSize size = views.size();
    if (double(size.nx) * size.ny > most) return;
    std::size_t rows = 0;
    Hdf5View last = views.view(size.dv - 1, size.du - 1);
    last.read(views.type(),
              [&rows](std::size_t, std::size_t count, const StoredRows&) { rows += count; }, {});
    require(rows == std::size_t(size.ny));
  });
}
