// The near and far limits, fragment by fragment. A driver that clips gives triangles new vertices, and a lit face of a
// shadow volume, which ends elsewhere, would no longer lie exactly on its triangle; so pictures with volumes clamp depths
// in place of clipping, and what lies outside is left out here.
uniform float near_z;
uniform float far_limit;  // 0: none

bool outside_limits() {
#if PERSPECTIVE
  float inverse_z = gl_FragCoord.w;
  return inverse_z * near_z > 1.0 || inverse_z * far_limit < 1.0 && far_limit > 0.0;
#else
  return carried_z.x < near_z || carried_z.x > far_limit && far_limit > 0.0;
#endif
}
