#pragma once
#include <string>
#include <string_view>

#include "image/painter.h"

namespace ps {

/// The shade of a role on paper, for all roles but Role::own: that of a light window, on white.
Rgb8 paper_shade(Role role);
/// Height of an em in pixels at scale 1.
double em_of(Lettering lettering);

/// A drawing in Scalable Vector Graphics 1.1 that needs no other file: white paper, pictures inside it. Text is
/// escaped.
class SvgPainter final : public Painter {
 public:
  SvgPainter(double width, double height, std::string_view title);

  using Painter::rectangle;
  void polyline(std::span<const Vec2d> points, const Stroke& stroke) override;
  void polygon(std::span<const Vec2d> corners, const ShapeLook& look) override;
  void rectangle(const PaintArea& area, const ShapeLook& look, double rounding) override;
  void circle(const Vec2d& middle, double radius, const ShapeLook& look) override;
  void picture(const PaintArea& area, const Image<Rgb8>& levels) override;
  void begin_clip(const PaintArea& area) override;
  void end_clip() override;
  void begin_named(const std::function<std::string()>& words) override;
  void end_named() override;
  TextExtent extent(std::string_view text, Lettering lettering) const override;
  /// The file's text.
  std::string finish() const { return body_ + "</svg>\n"; }

 private:
  void write(const Vec2d& at, std::string_view words, const TextLook& look) override;
  std::string body_;
  int clips_ = 0;
};

/// The bytes in base 64 (RFC 4648), on one line.
std::string base64(std::string_view bytes);
/// Text with the five characters that mean something in XML written as entities.
std::string xml_escaped(std::string_view text);

}  // namespace ps
