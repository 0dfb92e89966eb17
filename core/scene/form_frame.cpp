#include "scene/form_frame.h"

#include <algorithm>
#include <cmath>

#include "math/unit.h"

namespace ps {
namespace {

/// Two directions so that the three together are a right-handed frame; along the world's axes where that is possible.
void complete(FormFrame& frame, const Vec3d& direction) {
  const Vec3d axis = unit_of(direction);
  const Vec3d helper = std::abs(axis.x) < 0.6 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0};
  const Vec3d side = unit_of(helper - axis * dot(helper, axis));
  frame.axes = {side, cross(axis, side), axis};
}

FormFrame frame_of(const Ball& ball) {
  FormFrame frame;
  frame.centre = ball.centre;
  frame.half = Vec3d(ball.radius);
  return frame;
}

FormFrame frame_of(const Plane& plane) {
  FormFrame frame;
  frame.kind = FormKind::plane;
  frame.centre = plane.point;
  complete(frame, plane.normal);
  return frame;
}

FormFrame frame_of(const Rectangle& rectangle) {
  FormFrame frame;
  frame.kind = FormKind::rectangle;
  frame.centre = rectangle.corner;
  const Vec3d a = unit_of(rectangle.side_a), b = unit_of(rectangle.side_b);
  const Vec3d across = cross(rectangle.side_a, rectangle.side_b);  // too short to be squared where the sides are
  frame.axes = {a, b, has_exact_square(dot(across, across)) ? unit_of(across) : unit_of(cross(a, b))};
  frame.half = {length_of(rectangle.side_a), length_of(rectangle.side_b), 0};
  return frame;
}

FormFrame frame_of(const Brick& brick) {
  FormFrame frame;
  frame.kind = FormKind::brick;
  frame.centre = brick.centre;
  frame.axes = {unit_of(brick.rotation[0]), unit_of(brick.rotation[1]), unit_of(brick.rotation[2])};
  frame.half = brick.size * 0.5;
  return frame;
}

FormFrame frame_of(const Cylinder& cylinder) {
  FormFrame frame;
  frame.kind = FormKind::cylinder;
  frame.centre = cylinder.from;
  complete(frame, cylinder.to - cylinder.from);
  frame.half = {cylinder.radius, cylinder.radius, length_of(cylinder.to - cylinder.from)};
  return frame;
}

FormBox around(const Vec3d& centre, const Vec3d& reach) { return {centre - reach, centre + reach}; }

FormBox joined(const FormBox& a, const FormBox& b) {
  FormBox box;
  for (int axis = 0; axis < 3; ++axis) {
    box.low[axis] = std::min(a.low[axis], b.low[axis]);
    box.high[axis] = std::max(a.high[axis], b.high[axis]);
  }
  return box;
}

FormBox common(const FormBox& a, const FormBox& b) {
  FormBox box;
  for (int axis = 0; axis < 3; ++axis) {
    box.low[axis] = std::max(a.low[axis], b.low[axis]);
    box.high[axis] = std::max(std::min(a.high[axis], b.high[axis]), box.low[axis]);
  }
  return box;
}

/// Around the corners of the box where the map takes them.
FormBox moved_box(const FormBox& box, const PartPlace& place) {
  if (place.is_identity() || !is_bounded(box)) return box;
  FormBox result;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3d p{(corner & 1 ? box.high : box.low).x, (corner & 2 ? box.high : box.low).y,
                  (corner & 4 ? box.high : box.low).z};
    const Vec3d moved = place.linear * p + place.translation;
    result = corner == 0 ? FormBox{moved, moved} : joined(result, {moved, moved});
  }
  return result;
}

}  // namespace

FormFrame form_frame(const Form& form) {
  return std::visit([](const auto& one) { return frame_of(one); }, form);
}

FormBox form_box(const FormFrame& frame) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto& [x, y, z] = frame.axes;
  switch (frame.kind) {
  case FormKind::ball:
    return around(frame.centre, frame.half);
  case FormKind::plane:
    return {Vec3d(-infinity), Vec3d(infinity)};
  case FormKind::rectangle: {
    const Vec3d a = x * frame.half.x, b = y * frame.half.y;
    return joined({glm::min(frame.centre, frame.centre + a), glm::max(frame.centre, frame.centre + a)},
                  {glm::min(frame.centre + b, frame.centre + a + b), glm::max(frame.centre + b, frame.centre + a + b)});
  }
  case FormKind::brick:
    return around(frame.centre, glm::abs(x) * frame.half.x + glm::abs(y) * frame.half.y + glm::abs(z) * frame.half.z);
  case FormKind::cylinder: {
    const Vec3d reach{std::sqrt(std::max(1 - z.x * z.x, 0.0)), std::sqrt(std::max(1 - z.y * z.y, 0.0)),
                      std::sqrt(std::max(1 - z.z * z.z, 0.0))};
    return joined(around(frame.centre, reach * frame.half.x),
                  around(frame.centre + z * frame.half.z, reach * frame.half.x));
  }
  }
  return {};
}

FormBox solid_box(const Solid& solid) { return moved_box(form_box(form_frame(solid.form)), solid.place); }

FormBox csg_box(const CsgNode& node) {
  if (node.children.empty()) return solid_box(node.part);
  FormBox box = csg_box(node.children.front());
  for (std::size_t i = 1; i < node.children.size(); ++i) {
    switch (node.operation) {
    case CsgOperation::union_of:
      box = joined(box, csg_box(node.children[i]));
      break;
    case CsgOperation::intersection:
      box = common(box, csg_box(node.children[i]));
      break;
    case CsgOperation::difference:
      break;
    }
  }
  return box;
}

bool is_bounded(const FormBox& box) {
  for (int axis = 0; axis < 3; ++axis)
    if (!std::isfinite(box.low[axis]) || !std::isfinite(box.high[axis])) return false;
  return true;
}

}  // namespace ps
