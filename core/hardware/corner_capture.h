#pragma once
#include <array>
#include <functional>

#include "math/vec.h"

namespace ps::hardware {

/// A vertex of a triangle as the vertex shader reports it: what transform feedback keeps of vertex.glsl, in this order.
struct CapturedCorner {
  Vec4f clip{0, 0, 0, 1};  ///< gl_Position; y downwards
  Vec2f camera_z{0, 0};    ///< camera space; and times w
  Vec3f point{0, 0, 0};    ///< where light was computed: the vertex, or with flat shading the triangle's centre; world
  Vec3f normal{0, 0, 0};   ///< there
  Vec3f light{0, 0, 0};    ///< multiplies the colour; zeros with Phong shading
  Vec3f extra{0, 0, 0};    ///< is added
  Vec4f to_light{0, 0, 0, 0};  ///< of one light, as Page::to_light and Page::terms
  Vec4f terms{0, 0, 0, 0};
};
static_assert(sizeof(CapturedCorner) == 26 * sizeof(float));

using CapturedTriangle = std::array<CapturedCorner, 3>;

/// For Program: the outputs that make a CapturedCorner.
inline constexpr std::array<const char*, 8> captured_outputs{
    "gl_Position",       "carried_z",         "story_point",          "story_point_normal",
    "story_point_light", "story_point_extra", "story_point_to_light", "story_point_terms"};

/// Keeps the vertices of one triangle, which `draw` draws with the program in use. Nothing is rasterized.
CapturedTriangle capture_corners(const std::function<void()>& draw);

}  // namespace ps::hardware
