// SPDX-License-Identifier: BSD-3-Clause
// What it costs to open a folder of JPEG views, against libjpeg alone with the same files in the
// same run, and how much memory it takes at most.
//   hogelscope-opening FOLDER: such as 13×13 views of 960×640
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <iterator>
#include <memory>
#include <vector>
// After <cstdio>, which it needs.
#include <jpeglib.h>

#include "io/opening/opening.h"
#include "io/scene/view_source.h"

namespace {

using namespace hogelscope;
using Bytes = std::vector<unsigned char>;

/// Of all threads of this process.
double cpuSeconds() {
  timespec now{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

/// Reads and decodes the files, one after the other, into memory for all of them or for one
/// picture. Returns seconds.
double decode(const std::vector<std::filesystem::path>& files, bool isKept) {
  const double begin = cpuSeconds();
  std::vector<std::unique_ptr<unsigned char[]>> pictures;
  std::size_t room = 0;  // of the last one
  for (const std::filesystem::path& file : files) {
    std::ifstream in(file, std::ios::binary);
    const Bytes bytes{std::istreambuf_iterator<char>(in), {}};
    jpeg_decompress_struct jpeg{};
    jpeg_error_mgr errors{};
    jpeg.err = ::jpeg_std_error(&errors);
    jpeg_create_decompress(&jpeg);
    ::jpeg_mem_src(&jpeg, bytes.data(), bytes.size());
    ::jpeg_read_header(&jpeg, TRUE);
    ::jpeg_start_decompress(&jpeg);
    const std::size_t stride = std::size_t{jpeg.output_width} * std::size_t(jpeg.output_components);
    const std::size_t needed = stride * jpeg.output_height;
    if (isKept || needed > room) pictures.emplace_back(new unsigned char[needed]);  // not cleared
    room = std::max(room, needed);
    while (jpeg.output_scanline < jpeg.output_height) {
      unsigned char* row = pictures.back().get() + stride * jpeg.output_scanline;
      ::jpeg_read_scanlines(&jpeg, &row, 1);
    }
    ::jpeg_finish_decompress(&jpeg);
    ::jpeg_destroy_decompress(&jpeg);
  }
  return cpuSeconds() - begin;
}

struct Cost {
  double cpu = 0;
  double system = 0;  ///< the system's share of it, which is mostly for new pages of memory
  double wall = 0;
  double peak = 0;  ///< bytes, with the program's own
};

/// Loads the views in a process of its own.
Cost load(const Session& session) {
  std::array<int, 2> ends{};
  if (::pipe(ends.data()) != 0) return {};
  const pid_t child = ::fork();
  if (child == 0) {
    const double begin = cpuSeconds();
    timespec from{}, to{};
    ::clock_gettime(CLOCK_MONOTONIC, &from);
    const ViewSource source = loadViewSource(session, {}, {.memory = std::size_t{1} << 40});
    ::clock_gettime(CLOCK_MONOTONIC, &to);
    rusage used{};
    ::getrusage(RUSAGE_SELF, &used);
    const Cost cost{cpuSeconds() - begin,
                    double(used.ru_stime.tv_sec) + 1e-6 * double(used.ru_stime.tv_usec),
                    double(to.tv_sec - from.tv_sec) + 1e-9 * double(to.tv_nsec - from.tv_nsec),
                    1024.0 * double(used.ru_maxrss)};
    ::_exit(::write(ends[1], &cost, sizeof cost) == sizeof cost ? 0 : 1);
  }
  ::close(ends[1]);
  Cost cost;
  int status = 0;
  if (::read(ends[0], &cost, sizeof cost) != sizeof cost || ::waitpid(child, &status, 0) != child)
    std::perror("child");
  ::close(ends[0]);
  return cost;
}

template <class Value>
Value median(std::vector<Value> values) {
  std::nth_element(values.begin(), values.begin() + long(values.size() / 2), values.end());
  return values[values.size() / 2];
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const Opening opening = inspectFile(argv[1], {}, {});
  const Session& session = opening.around.session;
  const std::unique_ptr<LightFieldFile> file = openLightField(session.lightField, session.display);
  // In memory a texel takes four bytes.
  const double pixels = 4.0 * double(file->size().width()) * double(file->size().height());
  std::vector<double> alone, kept, cpu, system, wall, peak;
  for (int k = 0; k < 7; ++k) {  // in turn
    alone.push_back(decode(file->files(), false));
    kept.push_back(decode(file->files(), true));
    const Cost cost = load(session);
    cpu.push_back(cost.cpu);
    system.push_back(cost.system);
    wall.push_back(cost.wall);
    peak.push_back(cost.peak);
  }
  std::printf("%zu files, %.0f MB of pixels\n", file->files().size(), 1e-6 * pixels);
  std::printf("libjpeg alone    %6.3f s of CPU, %.3f s with memory for all pictures\n",
              median(alone), median(kept));
  std::printf("opening          %6.3f s of CPU: %.2f and %.2f x; %.3f s of them the system's\n",
              median(cpu), median(cpu) / median(alone), median(cpu) / median(kept), median(system));
  std::printf("                 %6.3f s of wall\n", median(wall));
  std::printf("memory at most   %6.0f MB, %.2f x the pixels\n", 1e-6 * median(peak),
              median(peak) / pixels);
}
