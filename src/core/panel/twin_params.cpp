// SPDX-License-Identifier: BSD-3-Clause
#include "core/panel/twin_params.h"

namespace hogelscope {

namespace {
constexpr std::array<std::string_view, 2> outsideNames{"dark", "neighbour"};
constexpr std::array<std::string_view, 4> eotfNames{"srgb", "gamma22", "gamma24", "linear"};
constexpr Range smallPart{-0.9, 9, 0.001, false, -0.05, 0.05};
}  // namespace

void describe(ParameterVisitor& v, LensArrayErrors& p) {
  auto& [offset, rotation, pitchError, gapError, wedge, focalError, outside] = p;
  v.group("twin.lensArray", "The sheet of hogel lenses, as it was mounted on this unit.");
  v.field("offset", offset, {-1, 1, 1e-6, false, -1e-4, 1e-4}, "m",
          "How far the sheet lies right and up of where it should.");
  v.field("rotation", rotation, {-45, 45, 0.01, false, -0.5, 0.5}, "°",
          "How far it is turned about the panel's middle, counter-clockwise for the viewer.");
  v.field("pitchError", pitchError, {-0.5, 1, 1e-5, false, -0.01, 0.01}, "",
          "Relative error of the pitch of its lenses, across and down; 0.01: 1 % too wide.");
  v.field(
      "gapError", gapError, smallPart, "",
      "Relative error of the gap between pixels and lenses; 0.01: 1 % too large, which stretches "
      "depth.");
  v.field("wedge", wedge, smallPart, "",
          "Gap error that grows from side to side: its difference from left to right, and from "
          "bottom to top.");
  v.field(
      "focalError", focalError, smallPart, "",
      "Relative error of the focal length; 0.01: 1 % too long, so the lenses are out of focus.");
  v.field("outside", outside, outsideNames,
          "Light for which the hogel has no pixel: none, or that of the neighbour's pixel, as side "
          "lobes have it.");
}

void describe(ParameterVisitor& v, ColourErrors& p) {
  auto& [scale, wavelengths] = p;
  v.group("twin.colour", "How the colours of this unit differ.");
  v.field("scale", scale, {-0.5, 0.5, 0.001, false, -0.05, 0.05}, "",
          "Relative error of the slopes of red, green and blue; 0.01: 1 % smaller.");
  v.field("wavelengths", wavelengths, {0, 1e-5, 1e-9, false, 0, 1e-6}, "m",
          "Of red, green and blue, for diffraction at the hogel's square lens; 0: none.");
}

void describe(ParameterVisitor& v, LeakageErrors& p) {
  v.group("twin.leakage", "How light leakage differs over the field of this unit.");
  v.field("sigmaGrowth", p.sigmaGrowth, {0, 100, 0.1, false, 0, 3}, "",
          "k of psf.sigma·(1 + k·ρ²): ρ is 0 in the middle of the field and 1 at its sides.");
}

void describe(ParameterVisitor& v, LightErrors& p) {
  auto& [black, ambient, falloff, bits, eotf, fill] = p;
  v.group("twin.light", "The light of this unit; it needs psf.light \"linear\".");
  v.field("black", black, {0, 1, 0.001, false, 0, 0.02}, "",
          "Light of a black pixel, as a part of white.");
  v.field("ambient", ambient, {0, 10, 0.001, false, 0, 0.1}, "",
          "Light of the room that the panel reflects, as a part of white: red, green, blue.");
  v.field("falloff", falloff, {0, 16, 0.1, false, 0, 4}, "",
          "n: light falls with cosⁿ of the angle of its direction.");
  v.field("bits", bits, {0, 16, 1, false, 0, 10}, "bit",
          "Bits of the panel's code values; 0: as many as the light field has.");
  v.field({"eotf", "Transfer function"}, eotf, eotfNames,
          "How light follows from the panel's code values; pictures stay sRGB.");
  v.field("fill", fill, {0.01, 1, 0.01}, "",
          "The part of a directional pixel that sends light, across and down; the rest is the "
          "black matrix.");
}

void describe(ParameterVisitor& v, TwinRandom& p) {
  v.group("twin.random", "Errors of single hogels that are drawn.");
  v.field("seed", p.seed, {0, 2147483647, 1}, "",
          "Of the random numbers: the same seed gives the same unit.");
}

void describe(ParameterVisitor& v, TwinMapFiles& p) {
  auto& [hogels, directions, kernels, kernelTiles, height] = p;
  v.group("twin.maps", "Files of what was measured on this unit.");
  v.field("hogels", hogels,
          "EXR with a value for each hogel: shift.x, shift.y (m), tilt.x, tilt.y (slopes), gap, "
          "gain.R, gain.G, gain.B.");
  v.field("directions", directions,
          "EXR with a value for each direction: move.u, move.v (px), sigma (px), gain.R, gain.G, "
          "gain.B; or CSV: u,v,x,y,r,g,b.");
  v.field("kernels", kernels,
          "Image of square kernels of leakage over the field, side by side, each an odd number of "
          "directional pixels wide; in place of psf.");
  v.field("kernelTiles", kernelTiles, {1, 1024, 1}, "",
          "How many kernels the image has across, and as many down.");
  v.field("height", height, "EXR with the height of the panel's surface, metres.");
}

namespace {
void describeDraw(ParameterVisitor& v, RandomErrors& p, const char* unit, double usual) {
  v.field("sigma", p.sigma, {0, 1, 1e-6, false, 0, usual}, unit, "Standard deviation.");
  v.field("length", p.length, {0, 1000, 0.1, false, 0, 20}, "hogels",
          "Distance at which the draws of two hogels are correlated by 1/e; 0: independent.");
}
}  // namespace

void describe(ParameterVisitor& v, RandomShift& p) {
  v.group("twin.random.shift", "Drawn shifts of each hogel's lens, across and down.");
  describeDraw(v, p, "m", 1e-4);
}

void describe(ParameterVisitor& v, RandomGain& p) {
  v.group("twin.random.gain", "Drawn gains of each hogel, of all colours together.");
  describeDraw(v, p, "", 0.1);
}

std::vector<std::string*> TwinMapFiles::files() {
  std::vector<std::string*> given;
  for (std::string* const file : {&hogels, &directions, &kernels, &height})
    if (!file->empty()) given.push_back(file);
  return given;
}

bool TwinParams::isZero() const {
  TwinParams designed;
  designed.random.seed = random.seed;
  designed.random.shift.length = random.shift.length;
  designed.random.gain.length = random.gain.length;
  designed.maps.kernelTiles = maps.kernelTiles;
  return *this == designed;
}

}  // namespace hogelscope
