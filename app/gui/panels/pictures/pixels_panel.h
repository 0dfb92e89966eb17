#pragma once
#include <functional>
#include <memory>

#include "gui/panels/pictures/pictures_panel.h"
#include "gui/session/watched_pixels.h"
#include "gui/work/latest_result.h"
#include "image/pixel_ranking.h"
#include "image/region_statistics.h"

namespace ps::gui {

/// A picture whose costly pixels are asked for.
struct CostRequest {
  Scene scene;
  View view;
  Settings settings;
};

/// State of the panel of pixels.
struct PixelsPanelState {
  explicit PixelsPanelState(std::function<void()> wake);

  enum class Ranked { difference, cost_a, cost_b } ranked = Ranked::difference;
  bool apart = true;  ///< one pixel represents those around it
  LatestResult<CostRequest, Image<float>> cost;
  WatchedPixels watched;

  // The newest result, and the versions that it was made from.
  std::array<std::uint64_t, 2> versions{~std::uint64_t{0}, ~std::uint64_t{0}};
  std::shared_ptr<const Image<float>> ranked_cost;
  Ranked ranked_by = Ranked::difference;
  bool ranked_apart = true;
  std::optional<TileRect> measured;
  std::vector<RankedPixel> worst;
  std::array<RegionStatistics, 2> statistics;
};

/// The pixels that differ most or cost most, watched pixels, and statistics of a rectangle. A click on a pixel picks
/// it. `filled`: it has the whole window; answers whether that shall change.
bool pixels_panel(Session& session, PixelsPanelState& state, const PicturesState& pictures, bool filled);

/// Brings watched pixels up to date; also while the panel is not shown.
void update_pixels(Session& session, PixelsPanelState& state, const PicturesState& pictures);

}  // namespace ps::gui
