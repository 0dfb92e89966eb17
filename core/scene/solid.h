#pragma once
#include <cstdint>
#include <string_view>
#include <variant>
#include <vector>

#include "math/vec.h"

namespace ps {

/// Primitives other than spheres on their own and models (CGFS ch. 5). All in world space.

struct Ball {
  Vec3d centre{0, 0, 0};
  double radius = 1;
  bool operator==(const Ball&) const = default;
};

/// Infinite. As a solid: everything behind it.
struct Plane {
  Vec3d point{0, 0, 0};
  Vec3d normal{0, 1, 0};  ///< towards the front, any length
  bool operator==(const Plane&) const = default;
};

/// Its front is the side to which cross(side_a, side_b) points. The sides are perpendicular.
struct Rectangle {
  Vec3d corner{0, 0, 0};
  Vec3d side_a{1, 0, 0}, side_b{0, 1, 0};
  bool operator==(const Rectangle&) const = default;
};

struct Brick {
  Vec3d centre{0, 0, 0};
  Vec3d size{1, 1, 1};  ///< whole lengths of its edges
  Mat3d rotation{1.0};  ///< columns are the directions of its edges
  bool operator==(const Brick&) const = default;
};

/// With a flat cap at both ends.
struct Cylinder {
  Vec3d from{0, 0, 0}, to{0, 1, 0};  ///< centres of the caps
  double radius = 1;
  bool operator==(const Cylinder&) const = default;
};

using Form = std::variant<Ball, Plane, Rectangle, Brick, Cylinder>;

/// The sides from which a surface is visible. A two-sided rectangle or plane turns its normal to the viewer; a body
/// with two sides can be seen from within.
enum class Sides { two, front };

/// Where a part of a CSG tree lies, or a body in a group that stretches it: `linear` * p + `translation`, any affine
/// map that can be inverted (CGPP ex. 15.7b).
struct PartPlace {
  Mat3d linear{1.0};
  Vec3d translation{0, 0, 0};
  bool operator==(const PartPlace&) const = default;
  bool is_identity() const { return *this == PartPlace{}; }
  /// This map after `inner`.
  PartPlace after(const PartPlace& inner) const {
    return {linear * inner.linear, linear * inner.translation + translation};
  }
};

/// A form with its surface.
struct Solid {
  Form form;
  std::uint32_t material = 0;  ///< index into Scene::materials
  Sides sides = Sides::two;
  PartPlace place{};  ///< of the form; parts of CSG trees have one, and bodies that a group stretches
  bool operator==(const Solid&) const = default;
};

enum class CsgOperation { union_of, intersection, difference };

/// One node of a tree of constructive solid geometry: `part` itself, or `operation` on the children; a difference takes
/// all others out of the first.
struct CsgNode {
  CsgOperation operation = CsgOperation::union_of;
  std::vector<CsgNode> children;  ///< none: the node is a part
  Solid part;                     ///< any form but a rectangle
  bool operator==(const CsgNode& other) const {
    return operation == other.operation && children == other.children && part == other.part;
  }
};

/// Solid bodies combined by CSG (CGFS ch. 5). Cut faces have the material of the part that made the cut.
struct Csg {
  CsgNode root;
  bool operator==(const Csg&) const = default;
};

inline constexpr std::size_t max_csg_parts = 32;

/// The parts of a tree from left to right; in pictures their index is where others have the triangle's.
std::vector<const Solid*> csg_parts(const CsgNode& root);
std::vector<Solid*> csg_parts(CsgNode& root);

/// "box", as scene files call it.
std::string_view form_name(const Form& form);
std::string_view operation_name(CsgOperation operation);
/// Has it no inside? True for a rectangle and a plane on their own.
bool is_flat(const Form& form);

}  // namespace ps
