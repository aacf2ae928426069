// SPDX-License-Identifier: BSD-3-Clause
#include "gui/scene/scene_picture.h"

#include <vtkActor.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkMapper.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPropCollection.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>
#include <vtkShaderProperty.h>
#include <vtkSmartPointer.h>
#include <vtkTextureObject.h>
#include <vtkUnsignedCharArray.h>
#include <algorithm>
#include <vector>

#include "core/base/error.h"
#include "gui/scene/scene_actor.h"
#include "io/files/system_limits.h"

namespace hogelscope {

namespace {

/// Returns the actors of all renderers, including those inside axes and other assemblies.
std::vector<vtkActor*> actorsOf(vtkRenderWindow& window) {
  const vtkNew<vtkPropCollection> actors;
  vtkRendererCollection* renderers = window.GetRenderers();
  renderers->InitTraversal();
  while (vtkRenderer* renderer = renderers->GetNextItem()) {
    vtkCollectionSimpleIterator at = nullptr;
    renderer->GetViewProps()->InitTraversal(at);
    while (vtkProp* prop = renderer->GetViewProps()->GetNextProp(at)) prop->GetActors(actors);
  }
  std::vector<vtkActor*> all;
  actors->InitTraversal();
  while (vtkProp* actor = actors->GetNextProp()) all.push_back(vtkActor::SafeDownCast(actor));
  return all;
}

bool hasLinesAlone(vtkActor* actor) {
  auto* data = vtkPolyData::SafeDownCast(
      actor->GetMapper() != nullptr ? actor->GetMapper()->GetInput() : nullptr);
  return data != nullptr && data->GetNumberOfLines() > 0 &&
         data->GetNumberOfLines() == data->GetNumberOfCells();
}

/// Scales line widths by `factor` during its lifetime. Plain lines are limited to one pixel, so
/// lines become tubes, without lighting, which would shade one of their sides.
class ThickerLines {
 public:
  ThickerLines(vtkRenderWindow& window, double factor) {
    for (vtkActor* actor : actorsOf(window)) {
      if (!hasLinesAlone(actor)) continue;
      if (actor->GetShaderProperty()->GetNumberOfShaderReplacements() == 0)
        setDepth(actor, SceneLevel::onPanel);
      vtkProperty* look = actor->GetProperty();
      m_before.push_back(
          {look, look->GetLineWidth(), look->GetRenderLinesAsTubes(), look->GetLighting()});
    }
    for (const Look& look : m_before) {
      look.property->SetLineWidth(float(factor) * look.width);
      look.property->RenderLinesAsTubesOn();
      look.property->LightingOff();
    }
  }
  ~ThickerLines() {
    for (const Look& look : m_before) {
      look.property->SetLineWidth(look.width);
      look.property->SetRenderLinesAsTubes(look.areTubes);
      look.property->SetLighting(look.isLit);
    }
  }
  ThickerLines(const ThickerLines&) = delete;
  ThickerLines& operator=(const ThickerLines&) = delete;

 private:
  struct Look {
    vtkSmartPointer<vtkProperty> property;
    float width;
    bool areTubes;
    bool isLit;
  };
  std::vector<Look> m_before;
};

/// Returns the samples per pixel: 4, the most in software, at 8 bytes each; none for a large image.
int samplesFor(const QSize& size) {
  constexpr int largest = 4096;
  return std::max(size.width(), size.height()) <= largest ? 4 : 0;
}

}  // namespace

QImage scenePicture(vtkGenericOpenGLRenderWindow& window, const QSize& size) {
  constexpr std::size_t bytesPerPixel = 24;  // colour, depth and their copies
  checkFits(double(bytesPerPixel) * size.width() * size.height(), "the scene's picture",
            "choose a smaller size");
  window.MakeCurrent();
  const int largest = vtkTextureObject::GetMaximumTextureSize(&window);
  if (std::max(size.width(), size.height()) > largest)
    throw InputError("the scene's picture", "size",
                     "OpenGL ends at " + std::to_string(largest) + " px here");
  const int* own = window.GetSize();
  const QSize before(own[0], own[1]);
  const double factor = double(size.height()) / std::max(1, before.height());
  const ThickerLines lines(window, factor);
  window.SetSize(size.width(), size.height());
  window.SetMultiSamples(samplesFor(size));
  window.Render();
  const vtkNew<vtkUnsignedCharArray> rgba;
  window.GetRGBACharPixelData(0, 0, size.width() - 1, size.height() - 1, 0, rgba.Get(), 0);
  window.SetMultiSamples(0);
  window.SetSize(before.width(), before.height());
  return QImage(rgba->GetPointer(0), size.width(), size.height(),
                QImage::Format_RGBA8888_Premultiplied)
      .mirrored();  // OpenGL's first row is the lowest
}

}  // namespace hogelscope
