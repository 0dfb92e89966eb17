// Where a vertex lies on the canvas and how deep. Passes that compare depths for equality, and the faces of shadow volumes
// that lie on triangles of the picture, must place their vertices alike.

#if SNAPPED
layout(location = 8) in vec3 snapped;  // canvas position in pixels, and 1; or zeros where it has none
#endif

invariant gl_Position;

uniform mat3 to_world;
uniform vec3 world_shift;
uniform mat3 to_camera;       // from model space, or from the world where positions are not relative to the camera
uniform vec3 camera_shift;
uniform vec2 canvas_scale;    // from x / z to -1..1 across the canvas; y downwards, as the rows of the picture
uniform vec2 canvas_shift;
uniform vec2 canvas_size;     // pixels
uniform float near_z;
uniform float far_share;      // near / far, or 0 without a far limit
uniform float far_z;          // of orthographic pictures

// `model` is a corner_position.
vec3 world_position(vec3 model) {
  return to_world * model + world_shift;
}

vec3 camera_position(vec3 model, vec3 world) {
#if CAMERA_RELATIVE
  return to_camera * model + camera_shift;
#else
  return to_camera * (world - eye);
#endif
}

float clip_w(vec3 camera) {
#if PERSPECTIVE
  return camera.z;
#else
  return 1.0;
#endif
}

// The depth that the driver interpolates and stores, times w. It is 1 / z in disguise, which is linear on the screen.
float clip_depth(float z, float w) {
#if PERSPECTIVE
#if DEPTH_REVERSED
  float depth = (near_z - far_share * z) / (1.0 - far_share);
#else
  float depth = (z - near_z) / (1.0 - far_share);
#endif
#else
  float depth = (z - near_z) / (far_z - near_z);
#endif
#if CLIP_CONTROL
  return depth;
#else
  return 2.0 * depth - w;
#endif
}

vec4 clip_position(vec3 camera) {
  float w = clip_w(camera);
  vec2 place = camera.xy * canvas_scale + canvas_shift * w;
#if SNAPPED
  if (snapped.z > 0.0) place = (2.0 * snapped.xy / canvas_size - 1.0) * w;
#endif
  return vec4(place, clip_depth(camera.z, w), w);
}
