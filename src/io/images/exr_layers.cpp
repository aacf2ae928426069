// SPDX-License-Identifier: BSD-3-Clause
#include "io/images/exr_layers.h"

#include <algorithm>
#include <string_view>

#include "core/base/text.h"

namespace hogelscope {

namespace {

/// The channels of a layer by their names; -1: none.
struct Layer {
  std::string name;     ///< "" for channels without a layer
  bool isRoot = false;  ///< the channels' names have no layer; a part may have a name
  std::size_t part = 0;
  std::array<int, 3> rgb{-1, -1, -1};
  int luminance = -1;
  int first = 0;
  int count = 0;
  std::vector<std::string> others{};  ///< channels that are neither colours nor alpha

  [[nodiscard]] bool hasColours() const { return std::ranges::min(rgb) >= 0; }
  /// Whether it has Y, as luminance and not as a coordinate.
  [[nodiscard]] bool isGrey() const {
    return luminance >= 0 &&
           std::ranges::none_of(others, [](const auto& other) { return lowerCase(other) == "x"; });
  }
};

std::vector<std::string> wordsOf(const std::string& name) {
  std::vector<std::string> words(1);
  for (const char letter : lowerCase(name)) {
    if (letter == '.')
      words.emplace_back();
    else
      words.back() += letter;
  }
  return words;
}

template <std::size_t count>
bool hasWord(const Layer& layer, const std::array<std::string_view, count>& known) {
  return std::ranges::any_of(wordsOf(layer.name), [&](const std::string& word) {
    return std::ranges::find(known, word) != known.end();
  });
}

bool isWholePicture(const Layer& layer) {
  static constexpr std::array<std::string_view, 11> names{
      "combined",  "beauty", "rgba", "rgb", "color", "colour",
      "composite", "image",  "ci",   "c",   "final"};
  return hasWord(layer, names);
}

bool isRightView(const Layer& layer) {
  return hasWord(layer, std::array<std::string_view, 1>{"right"});
}

/// Adds channel `index` to its layer.
void addChannel(Layer& layer, const std::string& word, int index) {
  static constexpr std::array<std::array<std::string_view, 2>, 3> colours{
      {{"r", "red"}, {"g", "green"}, {"b", "blue"}}};
  const std::string name = lowerCase(word);
  if (layer.count++ == 0) layer.first = index;
  for (std::size_t c = 0; c < 3; ++c)
    if (std::ranges::find(colours[c], name) != colours[c].end() && layer.rgb[c] < 0) {
      layer.rgb[c] = index;
      return;
    }
  static constexpr std::array<std::string_view, 5> alphas{"a", "alpha", "ar", "ag", "ab"};
  if (name == "y" && layer.luminance < 0)
    layer.luminance = index;
  else if (std::ranges::find(alphas, name) == alphas.end())
    layer.others.push_back(word);
}

std::vector<Layer> layersOf(const std::vector<PicturePart>& parts) {
  std::vector<Layer> layers;
  for (std::size_t part = 0; part < parts.size(); ++part) {
    const std::string own = parts.size() > 1 ? parts[part].name : "";
    const std::size_t begin = layers.size();
    for (std::size_t c = 0; c < parts[part].channels.size(); ++c) {
      const std::string& channel = parts[part].channels[c];
      const std::size_t dot = channel.rfind('.');
      const bool isRoot = dot == std::string::npos;
      std::string name = isRoot ? "" : channel.substr(0, dot);
      if (!own.empty() && !name.starts_with(own)) {
        if (!name.empty()) name.insert(0, ".");
        name.insert(0, own);
      }
      auto layer = std::ranges::find(layers.begin() + std::ptrdiff_t(begin), layers.end(), name,
                                     &Layer::name);
      if (layer == layers.end())
        layer = layers.insert(layer, Layer{.name = name, .isRoot = isRoot, .part = part});
      addChannel(*layer, isRoot ? channel : channel.substr(dot + 1), int(c));
    }
  }
  return layers;
}

std::string nameOf(const Layer& layer, const std::vector<PicturePart>& parts) {
  if (!layer.name.empty()) return layer.name;
  return parts.size() > 1 ? "part " + std::to_string(layer.part + 1) : "R, G, B";
}

std::string listOf(const std::vector<Layer>& layers, const Layer* without,
                   const std::vector<PicturePart>& parts) {
  constexpr std::size_t most = 8;
  std::string list;
  std::size_t count = 0;
  for (const Layer& layer : layers)
    if (&layer != without && ++count <= most)
      list += (list.empty() ? "" : ", ") + printable(nameOf(layer, parts));
  return count > most ? list + ", …" : list;
}

/// Returns the layer that is the picture; null if that is unclear.
const Layer* pictureOf(const std::vector<Layer>& layers) {
  std::vector<const Layer*> coloured;
  for (const Layer& layer : layers)
    if (layer.hasColours()) coloured.push_back(&layer);
  const auto find = [&](const auto& is) {
    const auto found = std::ranges::find_if(coloured, is);
    return found == coloured.end() ? nullptr : *found;
  };
  const Layer* const root = find([](const Layer* layer) { return layer->isRoot; });
  if (root != nullptr && root->name.empty()) return root;
  for (const bool mayBeRight : {false, true})
    if (const Layer* whole = find([&](const Layer* layer) {
          return isWholePicture(*layer) && (mayBeRight || !isRightView(*layer));
        }))
      return whole;
  if (coloured.size() > 1)
    std::erase_if(coloured, [](const Layer* layer) { return isRightView(*layer); });
  // Programs number parts that have no names.
  if (root != nullptr && lowerCase(root->name).starts_with("subimage")) return root;
  if (!coloured.empty()) return coloured.size() == 1 ? coloured[0] : nullptr;
  const auto grey = std::ranges::find_if(layers, &Layer::isGrey);
  if (grey != layers.end()) return &*grey;
  return layers.size() == 1 ? layers.data() : nullptr;
}

}  // namespace

ChosenLayer chosenLayer(const std::vector<PicturePart>& parts) {
  const std::vector<Layer> layers = layersOf(parts);
  ChosenLayer chosen;
  const Layer* const picture = pictureOf(layers);
  if (picture == nullptr) {
    chosen.refusal =
        "has several layers, of which none is called Combined, beauty or rgba: keep the picture's "
        "alone of " +
        listOf(layers, nullptr, parts);
    return chosen;
  }
  chosen.part = picture->part;
  if (picture->hasColours())
    chosen.channels = picture->rgb;
  else if (picture->isGrey())
    chosen.channels.fill(picture->luminance);
  else if (picture->count < 3)
    chosen.channels.fill(picture->first);
  const bool areFirst = chosen.channels == std::array{0, 1, 2} ||
                        (picture->count < 3 && chosen.channels == std::array{0, 0, 0});
  chosen.isDefault = chosen.part == 0 && areFirst;
  if (layers.size() > 1)
    chosen.note = "has the layers or parts " + listOf(layers, picture, parts) + " beside " +
                  printable(nameOf(*picture, parts)) + ", which is read";
  else if (picture->hasColours() && !picture->others.empty())
    chosen.note = "has the channel " + printable(picture->others[0]) +
                  (picture->others.size() > 1 ? " and others" : "") +
                  " beside its colours, which are read";
  return chosen;
}

}  // namespace hogelscope
