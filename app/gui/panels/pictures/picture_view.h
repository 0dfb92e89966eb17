#pragma once
#include <functional>
#include <optional>
#include <string>

#include "gui/panels/pictures/picture_transform.h"
#include "gui/platform/texture.h"
#include "gui/theme/theme.h"
#include "image/image.h"
#include "render/channel_picture.h"

namespace ps::gui {

/// Display levels with their copy on the graphics card.
struct ShownPicture {
  Image<Rgb8> levels;
  Texture texture;

  Vec2i size() const { return {levels.width(), levels.height()}; }
  void upload(const std::vector<TileRect>& changed);
};

/// The marks that draw_picture draws besides the picture itself.
struct PictureStyle {
  bool grid = true;                           ///< lines between pixels, and numbers in them, once they are large
  std::function<std::string(Vec2i)> text_at;  ///< what to write into a large pixel; empty = its display levels
  std::optional<Vec2i> marked;                ///< the picked pixel
  std::optional<TileRect> region;             ///< the only pixels that are rendered
};

/// Draws a picture into an area of the window, clipped to it.
void draw_picture(ImDrawList& list, const ShownPicture& picture, const PictureTransform& transform, const Area& area,
                  const PictureStyle& style);
/// The mark of the picked pixel: a frame around it that can be seen on any colour and at any size.
void draw_mark(ImDrawList& list, ImVec2 min, ImVec2 max);
/// The neighbourhood of a pixel, greatly enlarged, into an area.
void draw_loupe(ImDrawList& list, const ShownPicture& picture, Vec2i pixel, const Area& area);
/// Where a legend has room for its scale.
struct LegendScale {
  Area bar, numbers;
};
/// Draws the meaning of a channel's colours, in a corner of an area. A scale that has room for controls is left to the
/// caller, and its place is the answer.
std::optional<LegendScale> draw_legend(ImDrawList& list, const ChannelLegend& legend, const Area& area);
/// A message in the middle of an area.
void draw_notice(ImDrawList& list, const Area& area, const std::string& text, Face face = Face::body);

}  // namespace ps::gui
