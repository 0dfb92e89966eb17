// A fragment of a shadow volume only counts in the stencil buffer, whether it lies before the surface or behind it.
#include "carried.glsl"
#include "limits.glsl"
#if DEPTH_BY_SHADER
#include "depth.glsl"
#endif

void main() {
  if (outside_limits()) discard;
#if DEPTH_BY_SHADER
  gl_FragDepth = encoded_depth();
#endif
}
