#pragma once
#include <cstdint>
#include <memory>
#include <optional>

#include "gui/work/inspect_worker.h"
#include "gui/work/newest_job.h"

namespace ps::gui {

/// Asks for the story of a pixel before anybody clicks it, and throws it away: for the first story with new settings a
/// graphics driver compiles its programs, and for that of a new scene a tree is built, which takes longer than the
/// story. All members are for the window's thread and return at once.
class StoryAhead {
 public:
  explicit StoryAhead(InspectWorker::InspectCall inspect_call = {});

  /// Does nothing for a scene and settings that it was last called with, whatever the pixel and the camera.
  void prepare(const PictureRequest& picture, Vec2i pixel, const std::shared_ptr<Prepared>& prepared);

 private:
  const InspectWorker::InspectCall inspect_;
  std::optional<Settings> settings_;
  std::uint64_t scene_ = 0;
  NewestJob job_;  // last, so that its thread ends before what it uses
};

}  // namespace ps::gui
