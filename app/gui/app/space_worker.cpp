#include "gui/app/space_worker.h"

#include <utility>

#include "render/display_frame.h"

namespace ps::gui {
namespace {

bool same(const SpaceRequest& a, const SpaceRequest& b) {
  const Scene &s = a.scene, &t = b.scene;
  return s.geometry.revision() == t.geometry.revision() && s.lights.revision() == t.lights.revision() &&
         s.materials.revision() == t.materials.revision() && s.textures.revision() == t.textures.revision() &&
         s.background == t.background && a.view == b.view && a.near == b.near;
}

SpacePicture draw(const SpaceRequest& request, Prepared& prepared, Progress& progress) {
  Settings settings;
  settings.renderer = Renderer::rasterizer;
  settings.near = request.near / request.view.camera.projection_plane_d;
  settings.backface_culling = false;  // open models are seen from all sides
  Scene scene = request.scene;
  scene.canvas_items = {};  // they lie on the picture, not in space
  RenderRequest wanted;
  wanted.channels = Channel::depth | Channel::ids;
  if (scene_traits(scene).csg) {  // has no triangles
    settings.renderer = Renderer::ray_tracer;
    settings.reflection_depth = 0;
    settings.shadows = Shadows::none;
  }
  const Frame frame = render(scene, request.view, settings, wanted, prepared, progress);
  return {request.view, request.near, display_frame(frame, settings), frame.depth, frame.ids};
}

}  // namespace

SpaceWorker::SpaceWorker(std::function<void()> wake) : wake_(std::move(wake)) {}

void SpaceWorker::request(const SpaceRequest& request) {
  wanted_ = request;
  start_next();
}

void SpaceWorker::start_next() {
  {
    const std::lock_guard lock(mutex_);
    if (running_ || (started_ && same(*started_, *wanted_))) return;
    running_ = true;
  }
  started_ = wanted_;
  job_.start([this, request = *started_](Progress& progress) {
    std::shared_ptr<const SpacePicture> made;
    try {
      made = std::make_shared<const SpacePicture>(draw(request, *prepared_, progress));
    } catch (const InputError&) {
      // A view that cannot be drawn: the last one stays.
    }
    {
      const std::lock_guard lock(mutex_);
      if (made) picture_ = std::move(made);
      running_ = false;
      news_ = true;
    }
    if (wake_) wake_();
  });
}

std::shared_ptr<const SpacePicture> SpaceWorker::picture() const {
  const std::lock_guard lock(mutex_);
  return picture_;
}

bool SpaceWorker::busy() const {
  const std::lock_guard lock(mutex_);
  return running_ || (wanted_ && !(started_ && same(*started_, *wanted_)));
}

bool SpaceWorker::has_news() const {
  const std::lock_guard lock(mutex_);
  return news_;
}

void SpaceWorker::take_news() {
  const std::lock_guard lock(mutex_);
  news_ = false;
}

}  // namespace ps::gui
