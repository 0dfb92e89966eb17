// Environment mapping (CGFS ch. 15): what an object's cube map shows in the mirrored direction of view, as in
// core/raster/environment/mirror_environment.h.
#include "cube.glsl"

uniform sampler2DArray environment_faces;
uniform int environment_size;  // texels along a side of a face
#if STORY
vec4 story_mirrored = vec4(0.0);  // what the map shows, and on which face, or -1
vec4 story_mirror_place = vec4(0.0);  // position on the face, texels
vec3 story_mirror_direction = vec3(0.0);
vec3 story_unmirrored = vec3(0.0);  // colour before it was mixed
#endif

vec3 environment_texel(ivec2 at, int layer) {
  return texelFetch(environment_faces, ivec3(clamp(at, ivec2(0), ivec2(environment_size - 1)), layer), 0).rgb;
}

// Bilinear within the face that the direction goes through.
vec3 look_up_environment(vec3 direction, int first_layer) {
  int face = cube_face_of(direction);
  vec2 place = face_position(in_face(face, direction), environment_size) - 0.5;
  ivec2 corner = ivec2(floor(place));
  vec2 share = place - floor(place);
  int layer = first_layer + face;
  vec3 top = environment_texel(corner, layer) * (1.0 - share.x) + environment_texel(corner + ivec2(1, 0), layer) * share.x;
  vec3 bottom = environment_texel(corner + ivec2(0, 1), layer) * (1.0 - share.x) +
                environment_texel(corner + ivec2(1, 1), layer) * share.x;
  return top * (1.0 - share.y) + bottom * share.y;
}

// The colour mixed with what is mirrored. `normal` has length 1. Where light is added up pass by pass, the reflection
// comes with the first pass.
vec3 mirror_environment(vec3 colour, vec3 position, vec3 normal, float reflective, int first_layer, bool first_pass) {
  vec3 rest = colour * (1.0 - reflective);
  if (!first_pass) return rest;
  vec3 to_eye = direction_to_eye(position);
  vec3 direction = normal * (2.0 * dot(normal, to_eye)) - to_eye;
#if STORY
  int face = cube_face_of(direction);
  story_mirrored = vec4(look_up_environment(direction, first_layer), float(face));
  story_mirror_place = vec4(face_position(in_face(face, direction), environment_size), reflective, 0.0);
  story_mirror_direction = direction;
  story_unmirrored = colour;
#endif
  return rest + look_up_environment(direction, first_layer) * reflective;
}
