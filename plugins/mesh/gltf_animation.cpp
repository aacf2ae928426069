// SPDX-License-Identifier: BSD-3-Clause
#include "gltf_animation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "errors.h"

namespace hogelscope::mesh {

namespace {

template <std::size_t N>
using Row = std::array<double, N>;

Row<4> unit(Row<4> q) {
  const double length = std::hypot(std::hypot(q[0], q[1]), std::hypot(q[2], q[3]));
  if (length > 0)
    for (double& x : q) x /= length;
  return q;
}

template <std::size_t N>
Row<N> mixed(const Row<N>& a, double ofA, const Row<N>& b, double ofB) {
  Row<N> mean{};
  for (std::size_t k = 0; k < N; ++k) mean[k] = ofA * a[k] + ofB * b[k];
  return mean;
}

/// Translations and scales move along a line, rotations along the shorter arc between them.
Row<3> between(const Row<3>& a, const Row<3>& b, double part) {
  return mixed(a, 1 - part, b, part);
}

Row<4> between(const Row<4>& from, const Row<4>& to, double part) {
  const Row<4> a = unit(from), b = unit(to);
  const double cosine = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
  const double sign = cosine < 0 ? -1 : 1;
  const double angle = std::acos(std::min(std::abs(cosine), 1.0));
  constexpr double least = 1e-6;  // below it the arc is a line to double precision
  if (angle < least) return mixed(a, 1 - part, b, sign * part);
  return mixed(a, std::sin((1 - part) * angle) / std::sin(angle), b,
               sign * std::sin(part * angle) / std::sin(angle));
}

std::string nameOf(const Json& animation) {
  const auto name = animation.find("name");
  return name != animation.end() && name->is_string() ? name->get<std::string>() : std::string();
}

/// Returns the animation of a name, else of a number.
const Json& findAnimation(const GltfData& data, const std::string& nameOrNumber) {
  const std::size_t count = data.listAt("animations").size();
  std::string others;
  for (std::size_t k = 0; k < count; ++k) {
    const Json& animation = data.entry("animations", k);
    if (nameOf(animation) == nameOrNumber) return animation;
    constexpr std::size_t most = 20;
    if (k < most) others += (k == 0 ? "" : ", ") + std::to_string(k);
    if (k < most && !nameOf(animation).empty()) others += " (" + shortName(nameOf(animation)) + ")";
    if (k == most) others += ", …";
  }
  constexpr std::size_t mostDigits = 6;
  const bool isNumber =
      nameOrNumber.size() <= mostDigits &&
      std::ranges::all_of(nameOrNumber, [](char c) { return c >= '0' && c <= '9'; });
  if (isNumber && std::stoul(nameOrNumber) < count)
    return data.entry("animations", std::stoul(nameOrNumber));
  data.fail("has no animation " + shortName(nameOrNumber),
            count == 0 ? "it has none: leave mesh.animation empty" : "it has " + others);
}

}  // namespace

GltfAnimation::GltfAnimation(const GltfData& data, const GltfNodes& nodes,
                             const std::string& nameOrNumber) {
  const Json& animation = findAnimation(data, nameOrNumber);
  const auto channels = animation.find("channels");
  if (channels == animation.end() || !channels->is_array())
    data.fail("animation " + shortName(nameOrNumber), "has no list of channels");
  for (const Json& channel : *channels) {
    data.reading().poll();
    if (!channel.is_object()) data.fail("an animation's channel", "is no object");
    readChannel(data, nodes, animation, channel);
  }
}

void GltfAnimation::readChannel(const GltfData& data, const GltfNodes& nodes, const Json& animation,
                                const Json& channel) {
  static constexpr std::array<std::pair<const char*, std::size_t>, 3> paths{
      {{"translation", 3}, {"rotation", 4}, {"scale", 3}}};
  static constexpr std::array<const char*, 3> interpolations{"LINEAR", "STEP", "CUBICSPLINE"};
  const std::string what = "an animation's channel";
  const Json& target = GltfData::part(channel, "target");
  const auto path = std::ranges::find_if(paths, [&](const auto& known) {
    return target.contains("path") && target["path"] == known.first;
  });
  const std::size_t number = data.index(target, "node");
  m_movesOthers = m_movesOthers || path == paths.end();
  if (path == paths.end() || number == GltfData::none) return;
  if (number >= data.listAt("nodes").size())
    data.fail(what, "moves node " + std::to_string(number) + ", which is not there");
  const std::size_t place = nodes.placeOf(number);
  if (place == GltfNodes::none) return;  // of a scene that is not shown
  if (nodes.rest()[place].matrix)
    data.fail(what, "moves " + named("nodes", number) +
                        ", which has a matrix: export its "
                        "translation, rotation and scale");

  const auto samplers = animation.find("samplers");
  const std::size_t sampler = data.index(channel, "sampler");
  if (samplers == animation.end() || !samplers->is_array() || sampler >= samplers->size() ||
      !(*samplers)[sampler].is_object())
    data.fail(what, "names a sampler that is not there");
  const Json& sampling = (*samplers)[sampler];
  const std::size_t input = data.index(sampling, "input");
  const std::size_t output = data.index(sampling, "output");
  if (input == GltfData::none || output == GltfData::none)
    data.fail("an animation's sampler", "needs input and output");
  Channel read;
  read.node = place;
  read.path = Path(path - paths.begin());
  if (const auto name = sampling.find("interpolation"); name != sampling.end()) {
    const auto known = std::ranges::find_if(interpolations, [&](auto one) { return *name == one; });
    if (known == interpolations.end())
      data.fail("an animation's sampler", "its interpolation must be LINEAR, STEP or CUBICSPLINE");
    read.interpolation = Interpolation(known - interpolations.begin());
  }
  data.reading().take(data.bytes(input) + data.bytes(output));
  const Numbers times = data.numbers(input);
  read.values = data.numbers(output);
  const std::size_t rows = read.interpolation == Interpolation::cubicSpline ? 3 : 1;
  if (times.components != 1 || read.values.components != path->second ||
      read.values.rows() != rows * times.rows())
    data.fail(named("accessors", output), "does not fit the times as " + std::string(path->first));
  const auto isFinite = [](float x) { return std::isfinite(x); };
  const auto isNotLater = [](float a, float b) { return !(a < b); };
  if (!std::ranges::all_of(times.values, isFinite) || !(times.values.front() >= 0) ||
      std::ranges::adjacent_find(times.values, isNotLater) != times.values.end())
    data.fail(named("accessors", input), "its times must grow, from 0 or later");
  if (!std::ranges::all_of(read.values.values, isFinite))
    data.fail(named("accessors", output), "has a value that is NaN or infinite");
  read.times = times.values;
  m_duration = std::max(m_duration, double(read.times.back()));
  m_channels.push_back(std::move(read));
}

template <std::size_t N>
std::array<double, N> GltfAnimation::Channel::at(double seconds) const {
  const bool isSpline = interpolation == Interpolation::cubicSpline;
  const auto row = [&](std::size_t k) {
    Row<N> numbers{};
    for (std::size_t c = 0; c < N; ++c) numbers[c] = values.values[k * N + c];
    return numbers;
  };
  const auto value = [&](std::size_t key) { return row(isSpline ? 3 * key + 1 : key); };
  const auto next = std::size_t(std::ranges::upper_bound(times, seconds) - times.begin());
  if (next == 0) return value(0);
  if (next == times.size() || interpolation == Interpolation::step) return value(next - 1);
  const double from = times[next - 1];
  const double length = times[next] - from;
  const double u = (seconds - from) / length;
  if (!isSpline) return between(value(next - 1), value(next), u);
  const Row<N> ends =
      mixed(value(next - 1), (2 * u - 3) * u * u + 1, value(next), (3 - 2 * u) * u * u);
  const Row<N> tangents = mixed(row(3 * next - 1), length * u * (u - 1) * (u - 1), row(3 * next),
                                length * u * u * (u - 1));
  return mixed(ends, 1, tangents, 1);
}

void GltfAnimation::apply(double seconds, std::vector<NodePose>& poses) const {
  for (const Channel& channel : m_channels) {
    NodePose& pose = poses[channel.node];
    if (channel.path == Path::translation) pose.translation = channel.at<3>(seconds);
    if (channel.path == Path::rotation) pose.rotation = channel.at<4>(seconds);
    if (channel.path == Path::scale) pose.scale = channel.at<3>(seconds);
  }
}

}  // namespace hogelscope::mesh
