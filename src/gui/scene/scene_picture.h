// SPDX-License-Identifier: BSD-3-Clause
// The 3-D scene as a picture of any size.
#pragma once

#include <QSize>
#include <cstdint>
#include <vector>

class vtkGenericOpenGLRenderWindow;

namespace hogelscope {

/// Draws what the window shows with so many pixels, without jagged edges; returns 3·width·height
/// bytes of RGB, row 0 at the top. Lines and texts keep their share of the picture's height. The
/// window itself is left as it was. Throws InputError beyond what OpenGL can draw here.
std::vector<std::uint8_t> scenePicture(vtkGenericOpenGLRenderWindow& window, const QSize& size);

}  // namespace hogelscope
