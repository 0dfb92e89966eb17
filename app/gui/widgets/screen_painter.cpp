#include "gui/widgets/screen_painter.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/enumerators.h"
#include "gui/theme/shade.h"

namespace ps::gui {
namespace {

constexpr float longest_dashed = 20000;  // pixels: what is longer lies outside the window, and is left out

ImU32 colour_of(const Tint& tint) {
  if (tint.role != Role::own) return colour_u32(shade(palette(), tint.role), tint.opacity);
  return IM_COL32(tint.own.r, tint.own.g, tint.own.b, static_cast<int>(std::lround(255 * tint.opacity)));
}

/// Faces by Lettering.
constexpr std::array<Face, enumerator_count<Lettering>()> faces{Face::small,  Face::small_bold,  Face::body,
                                                                Face::bold,   Face::italic,      Face::heading,
                                                                Face::script, Face::script_bold, Face::script_italic};

/// The same for the last row behind a projector; scripts are the size below the caption's.
constexpr std::array<Face, enumerator_count<Lettering>()> projected_faces{
    Face::caption, Face::caption, Face::caption, Face::caption, Face::caption_italic,
    Face::caption, Face::bold,    Face::bold,    Face::italic};

}  // namespace

ImFont* ScreenPainter::font_of(Lettering lettering) const {
  const auto& all = type_ == PaintedType::projected ? projected_faces : faces;
  return theme().font(all[static_cast<std::size_t>(lettering)]);
}

float ScreenPainter::width_of(const Stroke& stroke) const {
  return std::max(1.f, static_cast<float>(px(stroke.width)));
}

float ScreenPainter::dashes(ImVec2 from, ImVec2 to, const Stroke& stroke, float along) {
  const float length = std::hypot(to.x - from.x, to.y - from.y);
  if (!(length > 0) || length > longest_dashed) return along;
  const auto on = static_cast<float>(px(stroke.dash.on)), whole = on + static_cast<float>(px(stroke.dash.off));
  const ImVec2 unit{(to.x - from.x) / length, (to.y - from.y) / length};
  const auto place = [&](float way) { return ImVec2{from.x + unit.x * way, from.y + unit.y * way}; };
  for (float begin = -std::fmod(along, whole); begin < length; begin += whole)
    if (begin + on > 0)
      list_.AddLine(place(std::max(begin, 0.f)), place(std::min(begin + on, length)), colour_of(stroke.tint),
                    width_of(stroke));
  return along + length;
}

void ScreenPainter::polyline(std::span<const Vec2d> points, const Stroke& stroke) {
  if (points.size() == 2 && stroke.dash == unbroken)
    return list_.AddLine(window_place(points[0]), window_place(points[1]), colour_of(stroke.tint), width_of(stroke));
  if (stroke.dash == unbroken) {
    for (const Vec2d& point : points) list_.PathLineTo(window_place(point));
    return list_.PathStroke(colour_of(stroke.tint), ImDrawFlags_None, width_of(stroke));
  }
  float along = 0;
  for (std::size_t i = 1; i < points.size(); ++i)
    along = dashes(window_place(points[i - 1]), window_place(points[i]), stroke, along);
}

void ScreenPainter::polygon(std::span<const Vec2d> corners, const ShapeLook& look) {
  if (look.fill) {
    for (const Vec2d& corner : corners) list_.PathLineTo(window_place(corner));
    list_.PathFillConvex(colour_of(*look.fill));
  }
  if (!look.stroke) return;
  if (look.stroke->dash == unbroken) {
    for (const Vec2d& corner : corners) list_.PathLineTo(window_place(corner));
    return list_.PathStroke(colour_of(look.stroke->tint), ImDrawFlags_Closed, width_of(*look.stroke));
  }
  float along = 0;
  for (std::size_t i = 0; i < corners.size(); ++i)
    along = dashes(window_place(corners[i]), window_place(corners[(i + 1) % corners.size()]), *look.stroke, along);
}

void ScreenPainter::rectangle(const PaintArea& area, const ShapeLook& look, double rounding) {
  const ImVec2 low = window_place(area.low), high = window_place(area.high);
  const auto round = static_cast<float>(rounding);
  if (look.fill) list_.AddRectFilled(low, high, colour_of(*look.fill), round);
  if (look.stroke) list_.AddRect(low, high, colour_of(look.stroke->tint), round, 0, width_of(*look.stroke));
}

void ScreenPainter::circle(const Vec2d& middle, double radius, const ShapeLook& look) {
  const auto r = static_cast<float>(radius);
  if (look.fill) list_.AddCircleFilled(window_place(middle), r, colour_of(*look.fill));
  if (look.stroke) list_.AddCircle(window_place(middle), r, colour_of(look.stroke->tint), 0, width_of(*look.stroke));
}

void ScreenPainter::picture(const PaintArea& area, const Image<Rgb8>& levels) {
  const auto shown = std::find_if(pictures_.begin(), pictures_.end(),
                                  [&](const ScreenPicture& picture) { return picture.levels == &levels; });
  PS_ASSERT(shown != pictures_.end(), "a picture without a texture");
  list_.AddImage(shown->texture, window_place(area.low), window_place(area.high));
}

void ScreenPainter::begin_clip(const PaintArea& area) {
  list_.PushClipRect(window_place(area.low), window_place(area.high), true);
}

void ScreenPainter::end_clip() { list_.PopClipRect(); }

TextExtent ScreenPainter::extent(std::string_view text, Lettering lettering) const {
  ImFont* font = font_of(lettering);
  const ImVec2 size = font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, text.data(), text.data() + text.size());
  return {size.x, font->Ascent, font->FontSize - font->Ascent};
}

void ScreenPainter::write(const Vec2d& at, std::string_view words, const TextLook& look) {
  ImFont* font = font_of(look.lettering);
  const double share = look.anchor == TextAnchor::start ? 0 : look.anchor == TextAnchor::middle ? 0.5 : 1;
  const double width = look.anchor == TextAnchor::start ? 0 : extent(words, look.lettering).width;
  const ImVec2 corner{std::round(static_cast<float>(at.x - share * width)),
                      std::round(static_cast<float>(at.y) - font->Ascent)};
  const auto put = [&](float x, float y, const Tint& tint) {
    list_.AddText(font, font->FontSize, {corner.x + x, corner.y + y}, colour_of(tint), words.data(),
                  words.data() + words.size());
  };
  const auto rim = std::max(1.f, std::round(static_cast<float>(px(1))));
  if (look.ground == TextGround::rim)
    for (const float x : {-rim, rim})
      for (const float y : {-rim, rim}) put(x, y, look.ground_tint);
  put(0, 0, look.tint);
}

}  // namespace ps::gui
