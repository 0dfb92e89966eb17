// How much of a light a point sees, from the light's shadow map: core/raster/shadow/shadow_lookup.h. A point light has
// the six faces of a cube around it, each seen with a right angle of view; a directional one has one square.

#include "cube.glsl"

// Of each light: position and number of its first layer, or -1; right and half the side of the square; up, and 1 for a
// cube; forward.
layout(std140) uniform ShadowMaps {
  vec4 maps[4 * LIGHTS];
};

uniform sampler2DArray shadow_depths;  // along the face's forward axis; a large number where nothing is seen
uniform int shadow_map_size;           // texels
uniform float shadow_bias;             // world units
uniform float shadow_slope_bias;       // texels; below 0: what filter and slope need
// How far triangles lie within a round surface: per unit of z.
#if SHADES_WHOLE_PICTURE
float surface_error_scale;  // read for each pixel
#else
uniform float surface_error_scale;
#endif

// Whether the texel's surface is not nearer to the light than the point. One beyond a cube's edge is looked up on the
// next face, along whose axis the point has another depth.
bool sees_light(int first_layer, bool cube, int face, ivec2 texel, vec3 from_light, float depth, float bias) {
  if (any(lessThan(texel, ivec2(0))) || any(greaterThanEqual(texel, ivec2(shadow_map_size)))) {
    if (!cube) return true;
    float half_size = float(shadow_map_size) / 2.0;
    vec2 place = vec2(texel) + 0.5;
    vec3 direction = out_of_face(face, vec3((place.x - half_size) / half_size, (half_size - place.y) / half_size, 1.0));
    face = cube_face_of(direction);
    texel = clamp(ivec2(face_position(in_face(face, direction), shadow_map_size)), ivec2(0), ivec2(shadow_map_size - 1));
    depth = in_face(face, from_light).z;
  }
  float stored = texelFetch(shadow_depths, ivec3(texel, first_layer + face), 0).r;
  return !(stored < depth - bias);
}

int first_tap(float place) {
#if SHADOW_FILTER % 2 == 0
  place += 0.5;
#endif
  return clamp(int(floor(place)), 0, shadow_map_size - 1) - SHADOW_FILTER / 2;
}

float visible_share(int light, vec3 position, vec3 normal, float z) {
  vec4 about_position = maps[4 * light];
  int first_layer = int(about_position.w);
  if (first_layer < 0) return 1.0;
  float half_side = maps[4 * light + 1].w;
  bool cube = maps[4 * light + 2].w > 0.0;
  vec3 from_light = position - about_position.xyz;
  int face = cube ? cube_face_of(from_light) : 0;
  vec3 local, n, along;
  float texel_width;
  vec2 place;
  if (cube) {
    local = in_face(face, from_light);
    n = in_face(face, normal);
    if (!(local.z > 0.0)) return 1.0;
    place = face_position(local, shadow_map_size);
    texel_width = 2.0 * local.z / float(shadow_map_size);
    along = local / local.z;
  } else {
    vec3 right = maps[4 * light + 1].xyz;
    vec3 up = maps[4 * light + 2].xyz;
    vec3 forward = maps[4 * light + 3].xyz;
    local = vec3(dot(right, from_light), dot(up, from_light), dot(forward, from_light));
    n = vec3(dot(right, normal), dot(up, normal), dot(forward, normal));
    if (!(abs(local.x) < half_side && abs(local.y) < half_side)) return 1.0;
    place = face_position(vec3(local.xy, half_side), shadow_map_size);
    texel_width = 2.0 * half_side / float(shadow_map_size);
    along = vec3(0.0, 0.0, 1.0);
  }
  float facing = abs(dot(n, along));
  float across = length(n.xy);
  float slope = across < 100.0 * facing ? across / facing : across > 0.0 ? 100.0 : 0.0;
  bool derived = shadow_slope_bias < 0.0;
  float texels = derived ? float(SHADOW_FILTER) * 0.70710678118654752 + 1.0 / 256.0 : shadow_slope_bias;
  float bias = shadow_bias + texels * texel_width * slope;
  if (derived) bias += abs(local.z) * 9.5367431640625e-7 + surface_error_scale * (PERSPECTIVE == 1 ? z : 1.0) * sqrt(1.0 + slope * slope);
  ivec2 first = ivec2(first_tap(place.x), first_tap(place.y));
  int lit = 0;
  for (int y = 0; y < SHADOW_FILTER; ++y)
    for (int x = 0; x < SHADOW_FILTER; ++x)
      if (sees_light(first_layer, cube, face, first + ivec2(x, y), from_light, local.z, bias)) ++lit;
  return float(lit) / float(SHADOW_FILTER * SHADOW_FILTER);
}
