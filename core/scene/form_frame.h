#pragma once
#include <array>
#include <limits>

#include "scene/solid.h"

namespace ps {

enum class FormKind { ball, plane, rectangle, brick, cylinder };

/// A form in one shape for all kinds, world space. The axes have length 1 and are perpendicular to each other.
///   ball       half.x = radius
///   plane      axes[2] = normal
///   rectangle  centre = its corner, axes[0] and [1] along the sides, half.x and half.y their whole lengths
///   brick      axes along its edges, half their half lengths
///   cylinder   centre = `from`, axes[2] towards `to`, half.x = radius, half.z = whole height
struct FormFrame {
  FormKind kind = FormKind::ball;
  Vec3d centre{0, 0, 0};
  std::array<Vec3d, 3> axes{Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}};
  Vec3d half{1, 1, 1};
};

FormFrame form_frame(const Form& form);

/// A box around the form; a plane's is infinite.
struct FormBox {
  Vec3d low{std::numeric_limits<double>::infinity()}, high{-std::numeric_limits<double>::infinity()};
};
FormBox form_box(const FormFrame& frame);
/// A box around the body where its place puts it.
FormBox solid_box(const Solid& solid);
/// A box around what the operations leave; it may be infinite.
FormBox csg_box(const CsgNode& node);
bool is_bounded(const FormBox& box);

}  // namespace ps
