// SPDX-License-Identifier: BSD-3-Clause
// Fuzzes the views of HDF5 files, whose library reads them in a process of its own.
#include "io/images/image_inputs.h"
#include "tests/fuzz/fuzz.h"

using namespace hogelscope;

void fuzz(std::string_view input) {
  constexpr double most = 1e6;  // values; more of them find nothing new
  mayRefuse([&] {
    const auto views = openHdf5(fileOf("views.h5", input));
    const ImageFacts& facts = views->facts();
    if (double(facts.width) * double(facts.height) > most) return;
    withStoredType(facts.type, [&]<class T>(T) {
      std::vector<T> rgb(3 * facts.width * facts.height);
      views->read(facts.frames - 1, 0, facts.height, rgb.data());
    });
  });
}
