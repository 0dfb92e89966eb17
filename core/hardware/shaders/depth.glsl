// The depth of a fragment, where the driver cannot interpolate what the options ask for. Everything is mapped to 0..1,
// the range of a depth buffer; a factor that is a power of two changes no comparison.

uniform float depth_near;    // what the range from 0 to 1 begins with
uniform float depth_far;     // where it ends; 0: nowhere
uniform float depth_factor;  // of depths that are kept as they are
uniform float depth_steps;   // of integers: 2^bits
uniform vec2 plane_scale;    // pixels per unit of x / z
uniform vec2 plane_centre;   // the centre of the picture, pixels

// Where the ray of the fragment crosses the plane one unit before the eye.
vec2 on_projection_plane() {
  return (gl_FragCoord.xy - plane_centre) / plane_scale;
}

float depth_value() {
#if DEPTH_VALUE == DEPTH_INVERSE_Z
#if PERSPECTIVE
  return gl_FragCoord.w;
#else
  return 1.0 / carried_z.x;
#endif
#elif DEPTH_VALUE == DEPTH_Z
#if PERSPECTIVE
  return carried_z.y * gl_FragCoord.w;  // linear on the screen, which z is not
#else
  return carried_z.x;
#endif
#else
#if PERSPECTIVE
  vec2 p = on_projection_plane();
  return sqrt(dot(p, p) + 1.0) / gl_FragCoord.w;
#else
  return carried_z.x;
#endif
#endif
}

float encoded_depth() {
  float raw = depth_value();
#if DEPTH_FORMAT == DEPTH_PLAIN
  return raw * depth_factor;
#else
#if DEPTH_VALUE == DEPTH_INVERSE_Z
  float end = depth_far > 0.0 ? depth_near / depth_far : 0.0;
#if DEPTH_REVERSED
  float share = (depth_near * raw - end) / (1.0 - end);
#else
  float share = (1.0 - depth_near * raw) / (1.0 - end);
#endif
#else
#if DEPTH_REVERSED
  float share = (depth_far - raw) / (depth_far - depth_near);
#else
  float share = (raw - depth_near) / (depth_far - depth_near);
#endif
#endif
  share = clamp(share, 0.0, 1.0);
#if DEPTH_FORMAT == DEPTH_UNORM
  return floor(share * (depth_steps - 1.0) + 0.5) / depth_steps;
#else
  return share;
#endif
#endif
}
