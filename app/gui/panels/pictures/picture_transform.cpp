#include "gui/panels/pictures/picture_transform.h"

#include <algorithm>
#include <cmath>

namespace ps::gui {
namespace {

/// A fit may be this much smaller than possible for the sake of a whole-number enlargement.
constexpr double tolerated_loss = 0.8;
constexpr double farthest = 1e9;  // pixels from the picture's corner

}  // namespace

Area PictureTransform::picture_area(Vec2i picture_size, const Area& area) const {
  const ImVec2 middle = area.middle();
  const auto left = static_cast<float>(std::round(middle.x - centre.x * zoom));
  const auto top = static_cast<float>(std::round(middle.y - centre.y * zoom));
  return {{left, top},
          {left + static_cast<float>(picture_size.x * zoom), top + static_cast<float>(picture_size.y * zoom)}};
}

ImVec2 PictureTransform::to_window(Vec2d point, const Area& area) const {
  const ImVec2 corner = picture_area({0, 0}, area).min;
  return {corner.x + static_cast<float>(point.x * zoom), corner.y + static_cast<float>(point.y * zoom)};
}

Vec2d PictureTransform::to_picture(ImVec2 point, const Area& area) const {
  const ImVec2 corner = picture_area({0, 0}, area).min;
  return {(point.x - corner.x) / zoom, (point.y - corner.y) / zoom};
}

Vec2i PictureTransform::pixel_at(ImVec2 point, const Area& area) const {
  const Vec2d place = to_picture(point, area);
  // Without a pointer in the window its place is as far away as a float can say.
  const auto whole = [](double v) { return static_cast<int>(std::clamp(std::floor(v), -farthest, farthest)); };
  return {whole(place.x), whole(place.y)};
}

Area PictureTransform::seen(Vec2i picture_size, const Area& area) const {
  const Area whole = picture_area(picture_size, area);
  return {{std::max(whole.min.x, area.min.x), std::max(whole.min.y, area.min.y)},
          {std::min(whole.max.x, area.max.x), std::min(whole.max.y, area.max.y)}};
}

PictureTransform fitted(Vec2i picture_size, const Area& area) {
  PictureTransform result;
  result.centre = {picture_size.x / 2.0, picture_size.y / 2.0};
  if (picture_size.x <= 0 || picture_size.y <= 0) return result;
  const double exact =
      std::min(static_cast<double>(area.width()) / picture_size.x, static_cast<double>(area.height()) / picture_size.y);
  const double whole = std::floor(exact);
  result.zoom = std::clamp(whole >= exact * tolerated_loss ? whole : exact, smallest_zoom, largest_zoom);
  return result;
}

PictureTransform zoomed_about(const PictureTransform& from, double factor, ImVec2 point, const Area& area) {
  PictureTransform result = from;
  result.zoom = std::clamp(from.zoom * factor, smallest_zoom, largest_zoom);
  const Vec2d fixed = from.to_picture(point, area);
  const ImVec2 middle = area.middle();
  result.centre = {fixed.x - (point.x - middle.x) / result.zoom, fixed.y - (point.y - middle.y) / result.zoom};
  return result;
}

PictureTransform panned(const PictureTransform& from, ImVec2 by, Vec2i picture_size) {
  PictureTransform result = from;
  result.centre.x = std::clamp(from.centre.x - by.x / from.zoom, 0.0, static_cast<double>(picture_size.x));
  result.centre.y = std::clamp(from.centre.y - by.y / from.zoom, 0.0, static_cast<double>(picture_size.y));
  return result;
}

}  // namespace ps::gui
