#pragma once
#include <functional>
#include <memory>

#include "gui/panels/panel.h"
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
/// it.
class PixelsPanel final : public Panel {
 public:
  PixelsPanel(const PanelHost& host, const PicturesState& pictures);
  bool draw(const Context& context) override;
  /// Brings watched pixels up to date.
  void update() override;
  bool busy() const override { return works(state_.cost); }

 private:
  const PicturesState& pictures_;
  PixelsPanelState state_;
};

}  // namespace ps::gui
