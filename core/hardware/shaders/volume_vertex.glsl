// Places a vertex of a shadow volume (CGFS ch. 15). Those on the object are placed as vertex.glsl places the object's own,
// so that the volume's lit faces lie exactly on its triangles.
#include "carried.glsl"
#include "placing.glsl"

layout(location = 0) in vec4 volume_position;  // w = 0: as corner_position; 1: at the far end, in the world from the eye

uniform mat3 from_world;  // to camera space

void main() {
  vec3 camera = from_world * volume_position.xyz;
  if (volume_position.w == 0.0) camera = camera_position(volume_position.xyz, world_position(volume_position.xyz));
  gl_Position = clip_position(camera);
  carried_z = vec2(camera.z, camera.z * clip_w(camera));
}
