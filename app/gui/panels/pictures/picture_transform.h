#pragma once
#include <imgui.h>

#include "math/vec.h"

namespace ps::gui {

/// A rectangle of the window, in its pixels.
struct Area {
  ImVec2 min{0, 0}, max{0, 0};
  float width() const { return max.x - min.x; }
  float height() const { return max.y - min.y; }
  bool contains(ImVec2 p) const { return p.x >= min.x && p.y >= min.y && p.x < max.x && p.y < max.y; }
  ImVec2 middle() const { return {(min.x + max.x) / 2, (min.y + max.y) / 2}; }
};

/// How a picture lies in an area: enlarged by `zoom`, with the picture's point `centre` at the area's centre.
struct PictureTransform {
  double zoom = 1;         ///< window pixels per picture pixel
  Vec2d centre{300, 300};  ///< continuous picture coordinates; pixel (x, y) spans [x, x + 1) by [y, y + 1)

  ImVec2 to_window(Vec2d point, const Area& area) const;
  Vec2d to_picture(ImVec2 point, const Area& area) const;
  /// The array position of the pixel under a point of the window; may lie outside the picture.
  Vec2i pixel_at(ImVec2 point, const Area& area) const;
  /// Where the whole picture lies; its corner is on a whole window pixel.
  Area picture_area(Vec2i picture_size, const Area& area) const;
  /// The part of it that lies in the area; without width or height where none does.
  Area seen(Vec2i picture_size, const Area& area) const;
};

inline constexpr double smallest_zoom = 1.0 / 64;
inline constexpr double largest_zoom = 256;

/// The whole picture, as large as it fits with a small margin. Whole-number enlargements are preferred where they lose
/// little, because their pixels are all of one size.
PictureTransform fitted(Vec2i picture_size, const Area& area);
/// Enlarges by `factor` and keeps what is under `point` where it is.
PictureTransform zoomed_about(const PictureTransform& from, double factor, ImVec2 point, const Area& area);
/// Moves the picture by window pixels, but never wholly out of sight.
PictureTransform panned(const PictureTransform& from, ImVec2 by, Vec2i picture_size);

}  // namespace ps::gui
