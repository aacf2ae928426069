// SPDX-License-Identifier: BSD-3-Clause
// The 3-D scene as an image of any size.
// It is drawn by the scene's own window at another size, in the widget's context: VTK's actors
// belong to one context.
#pragma once

#include <QSize>
#include <cstdint>
#include <vector>

class vtkGenericOpenGLRenderWindow;

namespace hogelscope {

/// Draws the window's scene with `size` pixels, antialiased. Returns 3·width·height bytes of RGB,
/// row 0 at the top. Lines and texts keep their share of the image's height. The window is
/// unchanged afterwards. Throws InputError for sizes beyond OpenGL's limit.
std::vector<std::uint8_t> scenePicture(vtkGenericOpenGLRenderWindow& window, const QSize& size);

}  // namespace hogelscope
