#pragma once
#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gui/base/values.h"
#include "gui/panels/story/listing_marks.h"
#include "gui/panels/story/shader_rows.h"
#include "gui/session/session.h"
#include "gui/work/file_watch.h"
#include "gui/work/latest_result.h"
#include "record/shader_listing.h"
#include "textbook/listing_view.h"

namespace ps::gui {

struct ShaderRequest {
  PictureRequest picture;
  Vec2i pixel{0, 0};
  int reloads = 0;  ///< how often the files have been taken up anew
};

/// The shaders of a pixel, or why there are none.
struct ShadersFound {
  std::shared_ptr<const ShaderListing> listing;
  std::string message;
};

/// Takes up shader files that were written, in the background.
class ShaderReload {
 public:
  explicit ShaderReload(std::function<void()> wake) : wake_(std::move(wake)) {}
  /// `reload` is that of the renderer's row.
  void start(std::string (*reload)());
  /// What has come since the last call: why the files do not compile, or an empty text if they do.
  std::optional<std::string> take();
  bool busy() const { return job_.busy(); }

 private:
  const std::function<void()> wake_;
  std::mutex mutex_;
  std::optional<std::string> outcome_;

  NewestJob job_;  // last, so that its thread ends before what it uses
};

/// State of the view of shaders.
struct ShaderPanelState {
  explicit ShaderPanelState(const std::function<void()>& wake);

  LatestResult<ShaderRequest, ShadersFound> worker;
  FileWatch watch;
  ShaderReload reload;
  int reloads = 0;
  std::string error;  ///< why the files on disk do not compile; those before are in use
  int draw = 0;
  ShaderStage stage = ShaderStage::fragment;
  std::shared_ptr<const ShadersFound> shown;
  std::vector<ListingRow> rows;        ///< of the text that is shown
  std::vector<ShaderFilePlace> files;  ///< in that text
  std::string rows_of;                 ///< of which draw and stage; empty: to be made anew
  LineMarks marks;                     ///< what the compiler says, and the row to look at first
  bool reveal = false;                 ///< scroll to that row
};

/// Has the renderer shaders that can be shown?
bool has_shaders(const Settings& settings);

/// Once a frame: takes up what has come, and files that were written.
void update_shaders(Session& session, ShaderPanelState& state);
bool shaders_busy(const ShaderPanelState& state);

/// The shaders that drew the picked pixel in one side's picture, as the driver got them.
void shader_panel(Session& session, ShaderPanelState& state, Side side, Vec2i pixel);

/// What scripts may ask for below "listing/". The state must outlive the offers.
void offer_shader_values(Values& out, const ShaderPanelState& state);

}  // namespace ps::gui
