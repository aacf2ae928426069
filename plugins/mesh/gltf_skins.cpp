// SPDX-License-Identifier: BSD-3-Clause
#include "gltf_skins.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>

namespace hogelscope::mesh {

namespace {

constexpr std::size_t inSet = 4;     // joints in an attribute
constexpr std::size_t mostSets = 8;  // of attributes

/// The accessors of a primitive's joints and of their weights.
struct BindingSet {
  std::size_t joints;
  std::size_t weights;
};

std::vector<BindingSet> setsOf(const GltfData& data, const Json& attributes) {
  std::vector<BindingSet> sets;
  for (std::size_t k = 0; k < mostSets; ++k) {
    const std::string number = std::to_string(k);
    const BindingSet set{data.index(attributes, ("JOINTS_" + number).c_str()),
                         data.index(attributes, ("WEIGHTS_" + number).c_str())};
    if (set.joints == GltfData::none && set.weights == GltfData::none) break;
    if (set.joints == GltfData::none || set.weights == GltfData::none)
      data.fail("a primitive",
                "has JOINTS_" + number + " or WEIGHTS_" + number + " without the other");
    sets.push_back(set);
  }
  return sets;
}

}  // namespace

Skin readSkin(const GltfData& data, const GltfNodes& nodes, std::size_t skin) {
  const Json& object = data.entry("skins", skin);
  const std::string name = named("skins", skin);
  const auto joints = object.find("joints");
  if (joints == object.end() || !joints->is_array() || joints->empty())
    data.fail(name, "has no list of joints");
  Skin read;
  for (const Json& joint : *joints) {
    const std::size_t place =
        joint.is_number_unsigned() ? nodes.placeOf(joint.get<std::size_t>()) : GltfNodes::none;
    if (place == GltfNodes::none) data.fail(name, "has a joint that is no node of the scene");
    read.joints.push_back(place);
  }
  data.reading().take(double(read.joints.size()) * (sizeof(std::size_t) + 2 * sizeof(Affine)));
  read.toJoint.resize(read.joints.size());
  const std::size_t accessor = data.index(object, "inverseBindMatrices");
  if (accessor == GltfData::none) return read;
  data.reading().take(data.bytes(accessor));
  const Numbers matrices = data.numbers(accessor);
  if (matrices.components != 16 || matrices.rows() < read.joints.size())
    data.fail(named("accessors", accessor), "is not a matrix for each joint of " + name);
  for (std::size_t k = 0; k < read.joints.size(); ++k)
    read.toJoint[k] = affineOf(&matrices.values[k * matrices.components]);
  return read;
}

double bytesOfBinding(const GltfData& data, const Json& attributes) {
  double sum = 0;
  for (const auto& [joints, weights] : setsOf(data, attributes))
    sum += 2 * (data.bytes(joints) + data.bytes(weights));
  return sum;
}

Binding readBinding(const GltfData& data, const Json& attributes, std::size_t points,
                    const Skin& skin) {
  const std::vector<BindingSet> sets = setsOf(data, attributes);
  Binding binding;
  binding.each = inSet * sets.size();
  binding.joints.resize(binding.each * points);
  binding.weights.resize(binding.each * points);
  for (std::size_t s = 0; s < sets.size(); ++s) {
    const std::vector<std::uint32_t> joints = data.indices(sets[s].joints, inSet);
    const Numbers weights = data.numbers(sets[s].weights);
    if (weights.components != inSet || weights.rows() != points || joints.size() != inSet * points)
      data.fail(named("accessors", sets[s].weights),
                "does not fit the points as weights of joints");
    for (std::size_t k = 0; k < joints.size(); ++k) {
      const std::size_t to = k / inSet * binding.each + s * inSet + k % inSet;
      const float weight = weights.values[k];
      if (!(weight >= 0 && std::isfinite(weight)))
        data.fail(named("accessors", sets[s].weights), "has a weight that is below 0 or NaN");
      if (weight > 0 && joints[k] >= skin.joints.size())
        data.fail(named("accessors", sets[s].joints), "names joint " + std::to_string(joints[k]) +
                                                          " of " +
                                                          std::to_string(skin.joints.size()));
      binding.joints[to] = weight > 0 ? joints[k] : 0;
      binding.weights[to] = weight;
    }
  }
  for (std::size_t k = 0; k < binding.weights.size(); k += binding.each) {
    const auto first = binding.weights.begin() + std::ptrdiff_t(k);
    const auto last = first + std::ptrdiff_t(binding.each);
    const double sum = std::accumulate(first, last, 0.0);
    if (sum > 0)
      std::for_each(first, last, [sum](float& weight) { weight = float(weight / sum); });
    else
      *first = 1;
  }
  return binding;
}

std::vector<Affine> jointFrames(const Skin& skin, const std::vector<Affine>& frames) {
  std::vector<Affine> moved;
  moved.reserve(skin.joints.size());
  for (std::size_t k = 0; k < skin.joints.size(); ++k)
    moved.push_back(frames[skin.joints[k]] * skin.toJoint[k]);
  return moved;
}

Affine frameOf(const Binding& binding, std::size_t point, const std::vector<Affine>& jointFrames) {
  Affine mean{{Vec3{}, Vec3{}, Vec3{}}, {}};
  for (std::size_t k = point * binding.each; k < (point + 1) * binding.each; ++k) {
    const double weight = binding.weights[k];
    if (weight == 0) continue;
    const Affine& frame = jointFrames[binding.joints[k]];
    for (std::size_t axis = 0; axis < 3; ++axis)
      mean.axes[axis] = mean.axes[axis] + weight * frame.axes[axis];
    mean.origin = mean.origin + weight * frame.origin;
  }
  return mean;
}

}  // namespace hogelscope::mesh
