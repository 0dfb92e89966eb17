#include "scene/place_body.h"

#include <cmath>

#include <glm/matrix.hpp>

#include "math/unit.h"

namespace ps {
namespace {

/// The one factor by which a map changes all lengths; 0 if there is none.
double common_scale(const Mat3d& linear) {
  constexpr double rounding = 1e-12;
  const double scale = length_of(linear[0]);
  for (int axis = 0; axis < 3; ++axis) {
    if (!(std::abs(length_of(linear[axis]) - scale) <= rounding * scale)) return 0;
    if (!(std::abs(dot(linear[axis], linear[(axis + 1) % 3])) <= rounding * scale * scale)) return 0;
  }
  return scale;
}

decltype(Object::shape) as_shape(const Solid& body) {
  if (const auto* ball = std::get_if<Ball>(&body.form)) return Sphere{ball->centre, ball->radius, body.material};
  return body;
}

}  // namespace

decltype(Object::shape) placed_body(const Solid& body, const PartPlace& around, const Material& material) {
  if (around.is_identity()) return as_shape(body);
  Solid placed = body;
  const double scale = common_scale(around.linear);
  const bool turns = around.linear != Mat3d(scale);
  const bool box = std::holds_alternative<Brick>(body.form);
  // A box has axes of its own, to which its picture is fixed, but none of them can be mirrored.
  const bool keeps_kind =
      box ? scale > 0 && determinant(around.linear) > 0 : scale > 0 && !(turns && needs_uv(material));
  if (!keeps_kind) {
    placed.place = around;
    return placed;
  }
  const auto moved = [&](const Vec3d& p) { return around.linear * p + around.translation; };
  if (auto* ball = std::get_if<Ball>(&placed.form)) {
    *ball = {moved(ball->centre), ball->radius * scale};
  } else if (auto* brick = std::get_if<Brick>(&placed.form)) {
    brick->centre = moved(brick->centre);
    brick->size *= scale;
    if (turns) brick->rotation = around.linear / scale * brick->rotation;
  } else if (auto* cylinder = std::get_if<Cylinder>(&placed.form)) {
    *cylinder = {moved(cylinder->from), moved(cylinder->to), cylinder->radius * scale};
  }
  return as_shape(placed);
}

}  // namespace ps
