#include "gui/app/space_worker.h"

#include <utility>

namespace ps::gui {
namespace {

bool same(const SpaceRequest& a, const SpaceRequest& b) {
  const Scene &s = a.scene, &t = b.scene;
  return s.geometry.revision() == t.geometry.revision() && s.lights.revision() == t.lights.revision() &&
         s.materials.revision() == t.materials.revision() && s.textures.revision() == t.textures.revision() &&
         s.background == t.background && a.view == b.view && a.near == b.near;
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
      made = std::make_shared<const SpacePicture>(
          draw_space_picture(request.scene, request.view, request.near, *prepared_, progress));
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
