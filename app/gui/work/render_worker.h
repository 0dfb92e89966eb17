#pragma once
#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "frame/frame.h"
#include "frame/prepared.h"
#include "frame/view.h"
#include "gui/work/newest_job.h"
#include "image/image.h"
#include "options/settings.h"
#include "record/field_query.h"
#include "render/channel_picture.h"
#include "render/render.h"
#include "render/slow_motion.h"
#include "scene/scene.h"

namespace ps::gui {

/// What a view shall show.
struct PictureRequest {
  Scene scene;
  View view;
  Settings settings;
  ShownChannel shown = ShownChannel::colour;
  std::optional<ValueRange> range;            ///< of a heat map; absent = the frame's own
  std::optional<TileRect> region{};           ///< the only pixels that are wanted; absent = all
  std::shared_ptr<const ShownField> field{};  ///< of ShownChannel::field
  std::optional<SlowMotion> slow{};           ///< how far the picture is to be drawn; absent = whole
};

enum class RenderState { idle, coarse, full, done, cancelled, failed };

/// A finished render: what was asked for, and what came out. Shared, never changed.
struct RenderResult {
  PictureRequest request;
  Channel channels = Channel::none;  ///< those that `frame` has
  Frame frame;
  std::chrono::steady_clock::time_point begun;  ///< the full render
  double milliseconds = 0;                      ///< its wall-clock time
  std::optional<SlowState> slow;                ///< how far it has come, if the request asked for a part of the picture
};

struct RenderStatus {
  RenderState state = RenderState::idle;
  double fraction = 0;              ///< of the pass that is running
  std::string message;              ///< why it failed
  std::uint64_t renders_begun = 0;  ///< full or coarse-then-full renders, not changes of display
  std::uint64_t renders_done = 0;
  double first_pixels = 0;  ///< milliseconds from the newest request to collecting the first pixels of its render
  double waited = 0;        ///< milliseconds since the newest request while none of its pixels has come; else 0
};

/// Two requests need the same render: they differ at most in display options and in the channel shown.
bool same_render(const PictureRequest& a, const PictureRequest& b);

/// Renders for one view in the background. The newest request wins; a quarter of the pixels comes first where the full
/// picture takes long. All members are for one thread (the window's) and return at once.
class RenderWorker {
 public:
  /// The renderer to use; tests put slow ones in its place.
  using RenderCall =
      std::function<Frame(const Scene&, const View&, const Settings&, const RenderRequest&, Prepared&, Progress&)>;

  /// `wake` is called from worker threads whenever there is something new to collect; it must not block.
  RenderWorker(std::shared_ptr<Prepared> prepared, std::function<void()> wake, RenderCall render_call = {});

  /// Starts a render of `request`, or only shows the finished one anew if nothing else changed.
  void request(const PictureRequest& request);
  /// Stops; what has arrived so far stays to be seen.
  void cancel();
  RenderStatus status() const;
  /// The newest finished render; nullptr before the first.
  std::shared_ptr<const RenderResult> result() const;
  /// What the colours mean, of the newest whole picture.
  ChannelLegend legend() const;
  /// A render, or the finished one's new display, is still to come.
  bool busy() const { return job_.busy(); }
  /// Something has come since collect().
  bool has_news() const { return news_; }
  /// Copies what changed since the last call into `picture` (resizing it as needed) and returns the changed rectangles.
  std::vector<TileRect> collect(Image<Rgb8>& picture);

 private:
  /// One render as its thread knows it.
  struct Run {
    PictureRequest request;
    Channel channels = Channel::none;
    std::uint64_t generation = 0, display_generation = 0;
    int coarse_divisor = 1;
  };
  void or_fail(std::uint64_t generation, const std::function<void()>& work);
  void render_both(const Run& run, Progress& progress);
  void render_coarse(const Run& run, Progress& progress);
  void render_full(const Run& run, Progress& progress);
  void render_slow(const Run& run, const RenderRequest& options, Progress& progress);
  std::function<void(const Frame&, const TileRect&)> tile_publisher(const Run& run, int divisor);
  std::function<void(const Frame&, const TileRect&)> levels_publisher(const Run& run, Image<Rgb8>& levels);
  void publish(const Image<Rgb8>& pixels, const TileRect& rect, const Run& run, int divisor);
  void show_whole(const std::shared_ptr<const RenderResult>& result, std::uint64_t generation);
  bool finish_shown(const std::shared_ptr<const RenderResult>& result, const Run& run);
  void finish(const std::shared_ptr<const RenderResult>& result);
  std::optional<PictureRequest> wanted(std::uint64_t generation) const;
  int next_coarse_divisor() const;
  void wake();

  const std::shared_ptr<Prepared> prepared_;
  const std::function<void()> wake_;
  const RenderCall render_;

  mutable std::mutex mutex_;  // guards all down to changed_
  std::optional<PictureRequest> wanted_;
  std::uint64_t generation_ = 0;          // changes with each render
  std::uint64_t display_generation_ = 0;  // changes with each change of display
  RenderState state_ = RenderState::idle;
  std::string message_;
  std::uint64_t begun_ = 0, done_ = 0;
  std::chrono::steady_clock::time_point requested_;  // the newest render
  bool arrived_ = false, timed_ = false;             // its first pixels: published, collected
  double first_pixels_ = 0;                          // milliseconds
  Channel rendered_channels_ = Channel::none;        // that the newest render makes
  bool whole_seen_ = false;  // the newest render has shown a whole picture, if only a coarse one
  int unseen_ = 0;           // renders replaced before that, since the last finished one
  std::shared_ptr<const RenderResult> result_;
  ChannelLegend legend_;
  Image<Rgb8> picture_;
  std::vector<TileRect> changed_;

  std::atomic<bool> news_{false};   // set, under the lock, before anyone can see what is new
  std::atomic<bool> woken_{false};  // and not collected since

  NewestJob job_;  // last, so that its thread ends before what it uses
};

}  // namespace ps::gui
