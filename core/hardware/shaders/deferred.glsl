// Deferred shading (CGPP 15.8.3): lights what fragment.glsl has kept of each pixel, in the order in which it would itself.
#include "carried.glsl"
#include "lighting.glsl"
#if MIRRORS
#include "environment.glsl"
#endif

#if STORY
#include "story.glsl"
vec4 fragment_colour;
#else
layout(location = 0) out vec4 fragment_colour;
#endif

uniform sampler2D geometry_surface;
uniform sampler2D geometry_normal;
uniform sampler2D geometry_position;
uniform sampler2D geometry_tint_0;
uniform sampler2D geometry_tint_1;
// Of each surface two texels: exponent, whether it has a specular colour and an ambient one, error of its triangles; then
// how much it reflects, and the first layer of its environment map or -1.
uniform sampler2D surface_table;

vec4 of_surface(int number, int part) {
  return texelFetch(surface_table, ivec2(2 * (number % TABLE_COLUMNS) + part, number / TABLE_COLUMNS), 0);
}

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec4 surface = texelFetch(geometry_surface, at, 0);
  if (surface.w < 0.0) discard;
  vec4 constants = of_surface(int(surface.w), 0);
  vec4 normal = texelFetch(geometry_normal, at, 0);
  vec3 position = texelFetch(geometry_position, at, 0).xyz;
  vec3 tint_0 = texelFetch(geometry_tint_0, at, 0).xyz;
  vec3 tint_1 = texelFetch(geometry_tint_1, at, 0).xyz;
  vec3 colour = surface.xyz;
#if STORY
  Lighting story_lighting = Lighting(vec3(1.0), vec3(0.0));
#endif
#if SHADING == PHONG
#if SHADOW_MAPS
  surface_error_scale = constants.w;
#endif
  Tints tints = Tints(vec4(tint_0, constants.y), vec4(tint_1, constants.z), constants.x);
  Lighting lighting = illuminate(position, normal.xyz, tints, normal.w);
  colour = colour * lighting.light + lighting.extra;
#if STORY
  story_lighting = lighting;
#endif
#elif SHADING != UNLIT
  colour = colour * tint_0 + tint_1;
#if STORY
  story_lighting = Lighting(tint_0, tint_1);
#endif
#endif
#if MIRRORS
  vec2 mirror = of_surface(int(surface.w), 1).xy;
#if ONE_LIGHT
  bool first_pass = light_number == first_light;
#else
  bool first_pass = true;
#endif
  vec3 unit_normal = unit_or_zero(normal.xyz);
  if (mirror.y >= 0.0)
    colour = mirror_environment(colour, position, unit_normal, mirror.x, int(mirror.y), first_pass);
#endif
  fragment_colour = vec4(colour, 1.0);
#if STORY
  story_value = vec4(0.0);
  if (story_page == PAGE_NORMAL) story_value = vec4(normal.xyz, 0.0);
  if (story_page == PAGE_COLOUR) story_value = vec4(surface.xyz, -1.0);
  report_shading(story_lighting, fragment_colour);
#endif
}
