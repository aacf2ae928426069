// SPDX-License-Identifier: BSD-3-Clause
#include "python/session_views.h"

#include <algorithm>
#include <mutex>
#include <set>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/cameras/focus_stack.h"
#include "core/engine/renderer.h"
#include "io/files/system_limits.h"
#include "io/scene/view_source.h"
#include "python/stoppable.h"
#include "runs/state_images.h"

namespace hogelscope {

/// What a scene is opened from again.
struct SceneOrigin {
  Session session;                 ///< without states, with the light field's parameters
  std::weak_ptr<Content> content;  ///< if it is still open
  std::shared_ptr<Content> array;  ///< a numpy array's, which cannot be opened again; else null
  std::string files;               ///< their identities
  int frame = 0;
};

/// What all views of one session and one light field share.
struct OpenScene {
  std::shared_ptr<const SceneOrigin> origin;
  std::shared_ptr<Content> content;
  ViewSource source;
  std::vector<std::filesystem::path> inputs;
  bool isStreamed = false;  ///< the source has no texels then
};

/// The renderers of a session's views; they keep tables of lenses.
struct ViewRenderers {
  std::timed_mutex mutex;            ///< of all that a SessionViews has, too
  Renderer one;                      ///< of one view at a time on all cores
  std::vector<Renderer> sideBySide;  ///< of one view on each core
};

namespace {

Session withoutStates(const Session& session) {
  return {session.display,    session.twin,     session.twinFile,
          session.lightField, session.sampling, session.depth,
          session.optimise,   session.metrics,  {}};
}

std::shared_ptr<const OpenScene> openScene(const Session& session,
                                           const std::shared_ptr<Content>& content, int frame,
                                           const Progress& progress) {
  LightFieldFile& file = *content->file();
  auto scene = std::make_shared<OpenScene>();
  scene->inputs = filesOf(session, file);
  scene->origin = std::make_shared<SceneOrigin>(SceneOrigin{session, content,
                                                            content->isArray() ? content : nullptr,
                                                            identitiesOf(scene->inputs), frame});
  scene->content = content;
  scene->isStreamed = mustStream(file, allowedMemory());
  scene->source = scene->isStreamed ? unloadedViewSource(session, file, progress)
                                    : viewSourceOf(session, content->source(frame, progress));
  if (scene->isStreamed) file.select(frame);
  return scene;
}

/// Replaces the states by what is asked for of them: an eye, several distances of focus.
void expand(Session& session, const PanelParams& display, const ViewRequest& request) {
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

/// Returns the session with the states of these names, in this order.
Session selected(const Session& session, const ViewRequest& request) {
  if (!request.states) return session;
  Session result = withoutStates(session);
  for (const std::string& name : *request.states) {
    const auto found = std::ranges::find_if(
        session.cameras, [&](const CameraState& state) { return state.camera.name == name; });
    if (found != session.cameras.end()) {
      result.cameras.push_back(*found);
      continue;
    }
    std::string known;
    constexpr std::size_t longest = 200;
    for (const CameraState& state : session.cameras)
      if (known.size() < longest) known += (known.empty() ? "" : ", ") + state.camera.name;
    throw InputError(request.document.name, "\"" + name + "\"", "is none of the states: " + known);
  }
  return result;
}

/// Throws InputError unless each picture has memory of its size, and of its own.
void checkOut(const ViewRequest& request, const std::vector<CameraState>& states) {
  if (request.out.empty()) return;
  if (request.out.size() != states.size())
    throw InputError("out", "has " + std::to_string(request.out.size()) + " arrays for " +
                                std::to_string(states.size()) + " pictures");
  for (std::size_t k = 0; k < states.size(); ++k) {
    const auto& [name, res] = std::pair(states[k].camera.name, states[k].camera.res);
    if (res != request.outSizes[k])
      throw InputError("out", "is (" + std::to_string(request.outSizes[k][1]) + ", " +
                                  std::to_string(request.outSizes[k][0]) + ", 3); \"" + name +
                                  "\" is (" + std::to_string(res[1]) + ", " +
                                  std::to_string(res[0]) + ", 3)");
  }
  if (std::set(request.out.begin(), request.out.end()).size() < states.size())
    throw InputError("out", "is one array for several pictures");
}

std::size_t pixelsOf(const CameraState& state) {
  return std::size_t(state.camera.res[0]) * std::size_t(state.camera.res[1]);
}

/// Makes the mask one of numpy's truth values.
void makeTruth(std::uint8_t* seen, const std::array<int, 2>& res, const ParallelRows& rows) {
  rows(res[1], [&](int begin, int end) {
    const auto width = std::size_t(res[0]);
    for (std::size_t k = std::size_t(begin) * width; k < std::size_t(end) * width; ++k)
      seen[k] = std::uint8_t(seen[k] & 1U);
  });
}

/// Whether a core renders the picture and its table of the lens as well as all cores do.
bool isSmall(const CameraState& state) {
  constexpr std::size_t most = 1 << 20;
  return pixelsOf(state) <= most;
}

/// Whether each state is worth a core of its own.
bool areSideBySide(const std::vector<CameraState>& states) {
  return states.size() >= 2 * std::size_t(threadCount()) && std::ranges::all_of(states, isSmall);
}

/// Keeps the states that are wanted.
void takePart(std::vector<CameraState>& states, const ViewRequest& request, bool isStreamed) {
  states.erase(states.begin(),
               states.begin() + std::ptrdiff_t(std::min(request.first, states.size())));
  if (!request.isPart || isStreamed) return;  // a light field that is read once gives all at once
  const auto large = std::ranges::find_if_not(states, isSmall);
  const auto together = std::max<std::ptrdiff_t>(large - states.begin(), 1);
  const std::ptrdiff_t most = 4 * std::ptrdiff_t(threadCount());
  states.erase(states.begin() + std::min({together, most, std::ssize(states)}), states.end());
}

/// Makes the pictures of one request.
class ViewMaker {
 public:
  ViewMaker(const ViewRequest& request, const OpenScene& scene,
            std::shared_ptr<ViewRenderers> renderers)
      : m_request(request), m_scene(scene), m_renderers(std::move(renderers)) {}

  /// Makes the views of the states at these places of the list.
  void make(const std::vector<CameraState>& all, const std::vector<std::size_t>& places,
            std::vector<RenderedView>& views, const Progress& progress) {
    std::vector<CameraState> states;
    for (const std::size_t place : places) states.push_back(all[place]);
    if (m_scene.isStreamed) {
      StateImages images(m_scene.source, *m_scene.content->file(), states, {}, progress);
      for (std::size_t k = 0; k < states.size(); ++k)
        views[places[k]] =
            copied(states[k], places[k], images.render(k, m_renderers->one, progress));
      return;
    }
    StepProgress steps(progress);
    steps.expect(double(states.size()));
    if (!areSideBySide(states)) {
      for (std::size_t k = 0; k < states.size(); ++k) {
        views[places[k]] = rendered(states[k], places[k], m_renderers->one, steps.of(1));
        steps.finish();
      }
      return;
    }
    auto& renderers = m_renderers->sideBySide;
    renderers.resize(std::max(renderers.size(), std::size_t(threadCount())), Renderer(serialRows));
    sideBySide(states.size(), threadCount(), [&](std::size_t k, std::size_t worker) {
      views[places[k]] = rendered(states[k], places[k], renderers[worker], steps.within());
      steps.finish();
    });
  }

 private:
  [[nodiscard]] RenderedView rendered(const CameraState& state, std::size_t index,
                                      Renderer& renderer, const Progress& progress) const {
    RenderedView view = blank(state);
    try {
      RenderJob job = m_scene.source.job(state);
      job.isIdeal = m_request.isIdeal;
      view.viewing = viewingOf(job.state, job.display, job.sampling.mapping);
      auto* const seen = view.seen.as<std::uint8_t>();
      renderer.renderInto(job, rgbOf(view, index), seen, progress);
      if (m_scene.content->isBorrowed()) {
        view.values = PictureMemory(3 * pixelsOf(state) * sizeof(float));
        renderer.renderInto(job, view.values.as<float>(), seen, progress);
      } else {
        view.unrounded =
            std::make_shared<UnroundedView>(m_scene.origin, state, m_request.isIdeal, m_renderers);
      }
      makeTruth(seen, view.res, renderer.rows());
      return view;
    } catch (const InputError& error) {
      throw InputError(view.state, error.what());
    }
  }

  /// Returns the view with a picture that was made while the light field was read.
  [[nodiscard]] RenderedView copied(const CameraState& state, std::size_t index,
                                    const Image& image) const {
    RenderedView view = blank(state);
    view.viewing = viewingOf(state, m_scene.source.display, m_scene.source.sampling.mapping);
    std::ranges::copy(image.rgb, rgbOf(view, index));
    std::ranges::copy(image.seen, view.seen.as<std::uint8_t>());
    makeTruth(view.seen.as<std::uint8_t>(), view.res, parallelRows);
    return view;
  }

  [[nodiscard]] RenderedView blank(const CameraState& state) const {
    RenderedView view;
    view.state = state.camera.name;
    view.res = state.camera.res;
    if (m_request.stackCount > 0) view.focus = state.pupil.focus;
    if (m_request.out.empty()) view.rgb = PictureMemory(3 * pixelsOf(state));
    view.seen = PictureMemory(pixelsOf(state));
    return view;
  }
  [[nodiscard]] std::uint8_t* rgbOf(const RenderedView& view, std::size_t index) const {
    return m_request.out.empty() ? view.rgb.as<std::uint8_t>() : m_request.out[index];
  }

  const ViewRequest& m_request;
  const OpenScene& m_scene;
  std::shared_ptr<ViewRenderers> m_renderers;
};

}  // namespace

UnroundedView::UnroundedView(std::shared_ptr<const SceneOrigin> origin, CameraState state,
                             bool isIdeal, const std::shared_ptr<ViewRenderers>& renderers)
    : m_origin(std::move(origin)),
      m_renderers(renderers),
      m_state(std::move(state)),
      m_isIdeal(isIdeal) {}

PictureMemory UnroundedView::render(const Progress& progress) const {
  const auto shared = m_renderers.lock();
  const auto renderers = shared ? shared : std::make_shared<ViewRenderers>();
  const auto lock = lockFor(renderers->mutex, progress);
  const Session& session = m_origin->session;
  std::shared_ptr<Content> content = m_origin->content.lock();
  if (!content || !content->isFresh()) content = Content::openOf(session, progress);
  const std::shared_ptr<const OpenScene> scene =
      openScene(session, content, m_origin->frame, progress);
  if (scene->origin->files != m_origin->files)
    throw InputError(contentName(session.lightField),
                     "has changed since \"" + m_state.camera.name +
                         "\" was rendered, so its values are lost: render it again");
  if (scene->isStreamed)
    throw InputError("values", "need all of the light field, which does not fit in memory");
  RenderJob job = scene->source.job(m_state);
  job.isIdeal = m_isIdeal;
  const std::size_t pixels = pixelsOf(m_state);
  PictureMemory values(3 * pixels * sizeof(float));
  const PictureMemory seen(pixels);
  renderers->one.renderInto(job, values.as<float>(), seen.as<std::uint8_t>(), progress);
  return values;
}

SessionViews::SessionViews() : m_renderers(std::make_shared<ViewRenderers>()) {}

const Session& SessionViews::parsed(const Document& document) {
  if (!m_session || document != m_document) {
    m_session.reset();
    m_session = sessionOf(document);
    m_document = document;
  }
  return *m_session;
}

/// Returns the session's light field, which is kept.
std::shared_ptr<Content> SessionViews::ownContent(const Session& session,
                                                  const Progress& progress) {
  if (m_scene && m_scene->origin->session == session &&
      identitiesOf(m_scene->inputs) == m_scene->origin->files)
    return m_scene->content;
  std::shared_ptr<Content> content;
  if (m_scene && readTheSame(session, m_scene->origin->session) && m_scene->content->isFresh())
    content = m_scene->content;
  m_scene.reset();  // releases the memory before another light field is read
  return content ? content : Content::openOf(session, progress);
}

/// Returns the kept scene, or a new one of ownContent().
std::shared_ptr<const OpenScene> SessionViews::sceneOf(const Session& session,
                                                       const std::shared_ptr<Content>& content,
                                                       int frame, const Progress& progress) {
  if (m_scene && m_scene->origin->session == session && m_scene->origin->frame == frame &&
      !m_scene->isStreamed)
    return m_scene;
  m_scene.reset();
  m_scene = openScene(session, content, frame, progress);
  return m_scene;
}

namespace {

/// Returns the frame of each state: its own time's, or the request's.
std::vector<int> framesOf(const std::vector<CameraState>& states, const ViewRequest& request,
                          const Content& content) {
  const FrameNumbers listed = content.file()->frames();
  const double rate = frameRateOf(content.lightField(), *content.file());
  if (request.frame && !listed.has(*request.frame))
    throw InputError(
        "frame", std::to_string(*request.frame) + " is not there: the light field's first is " +
                     std::to_string(listed.first) + ", its last " + std::to_string(listed.last));
  std::vector<int> frames;
  for (const CameraState& state : states) {
    const bool isOwn = state.camera.time != notGiven;
    const std::optional<double> time = isOwn ? std::optional(state.camera.time) : request.time;
    if (time && !listed.isStill() && !(rate > 0))
      throw InputError("time", "needs lightField.fps: the light field does not say its rate");
    if (request.frame && !isOwn)
      frames.push_back(*request.frame);
    else
      frames.push_back(time && !listed.isStill() ? listed.shownAt(*time, rate) : listed.first);
  }
  return frames;
}

}  // namespace

RenderedViews SessionViews::render(const ViewRequest& request, const Progress& progress) {
  const auto lock = lockFor(m_renderers->mutex, progress);
  Session session = selected(parsed(request.document), request);
  std::shared_ptr<Content> given;
  if (const auto* file = std::get_if<std::string>(&request.light))
    session = sessionWith(session, *file);
  else if (const auto* content = std::get_if<std::shared_ptr<Content>>(&request.light))
    given = *content;
  if (given) session = given->in(session);
  if (given && given->lightField().isLive()) given = nullptr;  // opened for this display
  if (request.isIdeal) requireLive(session);
  const Session shared = withoutStates(session);
  const auto content = given ? given : ownContent(shared, part(progress, 0, 0.1));
  const auto sceneAt = [&](int frame, const Progress& reading) {
    return given ? openScene(shared, content, frame, reading)
                 : sceneOf(shared, content, frame, reading);
  };
  const std::vector<int> ofStates = framesOf(session.cameras, request, *content);
  const int first = ofStates.empty() ? content->file()->frames().first : ofStates.front();
  auto scene = sceneAt(first, part(progress, 0.1, 0.5));
  takePart(session.cameras, request, scene->isStreamed);
  expand(session, scene->source.display, request);
  checkOut(request, session.cameras);
  const std::vector<int> frames = framesOf(session.cameras, request, *content);
  RenderedViews result;
  for (const auto& input : scene->inputs) result.inputs.push_back(input.string());
  result.views.resize(session.cameras.size());
  const std::set<int> distinct(frames.begin(), frames.end());
  double done = 0.5;
  for (const int frame : distinct) {
    std::vector<std::size_t> places;
    for (std::size_t k = 0; k < frames.size(); ++k)
      if (frames[k] == frame) places.push_back(k);
    const double end = done + 0.5 * double(places.size()) / double(frames.size());
    const Progress own = part(progress, done, end);
    if (frame != scene->origin->frame) scene = sceneAt(frame, part(own, 0, 0.5));
    ViewMaker(request, *scene, m_renderers)
        .make(session.cameras, places, result.views, part(own, 0.5, 1));
    done = end;
  }
  return result;
}

}  // namespace hogelscope
