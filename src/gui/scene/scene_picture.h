// SPDX-License-Identifier: BSD-3-Clause
// Pictures of the 3-D scene of any size.
#pragma once

#include <QImage>
#include <QSize>

class vtkGenericOpenGLRenderWindow;

namespace hogelscope {

/// Draws the window's scene with `size` pixels, antialiased. Returns RGBA, premultiplied. Lines
/// keep their share of the image's height. The window is unchanged afterwards. Throws
/// InputError for sizes beyond OpenGL's limit.
QImage scenePicture(vtkGenericOpenGLRenderWindow& window, const QSize& size);

}  // namespace hogelscope
