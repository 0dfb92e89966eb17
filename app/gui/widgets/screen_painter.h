#pragma once
#include <imgui.h>

#include <span>

#include "gui/theme/theme.h"
#include "image/painter.h"

namespace ps::gui {

inline ImVec2 window_place(const Vec2d& place) { return {static_cast<float>(place.x), static_cast<float>(place.y)}; }
inline Vec2d paint_place(ImVec2 place) { return {place.x, place.y}; }
inline PaintArea paint_area(ImVec2 min, ImVec2 max) { return {paint_place(min), paint_place(max)}; }

/// The texture that shows a picture.
struct ScreenPicture {
  const Image<Rgb8>* levels;
  ImTextureID texture;
};

/// The size of a drawing: for those before the window, or in the caption's letters, for the last row behind a
/// projector.
enum class PaintedType { window, projected };

/// Draws into the window, in its pixels.
class ScreenPainter final : public Painter {
 public:
  /// `pictures` are all that picture() may be called with; they must outlive the painter.
  explicit ScreenPainter(ImDrawList& list, std::span<const ScreenPicture> pictures = {},
                         PaintedType type = PaintedType::window)
      : Painter(theme().scale() *
                (type == PaintedType::projected ? type_size(Face::caption) / type_size(Face::body) : 1)),
        list_(list), pictures_(pictures), type_(type) {}

  using Painter::rectangle;
  void polyline(std::span<const Vec2d> points, const Stroke& stroke) override;
  void polygon(std::span<const Vec2d> corners, const ShapeLook& look) override;
  void rectangle(const PaintArea& area, const ShapeLook& look, double rounding) override;
  void circle(const Vec2d& middle, double radius, const ShapeLook& look) override;
  void picture(const PaintArea& area, const Image<Rgb8>& levels) override;
  void begin_clip(const PaintArea& area) override;
  void end_clip() override;
  TextExtent extent(std::string_view text, Lettering lettering) const override;

 private:
  void write(const Vec2d& at, std::string_view words, const TextLook& look) override;
  float width_of(const Stroke& stroke) const;
  ImFont* font_of(Lettering lettering) const;
  /// `along` is the way along a longer line at which this part begins. Returns that at which it ends.
  float dashes(ImVec2 from, ImVec2 to, const Stroke& stroke, float along);
  ImDrawList& list_;
  std::span<const ScreenPicture> pictures_;
  PaintedType type_;
};

}  // namespace ps::gui
