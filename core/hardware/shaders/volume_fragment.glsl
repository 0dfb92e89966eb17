// A fragment of a shadow volume only counts in the stencil buffer, whether it lies before the surface or behind it.
#include "carried.glsl"
#include "limits.glsl"
#if DEPTH_BY_SHADER
#include "depth.glsl"
#endif
#if STORY
layout(location = 0) out vec4 story_value;  // camera z; 1 for a front; 1 outside the limits; 1: it is drawn
#endif

void main() {
#if STORY
#if PERSPECTIVE
  float z = 1.0 / gl_FragCoord.w;
#else
  float z = carried_z.x;
#endif
  story_value = vec4(z, gl_FrontFacing, outside_limits(), 1.0);
#else
  if (outside_limits()) discard;
#endif
#if DEPTH_BY_SHADER
  gl_FragDepth = encoded_depth();
#endif
}
