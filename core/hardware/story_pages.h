#pragma once
#include "math/vec.h"

namespace ps::hardware {

/// What a fragment reports of itself in one draw: four numbers (shaders/story.glsl, fragment.glsl). In the order of the
/// numbers in shader_text.cpp.
enum class Page {
  seen,              ///< 1; triangle; 1 for a front; 1 where cut out + 2 where outside the limits
  weights,           ///< in space; camera z
  screen,            ///< weights on the screen; depth
  normal,            ///< that is shaded with, world space
  unmapped,          ///< the same before a normal map
  uv,                ///< of the surface; where textures are read
  colour,            ///< of the surface after texturing; level of detail that was read, or -1
  texel,             ///< what the texture shows; level that derivatives ask for
  stored,            ///< normal in tangent space; 1 where a map was read
  tangent,           ///< world space
  bitangent,         ///< world space
  relief,            ///< shift of u and v from top to bottom; depth that was met; 1 where there is a relief
  light,             ///< multiplies the colour
  extra,             ///< is added
  shaded,            ///< what the program writes
  to_light,          ///< of one light: not normalised; its cosine
  terms,             ///< of one light: cosine of the highlight, diffuse, specular, share that arrives
  mirrored,          ///< what the environment map shows; face
  mirror_place,      ///< on the face, texels; reflectivity
  mirror_direction,  ///< world space
  unmirrored,        ///< colour before it is mixed
};

/// The first three numbers of a page.
inline Vec3d vector_of(const Vec4f& page) { return Vec3d(Vec3f(page)); }

}  // namespace ps::hardware
