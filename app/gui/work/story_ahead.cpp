#include "gui/work/story_ahead.h"

#include <exception>
#include <utility>

namespace ps::gui {

StoryAhead::StoryAhead(InspectWorker::InspectCall inspect_call)
    : inspect_(inspect_call ? std::move(inspect_call) : InspectWorker::InspectCall(&inspect)) {}

void StoryAhead::prepare(const PictureRequest& picture, Vec2i pixel, const std::shared_ptr<Prepared>& prepared) {
  if (settings_ == picture.settings && scene_ == picture.scene.geometry.revision()) return;
  settings_ = picture.settings;
  scene_ = picture.scene.geometry.revision();
  job_.start([this, picture, pixel, prepared](Progress& progress) {
    try {
      inspect_(picture.scene, picture.view, picture.settings, pixel, *prepared, progress);
    } catch (const Cancelled&) {
      throw;
    } catch (const std::exception&) {
      // A click on the pixel shows why.
    }
  });
}

}  // namespace ps::gui
