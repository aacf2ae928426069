// consumer SESSION STATE PICTURE.png: renders a state of a session with the installed VTK module
// and with the installed renderer, writes the picture, and fails where the two differ.
#include <vtkHogelViewFilter.h>
#include <vtkImageData.h>
#include <vtkNew.h>

#include <cstdio>
#include <exception>

#include <hogelscope/core/engine/renderer.h>
#include <hogelscope/io/documents/session_file.h>
#include <hogelscope/io/images/image_writer.h>
#include <hogelscope/io/scene/view_source.h>

namespace {

bool isEqual(const hogelscope::Image& image, vtkImageData* output) {
  for (int row = 0; row < image.height; ++row)
    for (int column = 0; column < image.width; ++column)
      for (int c = 0; c < 3; ++c)  // VTK's row 0 is the bottom
        if (image.rgb[(std::size_t(row) * image.width + column) * 3 + c] !=
            output->GetScalarComponentAsDouble(column, image.height - 1 - row, 0, c))
          return false;
  return true;
}

int run(const char* file, const std::string& name, const char* picture) {
  const hogelscope::Session session = hogelscope::loadSession(file);
  const hogelscope::ViewSource scene = hogelscope::loadViewSource(session, {});
  for (const hogelscope::CameraState& state : session.cameras) {
    if (state.camera.name != name) continue;
    hogelscope::Renderer renderer;
    const hogelscope::Image image = renderer.render(scene.job(state), {});
    vtkNew<vtkHogelViewFilter> filter;
    filter->SetJob(scene.job(state));
    filter->UpdateOrThrow();
    hogelscope::writeImage(picture, image.width, image.height, image.rgb);
    return isEqual(image, filter->GetOutput()) ? 0 : 1;
  }
  return 1;
}

}  // namespace

int main(int argc, char** argv) try {
  return argc == 4 ? run(argv[1], argv[2], argv[3]) : 2;
} catch (const std::exception& error) {
  std::fprintf(stderr, "consumer: %s\n", error.what());
  return 2;
}
