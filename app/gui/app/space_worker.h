#pragma once
#include <functional>
#include <memory>
#include <mutex>
#include <optional>

#include "gui/app/newest_job.h"
#include "inspect/space_picture.h"

namespace ps::gui {

/// The scene from outside.
struct SpaceRequest {
  Scene scene;
  View view;        ///< of the viewer, not of the picture
  double near = 1;  ///< nothing nearer is drawn, world units
};

/// Draws the scene from outside in the background. While one picture is being made the next is only noted, so that
/// pictures keep coming during a drag. All members are for the window's thread and return at once.
class SpaceWorker {
 public:
  explicit SpaceWorker(std::function<void()> wake);

  /// Asks for a picture unless it is the newest one already; called in every frame.
  void request(const SpaceRequest& request);
  /// The newest finished picture; nullptr if there is none.
  std::shared_ptr<const SpacePicture> picture() const;
  /// The picture of the newest request is still to come.
  bool busy() const;
  /// A picture has come since take_news().
  bool has_news() const;
  void take_news();

 private:
  void start_next();

  const std::function<void()> wake_;
  const std::shared_ptr<Prepared> prepared_ = std::make_shared<Prepared>();
  std::optional<SpaceRequest> wanted_, started_;
  mutable std::mutex mutex_;  // guards all down to news_
  std::shared_ptr<const SpacePicture> picture_;
  bool running_ = false, news_ = false;

  NewestJob job_;  // last, so that its thread ends before what it uses
};

}  // namespace ps::gui
