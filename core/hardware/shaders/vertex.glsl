// Places one vertex of a triangle on the canvas, and gives the values that are carried across the triangle. Vertices
// are drawn without indices: vertex number gl_VertexID % 3 of triangle gl_VertexID / 3.
#include "carried.glsl"
#include "placing.glsl"
#include "unit.glsl"
#if SHADING == GOURAUD || SHADING == FLAT
#include "lighting.glsl"
#endif

layout(location = 0) in vec3 corner_position;  // of the model, as MeshBuffers::place() gives it
layout(location = 1) in vec4 corner_normal;    // model space; w = 0: the triangle's own, 1: the vertex's
layout(location = 2) in vec2 corner_uv;
layout(location = 3) in vec3 triangle_normal;  // model space
#if SHADING == FLAT
layout(location = 4) in vec3 triangle_centre;  // as corner_position
layout(location = 5) in vec4 normal_0;         // those of the three vertices, as corner_normal
layout(location = 6) in vec4 normal_1;
layout(location = 7) in vec4 normal_2;
#endif
#if RELIEF
layout(location = 9) in vec3 triangle_along_u;  // model space
layout(location = 10) in vec3 triangle_upwards;
#endif

#if STORY
// What a vertex reports of itself to the inspector: where light was computed for it, and how much.
out vec3 story_point;         // world space
out vec3 story_point_normal;
out vec3 story_point_light;
out vec3 story_point_extra;
out vec4 story_point_to_light;  // of light number story_light: see lighting.glsl
out vec4 story_point_terms;
#endif

uniform mat3 normal_matrix;   // of vertices' normals, as the option normal-transform asks
uniform mat3 surface_matrix;  // of triangles' own normals

vec3 world_normal(vec4 normal) {
  return unit_or_zero(normal.w > 0.0 ? normal_matrix * normal.xyz : surface_matrix * normal.xyz);
}

void main() {
  vec3 world = world_position(corner_position);
  vec3 camera = camera_position(corner_position, world);
  float w = clip_w(camera);
  gl_Position = clip_position(camera);

  vec3 own_normal = unit_or_zero(surface_matrix * triangle_normal);
#if !TRIANGLE_NORMALS
  vec3 normal = world_normal(corner_normal);
#else
  vec3 normal = own_normal;
#endif
  float share = CARRIED_SHARE(w);
  carried_position = world * share;
  carried_normal = normal * share;
  carried_uv = corner_uv * share;
  carried_weights = vec3(equal(ivec3(gl_VertexID % 3), ivec3(0, 1, 2)));
  carried_z = vec2(camera.z, camera.z * w);
  face_normal = own_normal;
#if EXACT_PLACES
  plane_point = world;
#endif
  triangle_number = gl_VertexID / 3;
#if RELIEF
  along_u = to_world * triangle_along_u;
  upwards = to_world * triangle_upwards;
  // A common factor cancels, and the fourth power of these lengths must be a float.
  float reach = max(length_of(along_u), length_of(upwards));
  if (reach > 32768.0 || reach < 1.0 / 32768.0 && reach > 0.0) {
    along_u /= reach;
    upwards /= reach;
  }
#endif
#if SHADING == GOURAUD
  Lighting lighting = illuminate(world, normal, Tints(specular_colour, ambient_colour, exponent), camera.z);
  carried_light = lighting.light * share;
  carried_extra = lighting.extra * share;
#elif SHADING == FLAT
#if !TRIANGLE_NORMALS
  vec3 mean = unit_or_zero((world_normal(normal_0) + world_normal(normal_1) + world_normal(normal_2)) / 3.0);
#else
  vec3 mean = own_normal;
#endif
  Lighting lighting = illuminate(to_world * triangle_centre + world_shift, mean, Tints(specular_colour, ambient_colour, exponent), camera.z);
  flat_light = lighting.light;
  flat_extra = lighting.extra;
#endif
#if STORY
#if PERSPECTIVE
  story_screen = carried_weights * w;
#else
  story_screen = carried_weights;
#endif
  story_point = world;
  story_point_normal = normal;
  story_point_light = story_point_extra = vec3(0.0);
  story_point_to_light = story_point_terms = vec4(0.0);
#if SHADING == FLAT
  story_point = to_world * triangle_centre + world_shift;
  story_point_normal = mean;
#endif
#if SHADING == GOURAUD || SHADING == FLAT
  story_point_light = lighting.light;
  story_point_extra = lighting.extra;
  story_point_to_light = story_to_light;
  story_point_terms = story_terms;
#endif
#endif
}
