// SPDX-License-Identifier: BSD-3-Clause
// Rendering for Python: state kept between views, and views as numpy arrays.
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/cameras/focus_stack.h"
#include "core/engine/renderer.h"
#include "core/optics/eyes.h"
#include "core/optics/viewing.h"
#include "io/files/files_in_use.h"
#include "io/images/image_writer.h"
#include "io/scene/view_source.h"
#include "python/bindings.h"
#include "python/content.h"
#include "python/pictures.h"
#include "python/stoppable.h"
#include "runs/state_images.h"

namespace hogelscope {

namespace py = pybind11;

namespace {

/// A state's image and its unrounded values; a streamed light field has none.
struct RenderedView {
  std::string state;
  std::optional<double> focus;  ///< of a focus stack, metres
  Image image;
  std::optional<std::vector<float>> values;
  Viewing viewing;
};

struct RenderedViews {
  std::vector<RenderedView> views;
  std::vector<std::string> inputs;  ///< the files of the light field
};

/// The request of views; `light` is null for the session's own.
struct RenderRequest {
  Session session;
  std::shared_ptr<Content> light;
  bool isIdeal = false;
  std::optional<Eye> eye;  ///< of states with `stereo`; the head's view without one
  int stackCount = 0;      ///< of a focus stack; 0: none
};

/// Keeps the session's light field and tables of lenses between views.
class SessionViews {
 public:
  RenderedViews render(const RenderRequest& request, const Progress& progress);

 private:
  std::shared_ptr<Content> ownOf(const Session& session, const Progress& progress);

  std::timed_mutex m_mutex;
  Session m_session;  ///< the session of the kept light field
  std::shared_ptr<Content> m_own;
  Renderer m_renderer;
};

std::shared_ptr<Content> SessionViews::ownOf(const Session& session, const Progress& progress) {
  if (m_own && readTheSame(session, m_session) && m_own->isFresh()) return m_own;
  m_own.reset();  // releases the memory before the next one is read
  m_own = Content::openOf(session, progress);
  m_session = session;
  return m_own;
}

/// Replaces the states by what is asked for of them: an eye, several distances of focus.
void expand(Session& session, const PanelParams& display, const RenderRequest& request) {
  if (request.eye)
    for (CameraState& state : session.cameras) {
      if (!hasTwoEyes(state))
        throw InputError(state.camera.name, "stereo.ipd", "is 0, so there is one eye: give metres");
      state = eyeOf(state, session.display, *request.eye);
    }
  if (request.stackCount == 0) return;
  std::vector<CameraState> focused;
  for (const CameraState& state : session.cameras)
    for (CameraState& one : focusStack(state, inFile(state.camera.name, [&] {
                                         return focusDistances(state, display, request.stackCount);
                                       })))
      focused.push_back(std::move(one));
  session.cameras = std::move(focused);
}

RenderedView renderOne(Renderer& renderer, const StateImages& images, std::size_t state,
                       bool isStack, const Progress& progress) {
  const RenderJob job = images.job(state);
  RenderedView view{job.state.camera.name, {}, {}, {}, {}};
  if (isStack) view.focus = job.state.pupil.focus;
  try {
    view.viewing = viewingOf(job.state, job.display, job.sampling.mapping);
    if (images.areStreamed()) {
      view.image = images.render(state, renderer, progress);
      return view;
    }
    FloatImage values = images.renderFloat(state, renderer, progress);
    // With a tolerance, the reduced image is rounded before it is enlarged.
    view.image =
        job.sampling.tolerance > 0 ? images.render(state, renderer, progress) : rounded(values);
    view.values = std::move(values.rgb);
    return view;
  } catch (const InputError& error) {
    throw InputError(view.state, error.what());
  }
}

RenderedViews SessionViews::render(const RenderRequest& request, const Progress& progress) {
  const auto lock = lockFor(m_mutex, progress);
  const bool isOwn = !request.light || request.light->lightField().isLive();
  Session session = request.light ? request.light->in(request.session) : request.session;
  if (request.isIdeal) requireLive(session);
  const std::shared_ptr<Content> content =
      isOwn ? ownOf(session, part(progress, 0, 0.1)) : request.light;
  LightFieldFile& file = *content->file();
  const PanelParams display = resolved(displayOf(session), file.size());
  expand(session, display, request);
  RenderedViews result;
  for (const auto& input : filesOf(session, file)) result.inputs.push_back(input.string());
  const Progress reading = part(progress, 0.1, 0.5);
  StateImages images =
      mustStream(file, allowedMemory())
          ? StateImages(unloadedViewSource(session, file, reading), file, session.cameras, {},
                        reading)
          : StateImages(viewSourceOf(session, content->source(reading)), session.cameras);
  if (request.isIdeal) images.showIdeal();
  const auto count = double(session.cameras.size());
  for (std::size_t k = 0; k < session.cameras.size(); ++k)
    result.views.push_back(renderOne(
        m_renderer, images, k, request.stackCount > 0,
        part(progress, 0.5 + 0.5 * double(k) / count, 0.5 + 0.5 * double(k + 1) / count)));
  return result;
}

/// Returns the session with the states of these names, in this order.
void select(Session& session, const std::vector<std::string>& names, const std::string& document) {
  std::vector<CameraState> states;
  for (const std::string& name : names) {
    const auto found = std::ranges::find_if(
        session.cameras, [&](const CameraState& state) { return state.camera.name == name; });
    if (found != session.cameras.end()) {
      states.push_back(*found);
      continue;
    }
    std::string known;
    constexpr std::size_t longest = 200;
    for (const CameraState& state : session.cameras)
      if (known.size() < longest) known += (known.empty() ? "" : ", ") + state.camera.name;
    throw InputError(document, "\"" + name + "\"", "is none of the states: " + known);
  }
  session.cameras = states;
}

/// Returns a numpy array that owns the vector's memory.
template <class T>
py::array arrayOf(std::vector<T> values, const std::vector<std::size_t>& shape) {
  auto* const held = new std::vector<T>(std::move(values));  // NOLINT: the capsule owns it
  const py::capsule owner(held, [](void* p) { delete static_cast<std::vector<T>*>(p); });  // NOLINT
  return py::array_t<T>(shape, held->data(), owner);
}

py::tuple tupleOf(RenderedView view) {
  const auto height = std::size_t(view.image.height);
  const auto width = std::size_t(view.image.width);
  for (std::uint8_t& seen : view.image.seen) seen = seen != 0 ? 1 : 0;
  const py::array seen = arrayOf(std::move(view.image.seen), {height, width});
  return py::make_tuple(
      view.state, arrayOf(std::move(view.image.rgb), {height, width, 3}),
      seen.attr("view")(py::dtype::of<bool>()),
      view.values ? py::object(arrayOf(std::move(*view.values), {height, width, 3})) : py::none(),
      view.focus, view.viewing.pixelsPerDegree, view.viewing.distance);
}

py::tuple render(SessionViews& views, const Document& document,
                 const std::optional<std::vector<std::string>>& states, const LightChoice& light,
                 bool ideal, const std::string& eye, int focusStack, int threads,
                 const py::object& progress) {
  const ThreadsOfCall limit(threads);
  RenderedViews rendered = stoppable(progress, [&](const Progress& hear) {
    RenderRequest request{sessionOf(document), {}, ideal, {}, focusStack};
    if (!eye.empty()) request.eye = eye == nameOf(Eye::left) ? Eye::left : Eye::right;
    if (states) select(request.session, *states, document.name);
    if (const auto* file = std::get_if<std::string>(&light))
      request.session = sessionWith(request.session, *file);
    else if (const auto* content = std::get_if<std::shared_ptr<Content>>(&light))
      request.light = *content;
    return views.render(request, hear);
  });
  py::list result;
  for (RenderedView& view : rendered.views) result.append(tupleOf(std::move(view)));
  return py::make_tuple(result, rendered.inputs);
}

void write(const std::string& file, const py::array& picture,
           const std::optional<py::array>& unrounded, const std::vector<std::string>& inputs) {
  const Bytes image = bytesOf(picture);
  const std::optional<Floats> values =
      unrounded ? std::optional(valuesOf(*unrounded, picture)) : std::nullopt;
  const auto height = int(image.shape(0));
  const auto width = int(image.shape(1));
  const auto size = std::size_t(image.size());
  const std::uint8_t* const rgb = image.data();
  const float* const floats = values ? values->data() : nullptr;
  runStoppable(py::none(), [&](const Progress& hear) {
    const FilesInUse inUse({inputs.begin(), inputs.end()});
    if (floats != nullptr)
      writeImage(file, width, height, std::span(floats, size));
    else
      writeImage(file, width, height, std::span(rgb, size), hear);
  });
}

py::bytes png(const py::array& picture) {
  const Bytes image = bytesOf(picture);
  const std::span rgb(image.data(), std::size_t(image.size()));
  return encodedPng(int(image.shape(1)), int(image.shape(0)), rgb);
}

}  // namespace

void addViews(py::module_& module) {
  py::class_<SessionViews>(module, "SessionViews", "What a session keeps between views.")
      .def(py::init<>())
      .def("render", &render, py::arg("document"), py::arg("states"), py::arg("light_field"),
           py::arg("ideal"), py::arg("eye"), py::arg("focus_stack"), py::arg("threads"),
           py::arg("progress"),
           "Renders states: (name, image, seen, values, focus, pixels per degree, distance) of "
           "each, and the files that were read.");
  module.def("png", &png, py::arg("image"), "The bytes of a PNG of 8-bit RGB.");
  module.def("write", &write, py::arg("file"), py::arg("image"), py::arg("values"),
             py::arg("inputs"), "Writes 8-bit RGB, or values as EXR or TIFF, over no input.");
}

}  // namespace hogelscope
