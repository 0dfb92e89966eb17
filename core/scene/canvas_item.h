#pragma once
#include <array>
#include <optional>
#include <string>
#include <variant>

#include "math/vec.h"

namespace ps {

/// How an item's colour meets what is on the canvas already (CGFS ch. 1): paint over it, add light, or take light away
/// as a filter or ink does (the product of both colours).
enum class Blend { replace, additive, subtractive };

/// A line on the canvas, in centred canvas coordinates with y up (CGFS ch. 6).
struct CanvasLine {
  std::array<Vec2d, 2> points{};
  Vec3d colour{0, 0, 0};
  Blend blend = Blend::replace;
  bool operator==(const CanvasLine&) const = default;
};

/// A triangle on the canvas (CGFS ch. 7). `h` is the book's intensity per vertex, multiplied into the colour.
struct CanvasTriangle {
  std::array<Vec2d, 3> points{};
  std::array<Vec3d, 3> colours{};
  std::array<double, 3> h{1, 1, 1};
  bool filled = true;
  Blend blend = Blend::replace;
  std::optional<Vec3d> outline;  ///< colour of an outline drawn over the fill
  bool operator==(const CanvasTriangle&) const = default;
};

using CanvasItem = std::variant<CanvasLine, CanvasTriangle>;

}  // namespace ps
