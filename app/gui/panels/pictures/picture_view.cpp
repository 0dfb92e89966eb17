#include "gui/panels/pictures/picture_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gui/platform/texture.h"
#include "gui/widgets/draw.h"

namespace ps::gui {
namespace {

constexpr double grid_from = 10;     // pixels this large get lines between them, at scale 1
constexpr double numbers_from = 52;  // and numbers in them
constexpr int loupe_pixels = 15;     // shown across

ImU32 with_alpha(ImU32 colour, unsigned alpha) { return (colour & ~IM_COL32_A_MASK) | (alpha << IM_COL32_A_SHIFT); }
const ImU32 black = IM_COL32(0, 0, 0, 255);
const ImU32 white = IM_COL32(255, 255, 255, 255);

/// The pixels of a picture that an area shows, half-open.
TileRect visible_pixels(const ShownPicture& picture, const PictureTransform& transform, const Area& area) {
  const Vec2i first = transform.pixel_at(area.min, area);
  const Vec2i last = transform.pixel_at(area.max, area);
  return {std::max(first.x, 0), std::max(first.y, 0), std::min(last.x + 1, picture.levels.width()),
          std::min(last.y + 1, picture.levels.height())};
}

void draw_grid(ImDrawList& list, const TileRect& pixels, const PictureTransform& transform, const Area& area) {
  const ImU32 line = IM_COL32(128, 128, 128, 90);
  const ImVec2 low = transform.to_window({pixels.x0, pixels.y0}, area);
  const ImVec2 high = transform.to_window({pixels.x1, pixels.y1}, area);
  for (int x = pixels.x0; x <= pixels.x1; ++x) {
    const float at = std::round(transform.to_window({x, 0}, area).x);
    list.AddLine({at, low.y}, {at, high.y}, line);
  }
  for (int y = pixels.y0; y <= pixels.y1; ++y) {
    const float at = std::round(transform.to_window({0, y}, area).y);
    list.AddLine({low.x, at}, {high.x, at}, line);
  }
}

std::string levels_text(Rgb8 level) { return fmt::format("{:3}\n{:3}\n{:3}", level.r, level.g, level.b); }

/// Black or white, whichever reads better on the colour.
ImU32 readable_on(Rgb8 colour) {
  const double luminance = 0.2126 * colour.r + 0.7152 * colour.g + 0.0722 * colour.b;
  return luminance > 115 ? black : white;
}

void draw_numbers(ImDrawList& list, const ShownPicture& picture, const TileRect& pixels,
                  const PictureTransform& transform, const Area& area, const PictureStyle& style) {
  ImFont* font = theme().font(Face::mono);
  const float size = font->FontSize;
  for (int y = pixels.y0; y < pixels.y1; ++y) {
    for (int x = pixels.x0; x < pixels.x1; ++x) {
      const Rgb8 level = picture.levels.at(x, y);
      const std::string text = style.text_at ? style.text_at({x, y}) : levels_text(level);
      const ImVec2 middle = transform.to_window({x + 0.5, y + 0.5}, area);
      const ImVec2 extent = font->CalcTextSizeA(size, FLT_MAX, 0, text.c_str());
      if (extent.x > transform.zoom) continue;
      list.AddText(font, size, {std::round(middle.x - extent.x / 2), std::round(middle.y - extent.y / 2)},
                   readable_on(level), text.c_str());
    }
  }
}

}  // namespace

void ShownPicture::upload(const std::vector<TileRect>& changed) {
  if (levels.empty() || changed.empty()) return;
  if (texture.width() != levels.width() || texture.height() != levels.height()) {
    texture.upload(levels);
    return;
  }
  for (const auto& rect : changed) texture.upload(levels, rect);
}

void draw_mark(ImDrawList& list, ImVec2 min, ImVec2 max) {
  const float least = px(4);
  const ImVec2 middle{(min.x + max.x) / 2, (min.y + max.y) / 2};
  const float half = std::max((max.x - min.x) / 2, least) + 1;
  const ImVec2 low{std::round(middle.x - half) - 0.5f, std::round(middle.y - half) - 0.5f};
  const ImVec2 high{std::round(middle.x + half) + 0.5f, std::round(middle.y + half) + 0.5f};
  const ImU32 bright = colour_u32(palette().attention);
  const float gap = px(3), arm = px(8);
  const auto strokes = [&](ImU32 colour, float thickness) {
    list.AddRect(low, high, colour, 0, 0, thickness);
    if (high.x - low.x > px(24)) return;  // large enough to be found without arms, which would lie on its neighbours
    list.AddLine({low.x - gap - arm, middle.y}, {low.x - gap, middle.y}, colour, thickness);
    list.AddLine({high.x + gap, middle.y}, {high.x + gap + arm, middle.y}, colour, thickness);
    list.AddLine({middle.x, low.y - gap - arm}, {middle.x, low.y - gap}, colour, thickness);
    list.AddLine({middle.x, high.y + gap}, {middle.x, high.y + gap + arm}, colour, thickness);
  };
  strokes(black, px(4));
  strokes(bright, px(2));
}

void draw_picture(ImDrawList& list, const ShownPicture& picture, const PictureTransform& transform, const Area& area,
                  const PictureStyle& style) {
  if (picture.texture.empty()) return;
  list.PushClipRect(area.min, area.max, true);
  const Area whole = transform.picture_area(picture.size(), area);
  add_plain_texture(list, picture.texture, whole.min, whole.max);
  if (style.grid && transform.zoom >= px(grid_from)) {
    const TileRect pixels = visible_pixels(picture, transform, area);
    draw_grid(list, pixels, transform, area);
    if (transform.zoom >= px(numbers_from)) draw_numbers(list, picture, pixels, transform, area, style);
  }
  if (style.region) {
    const ImVec2 low = transform.to_window({style.region->x0, style.region->y0}, area);
    const ImVec2 high = transform.to_window({style.region->x1, style.region->y1}, area);
    list.AddRect({low.x - px(1), low.y - px(1)}, {high.x + px(1), high.y + px(1)}, black, 0, 0, px(3));
    list.AddRect({low.x - px(1), low.y - px(1)}, {high.x + px(1), high.y + px(1)}, white, 0, 0, px(1));
  }
  if (style.marked)
    draw_mark(list, transform.to_window({style.marked->x, style.marked->y}, area),
              transform.to_window({style.marked->x + 1, style.marked->y + 1}, area));
  list.PopClipRect();
}

void draw_loupe(ImDrawList& list, const ShownPicture& picture, Vec2i pixel, const Area& area) {
  list.PushClipRect(area.min, area.max, false);
  list.AddRectFilled(area.min, area.max, colour_u32(palette().window));
  if (!picture.texture.empty()) {
    PictureTransform transform;
    transform.zoom = area.width() / loupe_pixels;
    transform.centre = {pixel.x + 0.5, pixel.y + 0.5};
    const Area whole = transform.picture_area(picture.size(), area);
    add_plain_texture(list, picture.texture, whole.min, whole.max);
    draw_mark(list, transform.to_window({pixel.x, pixel.y}, area),
              transform.to_window({pixel.x + 1, pixel.y + 1}, area));
  }
  list.AddRect(area.min, area.max, with_alpha(colour_u32(palette().line_strong), 255), 0, 0, px(2));
  list.PopClipRect();
}

void draw_notice(ImDrawList& list, const Area& area, const std::string& text, Face face) {
  const FontScope font(face);
  const std::string lines = in_lines(text, area.width() * 0.9f);
  const float margin = px(12);
  const ImVec2 extent{text_width(lines), text_height(lines)};
  const ImVec2 corner{std::round(area.middle().x - extent.x / 2), std::round(area.middle().y - extent.y / 2)};
  list.AddRectFilled({corner.x - margin, corner.y - margin},
                     {corner.x + extent.x + margin, corner.y + extent.y + margin}, colour_u32(palette().panel), px(4));
  list.AddText(corner, colour_u32(palette().text), lines.c_str());
}

}  // namespace ps::gui
