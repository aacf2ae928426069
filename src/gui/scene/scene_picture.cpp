// SPDX-License-Identifier: BSD-3-Clause
// The 3-D scene as a picture of any size.
#include "gui/scene/scene_picture.h"

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkOpenGLState.h>
#include <vtkPropCollection.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>
#include <vtkTextureObject.h>
#include <vtkUnsignedCharArray.h>

#include <qopengl.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "core/base/error.h"

namespace hogelscope {

namespace {

constexpr int samples = 4;  // of a pixel: all that software has

/// The actors of all renderers, those inside axes and the like too.
void forActors(vtkRenderWindow& window, const std::function<void(vtkActor*)>& visit) {
  const vtkNew<vtkPropCollection> actors;
  vtkRendererCollection* renderers = window.GetRenderers();
  renderers->InitTraversal();
  while (vtkRenderer* renderer = renderers->GetNextItem()) {
    vtkPropCollection* props = renderer->GetViewProps();
    vtkCollectionSimpleIterator at = nullptr;
    props->InitTraversal(at);
    while (vtkProp* prop = props->GetNextProp(at)) prop->GetActors(actors);
  }
  actors->InitTraversal();
  while (vtkProp* actor = actors->GetNextProp()) visit(vtkActor::SafeDownCast(actor));
}

void scaleLines(vtkRenderWindow& window, double factor) {
  forActors(window, [factor](vtkActor* actor) {
    vtkProperty* look = actor->GetProperty();
    look->SetLineWidth(float(factor) * look->GetLineWidth());
  });
}

std::vector<std::uint8_t> topFirst(vtkUnsignedCharArray& rgb, const QSize& size) {
  const auto row = 3 * std::ptrdiff_t(size.width());
  std::vector<std::uint8_t> picture;
  picture.reserve(std::size_t(row) * std::size_t(size.height()));
  for (int y = size.height() - 1; y >= 0; --y) {
    const std::uint8_t* from = rgb.GetPointer(row * y);
    picture.insert(picture.end(), from, from + row);
  }
  return picture;
}

}  // namespace

std::vector<std::uint8_t> scenePicture(vtkGenericOpenGLRenderWindow& window, const QSize& size) {
  window.MakeCurrent();
  const int largest = vtkTextureObject::GetMaximumTextureSize(&window);
  if (std::max(size.width(), size.height()) > largest)
    throw InputError("the scene's picture", "size",
                     "OpenGL ends at " + std::to_string(largest) + " px here");
  const int* own = window.GetSize();
  const QSize before(own[0], own[1]);
  const int dpi = window.GetDPI();
  const double factor = double(size.height()) / std::max(1, before.height());
  vtkOpenGLState* state = window.GetState();
  state->Reset();
  state->Push();
  state->vtkglDepthFunc(GL_LEQUAL);
  scaleLines(window, factor);
  window.SetSize(size.width(), size.height());
  window.SetDPI(std::max(1, int(std::lround(dpi * factor))));
  window.SetMultiSamples(samples);
  window.Render();
  const vtkNew<vtkUnsignedCharArray> rgb;
  window.GetPixelData(0, 0, size.width() - 1, size.height() - 1, 0, rgb.Get(), 0);
  scaleLines(window, 1 / factor);
  window.SetMultiSamples(0);
  window.SetDPI(dpi);
  window.SetSize(before.width(), before.height());
  state->Pop();
  return topFirst(*rgb, size);
}

}  // namespace hogelscope
