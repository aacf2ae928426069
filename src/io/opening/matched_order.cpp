// SPDX-License-Identifier: BSD-3-Clause
#include "io/opening/matched_order.h"

#include <algorithm>
#include <array>
#include <set>

#include "io/images/image_file.h"
#include "io/images/image_inputs.h"
#include "io/layouts/layouts.h"
#include "io/opening/light_field_order.h"

namespace hogelscope {

namespace {

constexpr std::array scans{ViewScan::raster, ViewScan::serpentine, ViewScan::columns,
                           ViewScan::columnsSerpentine};

/// Reads the selected frame of an image; each value is the mean of a square of pixels.
SmallPicture smallOf(ImageFile& image, const Progress& progress) {
  constexpr std::size_t mostSide = 256;
  const std::size_t width = image.width();
  const std::size_t scale = (std::max(width, image.height()) + mostSide - 1) / mostSide;
  SmallPicture picture{int(width / scale), int(image.height() / scale), {}};
  picture.values.assign(std::size_t(picture.width) * std::size_t(picture.height), 0);
  const float part = 255 / float(3 * scale * scale);
  image.readRows(
      [&](std::size_t y, const float* rgb) {
        if (y / scale >= std::size_t(picture.height)) return;
        float* const row = &picture.values[y / scale * std::size_t(picture.width)];
        for (std::size_t x = 0; x < std::size_t(picture.width) * scale; ++x, rgb += 3)
          row[x / scale] += part * (rgb[0] + rgb[1] + rgb[2]);
      },
      progress);
  return picture;
}

/// Returns the mean squared difference.
double distanceOf(const SmallPicture& a, const SmallPicture& b) {
  double sum = 0;
  for (std::size_t k = 0; k < a.values.size(); ++k) {
    const double difference = double(a.values[k]) - double(b.values[k]);
    sum += difference * difference;
  }
  return sum / double(a.values.size());
}

double varianceOf(const SmallPicture& picture) {
  double sum = 0;
  double squares = 0;
  for (const float value : picture.values) {
    sum += double(value);
    squares += double(value) * double(value);
  }
  const auto count = double(picture.values.size());
  return squares / count - sum / count * (sum / count);
}

/// The places of some of a grid's lines: the outer ones, and some within.
std::set<int> placesIn(int count) {
  std::set<int> places{0, count - 1};
  for (const int inner : {1, count / 3})
    if (inner < count) places.insert({inner, count - 1 - inner});
  return places;
}

/// A picture of the test and, for each order, that of the reference at the same view; null if that
/// is missing.
struct Placed {
  const SmallPicture* test;
  std::vector<const SmallPicture*> reference;
};

/// Whether the test's views fit the reference's far better in the order `b` than in `a`. In `b` a
/// test is the reference and an error, |t − a|² − |t − b|² is then |a − b|² in the mean, however
/// large the error is; in `a` it is as much below 0. A codec that blurs leaves a part of it.
bool isFarBetter(const std::vector<Placed>& pictures, std::size_t a, std::size_t b) {
  constexpr double clearPart = 0.3;
  constexpr double mostVotes = 0.8;    // of the pictures
  constexpr double leastApart = 0.05;  // squared code values; equal views say nothing
  double gain = 0, apart = 0, rest = 0, variance = 0;
  int votes = 0;
  int count = 0;
  for (const Placed& one : pictures) {
    const SmallPicture* const inA = one.reference[a];
    const SmallPicture* const inB = one.reference[b];
    if (inA == inB || inA == nullptr || inB == nullptr) continue;
    const double between = distanceOf(*inA, *inB);
    const double own = distanceOf(*one.test, *inB);
    const double better = distanceOf(*one.test, *inA) - own;
    if (between < leastApart) continue;
    ++count;
    votes += better > 0 ? 1 : 0;
    gain += better;
    apart += between;
    rest += own;
    variance += varianceOf(*inB);
  }
  const bool isSameScene = rest < 0.5 * variance;
  return count > 0 && isSameScene && gain > clearPart * apart && votes >= mostVotes * count;
}

bool isOfViews(const LightFieldParams& params) {
  return params.layout == Layout::views && !isHdf5(params.file);
}

/// Returns the orders that there are, the one that is used first, then those that differ least.
std::vector<LightFieldParams> ordersOf(const LightFieldParams& used) {
  std::vector<LightFieldParams> orders;
  for (const ViewScan scan : scans)
    for (const RowOrder rows : {RowOrder::topDown, RowOrder::bottomUp})
      for (const ColumnOrder columns : {ColumnOrder::leftRight, ColumnOrder::rightLeft}) {
        orders.push_back(used);
        orders.back().scan = scan;
        orders.back().rows = rows;
        orders.back().columns = columns;
      }
  std::ranges::stable_sort(orders, {}, [&used](const LightFieldParams& order) {
    return int(order.scan != used.scan) + int(order.rows != used.rows) +
           int(order.columns != used.columns);
  });
  return orders;
}

/// Some of the test's pictures and, for each order, the reference's picture at the same view.
using PlacesInOrders = std::map<std::size_t, std::vector<std::optional<std::size_t>>>;

PlacesInOrders placesOf(const SmallViews& test, const std::vector<LightFieldParams>& orders,
                        const SmallViews& reference, const LightFieldParams& own) {
  PlacesInOrders places;
  for (const int v : placesIn(test.rows()))
    for (const int u : placesIn(test.columns()))
      if (const auto picture = test.pictureOf(orders.front(), u, v))
        places[*picture].resize(orders.size());
  for (std::size_t order = 0; order < orders.size(); ++order)
    for (int v = 0; v < test.rows(); ++v)
      for (int u = 0; u < test.columns(); ++u)
        if (const auto picture = test.pictureOf(orders[order], u, v);
            picture && places.contains(*picture))
          places[*picture][order] = reference.pictureOf(own, u, v);
  return places;
}

/// Reads the pictures, and returns them; none if they have several sizes.
std::vector<Placed> readPlaces(const PlacesInOrders& places, SmallViews& test,
                               SmallViews& reference, const Progress& progress) {
  std::set<std::size_t> tests, references;
  for (const auto& [picture, of] : places) {
    tests.insert(picture);
    for (const auto& one : of)
      if (one) references.insert(*one);
  }
  reference.read(references, part(progress, 0, 0.5));
  test.read(tests, part(progress, 0.5, 1));
  std::vector<Placed> pictures;
  for (const auto& [picture, of] : places) {
    Placed& one = pictures.emplace_back(Placed{&test.at(picture), {}});
    for (const auto& there : of) {
      one.reference.push_back(there ? &reference.at(*there) : nullptr);
      if (there && (one.reference.back()->width != one.test->width ||
                    one.reference.back()->height != one.test->height))
        return {};
    }
  }
  return pictures;
}

}  // namespace

SmallViews::SmallViews(const LightFieldParams& params, const DisplayParams& display)
    : m_params(params) {
  if (isViewSequence(params.file)) {
    const std::size_t frames = ImageFile(params.file, params.yuv).frames();
    for (const ViewScan scan : scans) {
      const SequenceGrid grid = gridOfSequence(frames, {params.file, {}, display.directions, scan});
      m_columns = int(grid.columns);
      m_rows = int(grid.rows);
      m_cells[scan].resize(frames);
      for (std::size_t frame = 0; frame < frames; ++frame)
        m_cells[scan][grid.cellOf(frame)] = frame;
    }
    return;
  }
  LightFieldParams scanned = params;
  for (const ViewScan scan : scans) {
    scanned.scan = scan;
    const ViewFiles views = findViews(scanned, display.directions);
    if (m_files.empty()) {
      m_columns = views.columns;
      m_rows = views.rows;
      for (const std::filesystem::path& file : views.files) m_files.push_back(file.string());
      std::ranges::sort(m_files);
    }
    for (const std::filesystem::path& file : views.files)
      m_cells[scan].push_back(
          std::size_t(std::ranges::lower_bound(m_files, file.string()) - m_files.begin()));
  }
}

std::optional<std::size_t> SmallViews::pictureOf(const LightFieldParams& params, int u,
                                                 int v) const {
  const bool isLeftwards = (params.columns == ColumnOrder::rightLeft) != params.incoming;
  const bool isUpwards = (params.rows == RowOrder::bottomUp) != params.incoming;
  const int column = isLeftwards ? m_columns - 1 - u : u;
  const int row = isUpwards ? m_rows - 1 - v : v;
  const std::size_t picture =
      m_cells.at(params.scan)[std::size_t(row) * std::size_t(m_columns) + std::size_t(column)];
  if (!m_files.empty() && m_files[picture].empty()) return std::nullopt;
  return picture;
}

void SmallViews::read(const std::set<std::size_t>& pictures, const Progress& progress) {
  std::optional<ImageFile> video;
  if (m_files.empty()) video.emplace(m_params.file, m_params.yuv);
  double done = 0;
  for (const std::size_t picture : pictures) {
    const auto count = double(pictures.size());
    const Progress own = part(progress, done / count, (done + 1) / count);
    ++done;
    if (m_read.contains(picture)) continue;
    if (video) {
      video->select(picture);
      m_read[picture] = smallOf(*video, own);
    } else {
      ImageFile image(m_files[picture], m_params.yuv);
      m_read[picture] = smallOf(image, own);
    }
  }
}

std::optional<LightFieldParams> OrderMatcher::match(const LightFieldParams& test,
                                                    const DisplayParams& display,
                                                    const Progress& progress) {
  if (!isOfViews(m_params) || !isOfViews(test)) return std::nullopt;
  if (!m_views) m_views.emplace(m_params, m_display);
  SmallViews views(test, display);
  if (views.columns() != m_views->columns() || views.rows() != m_views->rows()) return std::nullopt;
  const std::vector<LightFieldParams> orders = ordersOf(test);
  const std::vector<Placed> pictures =
      readPlaces(placesOf(views, orders, *m_views, m_params), views, *m_views, progress);
  std::size_t best = 0;
  for (std::size_t order = 1; order < orders.size(); ++order)
    if (isFarBetter(pictures, best, order)) best = order;
  if (best == 0 || !isFarBetter(pictures, 0, best)) return std::nullopt;
  return orders[best];
}

std::string orderText(const LightFieldParams& from, const LightFieldParams& to) {
  std::string text;
  const auto add = [&text](const char* field, const std::string& value) {
    text += (text.empty() ? "lightField." : " lightField.") + std::string(field) + "=" + value;
  };
  if (from.scan != to.scan) add("scan", nameOf(to.scan));
  if (from.rows != to.rows) add("rows", nameOf(to.rows));
  if (from.columns != to.columns) add("columns", nameOf(to.columns));
  return text;
}

}  // namespace hogelscope
