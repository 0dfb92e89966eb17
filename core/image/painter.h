#pragma once
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "image/image.h"
#include "math/vec.h"

namespace ps {

/// What a colour is for. A light window, a dark one and paper each have their own shade of it.
enum class Role {
  ink,
  quiet,   ///< text and lines that stand back
  border,  ///< frames
  faint,   ///< grids
  paper,   ///< the ground
  a,       ///< picture A alone
  b,
  right,
  wrong,
  attention,
  light,   ///< light sources and rays from them
  mirror,  ///< reflected rays
  dark,    ///< the same everywhere, as pictures are: a dark line with a bright rim is seen on all of them
  bright,
  own  ///< Tint::own
};
/// A colour by its role.
struct Tint {
  Role role = Role::ink;
  double opacity = 1;
  Rgb8 own = {};  ///< for Role::own
};

/// Pixels at scale 1 that are drawn and left out in turn.
struct Dash {
  double on = 0, off = 0;
  bool operator==(const Dash&) const = default;
};
inline constexpr Dash unbroken{}, dashed{8, 5}, short_dashes{4, 5}, dotted{2.5, 4};

struct Stroke {
  Tint tint = {};
  double width = 1;  ///< pixels at scale 1
  Dash dash = unbroken;
};

/// The inside and the outline of a shape.
struct ShapeLook {
  std::optional<Tint> fill = {};
  std::optional<Stroke> stroke = {};
};

/// The faces of a drawing, with the sizes of the window's: 13, 17 and 22 pixels at scale 1, scripts of formulas 0.7 of
/// the text's.
enum class Lettering { label, strong_label, body, strong, italic, heading, script, script_strong, script_italic };
enum class TextAnchor { start, middle, end };
enum class TextLevel { baseline, middle, top };
/// What separates a text from the lines behind it.
enum class TextGround { none, plate, rim };

struct TextLook {
  Lettering lettering = Lettering::label;
  TextAnchor anchor = TextAnchor::start;
  TextLevel level = TextLevel::baseline;  ///< the part of the line that lies at the place
  Tint tint = {};
  TextGround ground = TextGround::none;
  Tint ground_tint = {Role::paper, 0.85};
};

/// Size of a line of text, in the painter's pixels.
struct TextExtent {
  double width = 0;
  double above = 0, below = 0;  ///< the baseline
  double height() const { return above + below; }
};

/// A rectangle of a drawing.
struct PaintArea {
  Vec2d low{0, 0}, high{0, 0};
  double width() const { return high.x - low.x; }
  double height() const { return high.y - low.y; }
};

/// Draws on the screen or into a file. Places are pixels, y down; widths of lines, dashes and letters are pixels at
/// scale 1. Later things lie over earlier ones.
class Painter {
 public:
  virtual ~Painter() = default;

  /// A length at scale 1 in the painter's pixels.
  double px(double at_scale_1) const { return at_scale_1 * scale_; }

  virtual void polyline(std::span<const Vec2d> points, const Stroke& stroke) = 0;
  /// `corners` of a convex polygon.
  virtual void polygon(std::span<const Vec2d> corners, const ShapeLook& look) = 0;
  /// `rounding` is the radius of its corners, in pixels.
  virtual void rectangle(const PaintArea& area, const ShapeLook& look, double rounding) = 0;
  virtual void circle(const Vec2d& middle, double radius, const ShapeLook& look) = 0;
  /// A picture stretched over a rectangle, its pixels as hard squares.
  virtual void picture(const PaintArea& area, const Image<Rgb8>& levels) = 0;
  /// Cuts all that follows to a rectangle, until end_clip().
  virtual void begin_clip(const PaintArea& area) = 0;
  virtual void end_clip() = 0;
  /// A file shows `words` to a pointer over what follows, until end_named(). The screen has its own tooltips.
  virtual void begin_named(const std::function<std::string()>& /*words*/) {}
  virtual void end_named() {}
  /// Size of UTF-8 text on one line. A file can only estimate the width, as it is shown in another program's fonts.
  virtual TextExtent extent(std::string_view text, Lettering lettering) const = 0;

  void line(const Vec2d& from, const Vec2d& to, const Stroke& stroke);
  void rectangle(const PaintArea& area, const ShapeLook& look) { rectangle(area, look, 0); }
  /// Part of a circle. Angles in radians from the right, clockwise as y points down.
  void arc(const Vec2d& middle, double radius, double from, double to, const Stroke& stroke);
  /// One line of text.
  void text(const Vec2d& at, std::string_view words, const TextLook& look);

 protected:
  explicit Painter(double scale) : scale_(scale) {}
  Painter(const Painter&) = default;
  Painter& operator=(const Painter&) = delete;

 private:
  /// `at` lies on the baseline; the ground of the look is a rim or none.
  virtual void write(const Vec2d& at, std::string_view words, const TextLook& look) = 0;
  double scale_;
};

/// The text in lines of at most this width, broken at blanks. A longer word gets a line of its own.
std::vector<std::string> lines_of(const Painter& painter, std::string_view text, Lettering lettering, double width);

}  // namespace ps
