#include "gui/work/inspect_worker.h"

#include <utility>

#include "base/failure_text.h"

namespace ps::gui {

InspectWorker::InspectWorker(std::shared_ptr<Prepared> prepared, std::function<void()> wake, InspectCall inspect_call)
    : prepared_(std::move(prepared)), wake_(std::move(wake)),
      inspect_(inspect_call ? std::move(inspect_call) : InspectCall(&inspect)) {}

void InspectWorker::request(const StoryRequest& request) {
  const std::lock_guard lock(mutex_);
  // The story holds display values too, so every setting counts.
  if (wanted_ && wanted_->pixel == request.pixel && wanted_->picture.settings == request.picture.settings &&
      same_render(wanted_->picture, request.picture))
    return;
  wanted_ = request;
  busy_ = true;
  message_.clear();
  job_.start([this, request, generation = ++generation_](Progress& progress) {
    std::shared_ptr<const PixelStory> story;
    std::string message;
    try {
      const PictureRequest& picture = request.picture;
      story = std::make_shared<const PixelStory>(
          inspect_(picture.scene, picture.view, picture.settings, request.pixel, *prepared_, progress));
    } catch (const Cancelled&) {
      throw;
    } catch (const std::exception& error) {
      message = failure_text(error);
    }
    {
      const std::lock_guard result_lock(mutex_);
      if (generation != generation_) return;
      story_ = std::move(story);
      story_scene_ = request.picture.scene.name;
      message_ = std::move(message);
      busy_ = false;
      news_ = true;
    }
    if (wake_) wake_();
  });
}

void InspectWorker::clear() {
  const std::lock_guard lock(mutex_);
  if (!wanted_) return;
  ++generation_;
  wanted_.reset();
  story_ = nullptr;
  message_.clear();
  busy_ = false;
  job_.cancel();
}

std::shared_ptr<const PixelStory> InspectWorker::story() const {
  const std::lock_guard lock(mutex_);
  return story_;
}

std::shared_ptr<const PixelStory> InspectWorker::story_of(const std::string& scene) const {
  const std::lock_guard lock(mutex_);
  return story_scene_ == scene ? story_ : nullptr;
}

bool InspectWorker::busy() const {
  const std::lock_guard lock(mutex_);
  return busy_;
}

std::string InspectWorker::message() const {
  const std::lock_guard lock(mutex_);
  return message_;
}

}  // namespace ps::gui
