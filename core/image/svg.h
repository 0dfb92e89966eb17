#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "image/image.h"
#include "math/vec.h"

namespace ps {

/// How a line or an area looks in a drawing. Colours are "#rrggbb"; an empty one is left out.
struct SvgStyle {
  std::string_view stroke = "#202020";
  double width = 1;            ///< of lines, in user units
  std::string_view dash = {};  ///< "5 4"
  std::string_view fill = {};  ///< of areas
  double opacity = 1;
};

enum class SvgAnchor { start, middle, end };

/// A drawing in Scalable Vector Graphics 1.1 that needs no other file: white paper, pictures inside it. Coordinates are
/// user units (pixels) from the top left, y down; text is escaped.
class SvgDrawing {
 public:
  SvgDrawing(double width, double height, std::string_view title);

  void line(const Vec2d& from, const Vec2d& to, const SvgStyle& style);
  void polygon(const std::vector<Vec2d>& corners, const SvgStyle& style);
  void circle(const Vec2d& middle, double radius, const SvgStyle& style);
  void text(const Vec2d& at, std::string_view words, double size = 12, SvgAnchor anchor = SvgAnchor::start,
            bool bold = false);
  /// A picture stretched over a rectangle, its pixels as hard squares.
  void picture(const Vec2d& low, const Vec2d& high, const Image<Rgb8>& levels);
  /// Cuts all that follows, until end_group(), to a rectangle.
  void begin_clip(const Vec2d& low, const Vec2d& high);
  void end_clip();
  /// The file's text.
  std::string finish() const { return body_ + "</svg>\n"; }

 private:
  std::string body_;
  int clips_ = 0;
};

/// The bytes in base 64 (RFC 4648), on one line.
std::string base64(std::string_view bytes);
/// Text with the five characters that mean something in XML written as entities.
std::string xml_escaped(std::string_view text);

}  // namespace ps
