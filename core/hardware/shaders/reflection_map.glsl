// A material's picture of its surroundings (MTL: refl) in the mirrored direction of view, with the formulas of
// core/shade/reflection_map.h and core/scene/uv_maps.h. CUBE_CROSS: the cross of a folded-out cube, else a map of the world.
uniform sampler2D reflection_picture;
uniform ivec4 reflection_layout;  // width and height first
#if STORY
vec4 story_mirrored = vec4(0.0);  // what the picture shows
vec4 story_mirror_place = vec4(0.0);  // u and v, and the share of what is reflected
vec3 story_mirror_direction = vec3(0.0);
vec3 story_unmirrored = vec3(0.0);  // colour before it was mixed
#endif

#if CUBE_CROSS
// Faces as in uv_maps.h; `p` lies on the cube from -1 to 1.
vec2 cube_cross_uv(int face, vec3 p) {
  vec3 s = (p + 1.0) * 0.5;
  vec2 cell = vec2(1.0, 1.0), within = vec2(s.x, 1.0 - s.y);
  if (face == 0) cell = vec2(0.0, 1.0), within = vec2(1.0 - s.z, 1.0 - s.y);
  if (face == 1) cell = vec2(2.0, 1.0), within = vec2(s.z, 1.0 - s.y);
  if (face == 2) cell = vec2(1.0, 2.0), within = vec2(s.x, s.z);
  if (face == 3) cell = vec2(1.0, 0.0), within = vec2(s.x, 1.0 - s.z);
  if (face == 5) cell = vec2(3.0, 1.0), within = vec2(1.0 - s.x, 1.0 - s.y);
  return (cell + within) / vec2(4.0, 3.0);
}
#endif

vec2 reflection_uv(vec3 direction) {
  vec2 half_texel = 0.5 / vec2(reflection_layout.xy);
#if CUBE_CROSS
  int axis = 0;
  for (int i = 1; i < 3; ++i)
    if (abs(direction[i]) > abs(direction[axis])) axis = i;
  int face = 2 * axis + (direction[axis] > 0.0 ? 1 : 0);
  vec3 on_face = direction / abs(direction[axis]);
  vec3 middle_point = vec3(0.0);
  middle_point[axis] = on_face[axis];
  vec2 middle = cube_cross_uv(face, middle_point);
  vec2 reach = max(vec2(1.0 / 8.0, 1.0 / 6.0) - half_texel, vec2(0.0));
  return clamp(cube_cross_uv(face, on_face), middle - reach, middle + reach);
#else
  const float pi = 3.14159265358979;
  vec3 unit = unit_of(direction);
  vec2 uv = vec2(0.5 + atan(unit.x, -unit.z) / (2.0 * pi), acos(clamp(unit.y, -1.0, 1.0)) / pi);
  return vec2(uv.x, clamp(uv.y, half_texel.y, 1.0 - half_texel.y));
#endif
}

// Of the finest level, which lies first in the picture of all levels; repeated beyond its borders.
vec3 reflection_texel(ivec2 at) {
  ivec2 size = reflection_layout.xy;
  return texelFetch(reflection_picture, ((at % size) + size) % size, 0).rgb;
}

vec3 look_up_reflection(vec2 uv) {
  vec2 place = uv * vec2(reflection_layout.xy);
#if TEXTURE_FILTER == FILTER_NEAREST
  return reflection_texel(ivec2(floor(place)));
#else
  place -= 0.5;
  ivec2 corner = ivec2(floor(place));
  vec2 share = place - floor(place);
  vec3 top = reflection_texel(corner) * (1.0 - share.x) + reflection_texel(corner + ivec2(1, 0)) * share.x;
  vec3 bottom = reflection_texel(corner + ivec2(0, 1)) * (1.0 - share.x) + reflection_texel(corner + ivec2(1, 1)) * share.x;
  return top * (1.0 - share.y) + bottom * share.y;
#endif
}

// The colour mixed with what is mirrored. `normal` has length 1. Where light is added up pass by pass, the reflection
// comes with the first pass.
vec3 reflect_picture(vec3 colour, vec3 position, vec3 normal, float reflective, bool first_pass) {
  vec3 rest = colour * (1.0 - reflective);
  if (!first_pass) return rest;
  vec3 to_eye = direction_to_eye(position);
  vec3 direction = normal * (2.0 * dot(normal, to_eye)) - to_eye;
  vec2 uv = reflection_uv(direction);
  vec3 reflected = look_up_reflection(uv);
#if STORY
  story_mirrored = vec4(reflected, 0.0);
  story_mirror_place = vec4(uv, reflective, 0.0);
  story_mirror_direction = direction;
  story_unmirrored = colour;
#endif
  return rest + reflected * reflective;
}
