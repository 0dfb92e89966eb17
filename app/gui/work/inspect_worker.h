#pragma once
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "gui/work/newest_job.h"
#include "gui/work/render_worker.h"
#include "record/story.h"

namespace ps::gui {

/// A pixel whose story is requested, in the scene and with the settings of `picture`.
struct StoryRequest {
  PictureRequest picture;
  Vec2i pixel{0, 0};  ///< array position; must lie in the view
};

/// Computes the stories of pixels in the background, for the newest request only. All members are for the window's
/// thread and return at once.
class InspectWorker {
 public:
  using InspectCall =
      std::function<PixelStory(const Scene&, const View&, const Settings&, Vec2i, Prepared&, Progress&)>;

  /// `wake` is called from the worker's thread when a story is ready; it must not block.
  InspectWorker(std::shared_ptr<Prepared> prepared, std::function<void()> wake, InspectCall inspect_call = {});

  /// Starts on `request` unless it is the newest one already.
  void request(const StoryRequest& request);
  /// Forgets the story and what is on its way.
  void clear();
  /// The newest finished story, which may still be that of an earlier request; nullptr if there is none.
  std::shared_ptr<const PixelStory> story() const;
  /// The same, but nullptr if its story is of another scene than the one of that name, where its indices of objects and
  /// lights are meaningless.
  std::shared_ptr<const PixelStory> story_of(const std::string& scene) const;
  bool busy() const;
  /// A story or an error has come since take_news().
  bool has_news() const { return news_; }
  void take_news() { news_ = false; }
  /// Why the newest request failed; empty if it did not.
  std::string message() const;

 private:
  const std::shared_ptr<Prepared> prepared_;
  const std::function<void()> wake_;
  const InspectCall inspect_;

  mutable std::mutex mutex_;  // guards all down to message_
  std::optional<StoryRequest> wanted_;
  std::uint64_t generation_ = 0;
  bool busy_ = false;
  std::shared_ptr<const PixelStory> story_;
  std::string story_scene_;  // name of the scene of story_
  std::string message_;
  std::atomic<bool> news_{false};

  NewestJob job_;  // last, so that its thread ends before what it uses
};

}  // namespace ps::gui
