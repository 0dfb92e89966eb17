// The colour of one fragment (CGFS ch. 13 and 14), in the order of core/raster/clear/shade_fragment.h.
#include "carried.glsl"
#include "unit.glsl"
#if DEFERRED
#include "tints.glsl"
#elif SHADING == PHONG
#include "lighting.glsl"
#elif SHADOW_MAPS
#include "shadows.glsl"
#endif
#if MIRRORS && !DEFERRED
#include "environment.glsl"
#endif
#if REFLECTION_MAP && !DEFERRED
#include "reflection_map.glsl"
#endif
#if READS_TEXTURES
#include "texturing.glsl"
#endif
#if RELIEF
#include "relief.glsl"
#endif
#if DEPTH_BY_SHADER
#include "depth.glsl"
#endif
#if LIMITS_BY_SHADER
#include "limits.glsl"
#endif

// The inspector asks for pages in place of the outputs.
#if STORY
#define OUTPUT(place)
#else
#define OUTPUT(place) layout(location = place) out
#endif

// With deferred shading, what deferred.glsl reads in place of the colour.
#if DEFERRED
OUTPUT(0) vec4 geometry_surface;   // the surface's own colour, and its number
OUTPUT(1) vec4 geometry_normal;    // shading normal, and z
OUTPUT(2) vec4 geometry_position;  // world space
OUTPUT(3) vec4 geometry_tint_0;    // specular colour; with Gouraud and flat shading the light
OUTPUT(4) vec4 geometry_tint_1;    // ambient colour; with Gouraud and flat shading the extra light
uniform int surface_number;
#else
OUTPUT(0) vec4 fragment_colour;
#endif
#if CHANNELS
#if DEFERRED
OUTPUT(5) ivec4 fragment_ids;
OUTPUT(6) vec4 fragment_normal;
OUTPUT(7) vec4 fragment_weights;
#else
OUTPUT(1) ivec4 fragment_ids;     // object, triangle, bits of z, bits of the level of detail
OUTPUT(2) vec4 fragment_normal;   // shading normal, and the cosine of the facing
OUTPUT(3) vec4 fragment_weights;  // of vertices 0 and 1, or NO_WEIGHTS without numbers; then u and v
#endif
#endif

#if STORY
#include "story.glsl"
#endif

uniform vec3 surface_colour;
#if MIRRORS || REFLECTION_MAP
uniform float reflective;
#endif
#if MIRRORS
uniform int environment_layer;  // the first of the object's map
#endif
uniform int object_number;
uniform int numbered;  // 0: its triangles have no numbers of their own
#define NO_WEIGHTS -1e30
#if TEXTURE
uniform sampler2D surface_picture;
uniform ivec4 surface_layout;
uniform int surface_wrap;
#endif
#if NORMAL_MAP
uniform sampler2D normal_picture;
uniform ivec4 normal_layout;
uniform int normal_wrap;
#endif
#if OPACITY_MAP
uniform sampler2D opacity_picture;
uniform ivec4 opacity_layout;
uniform int opacity_wrap;
#endif
#if SPECULAR_MAP
uniform sampler2D specular_picture;
uniform ivec4 specular_layout;
uniform int specular_wrap;
#endif
#if AMBIENT_MAP
uniform sampler2D ambient_picture;
uniform ivec4 ambient_layout;
uniform int ambient_wrap;
#endif
#if CHANNELS || EXACT_PLACES
uniform vec3 camera_right;
uniform vec3 camera_up;
uniform vec3 camera_forward;
uniform vec2 view_scale;   // pixels per unit of the camera's right and up, on the plane one unit before the eye
uniform vec2 view_centre;
#endif

#if CHANNELS || EXACT_PLACES
vec2 on_canvas() {
  return (gl_FragCoord.xy - view_centre) / view_scale;
}

// The ray of the fragment, not normalised.
vec3 ray_direction() {
#if PERSPECTIVE
  vec2 p = on_canvas();
  return camera_right * p.x + camera_up * p.y + camera_forward;
#else
  return camera_forward;
#endif
}
#endif

// A carried value as it is at the fragment.
#if PERSPECTIVE && AFFINE
#define AT_FRAGMENT(value) ((value) * gl_FragCoord.w)
#else
#define AT_FRAGMENT(value) (value)
#endif

// The place that is lit. Where a light nearly touches a surface, the place that a driver interpolates may be farther from the true
// one than the light is: there it is computed as a ray tracer does, where the ray meets the triangle's plane.
vec3 lit_place() {
#if EXACT_PLACES
  vec3 ray = ray_direction();
#if PERSPECTIVE
  vec3 from = eye;
#else
  vec2 p = on_canvas();
  vec3 from = eye + camera_right * p.x + camera_up * p.y;
#endif
  float facing = dot(face_normal, ray);
  if (abs(facing) > 1e-3 * length_of(ray)) return from + ray * (dot(face_normal, plane_point - from) / facing);
#endif
  return AT_FRAGMENT(carried_position);
}

float camera_z() {
#if PERSPECTIVE
  return 1.0 / gl_FragCoord.w;
#else
  return carried_z.x;
#endif
}

#if READS_TEXTURES
// How fast u and v change from pixel to pixel. u / z and 1 / z are linear on the screen, so their differences between
// neighbours are exact; the quotient rule gives those of u itself. For main() alone, before it branches.
void uv_steps(vec2 uv, out vec2 dx, out vec2 dy) {
#if PERSPECTIVE && !AFFINE
  float inverse_z = gl_FragCoord.w;
  vec2 linear = carried_uv * inverse_z;
  dx = (dFdx(linear) - uv * dFdx(inverse_z)) / inverse_z;
  dy = (dFdy(linear) - uv * dFdy(inverse_z)) / inverse_z;
#else
  dx = dFdx(uv);
  dy = dFdy(uv);
#endif
}

Footprint footprint_on(ivec4 layout_of, vec2 dx, vec2 dy) {
  return Footprint(dx * vec2(layout_of.xy), dy * vec2(layout_of.xy));
}
#define READ(picture, layout_of, wrap, at) read_texture(picture, layout_of, wrap, at, footprint_on(layout_of, dx, dy))
#endif

void main() {
#if DEPTH_BY_SHADER
  gl_FragDepth = encoded_depth();
#endif
  vec2 surface_uv = AT_FRAGMENT(carried_uv);
#if READS_TEXTURES
  vec2 dx, dy;
  uv_steps(surface_uv, dx, dy);
#endif
  vec2 uv = surface_uv;
  vec3 colour = surface_colour;
  float level = -1.0;
#if LIMITS_BY_SHADER
#if STORY
  story_outside = outside_limits();
#else
  if (outside_limits()) discard;
#endif
#endif
#if OPACITY_MAP
  bool cut_out = READ(opacity_picture, opacity_layout, opacity_wrap, surface_uv).colour.x < 0.5;
#if STORY
  story_cut_out = cut_out;
#else
  if (cut_out) discard;
#endif
#endif
#if INTERPOLATED_NORMAL
  vec3 normal = AT_FRAGMENT(carried_normal);
#else
  vec3 normal = face_normal;
#endif
#if RELIEF
#if PARALLAX != PARALLAX_OFF
  uv = relief_uv(surface_uv, normal, direction_to_eye(AT_FRAGMENT(carried_position)),
                 footprint_on(height_layout, dx, dy));
#endif
#endif
#if TEXTURE
  TextureRead of_surface = READ(surface_picture, surface_layout, surface_wrap, uv);
  colour *= of_surface.colour;
  level = of_surface.level;
#endif
#if NORMAL_MAP
  normal = mapped_normal(normal, READ(normal_picture, normal_layout, normal_wrap, uv).colour);
#endif
#if STORY
  vec3 story_surface = colour;
  Lighting story_lighting = Lighting(vec3(1.0), vec3(0.0));
#endif
  vec3 unit_normal = unit_or_zero(normal);
#if RENORMALISE
  normal = unit_normal;
#endif
#if SHADING == PHONG
  Tints tints = Tints(specular_colour, ambient_colour, exponent);
#if SPECULAR_MAP
  tints.specular.xyz *= READ(specular_picture, specular_layout, specular_wrap, uv).colour;
#endif
#if AMBIENT_MAP
  tints.ambient.xyz *= READ(ambient_picture, ambient_layout, ambient_wrap, uv).colour;
#endif
#if !DEFERRED
  Lighting lighting = illuminate(lit_place(), normal, tints, camera_z());
#endif
#elif SHADING == GOURAUD
  Lighting lighting = Lighting(AT_FRAGMENT(carried_light), AT_FRAGMENT(carried_extra));
#elif SHADING == FLAT
  Lighting lighting = Lighting(flat_light, flat_extra);
#endif
#if DEFERRED
  geometry_surface = vec4(colour, float(surface_number));
  geometry_normal = vec4(normal, camera_z());
  geometry_position = vec4(lit_place(), 1.0);
#if SHADING == PHONG
  geometry_tint_0 = tints.specular;
  geometry_tint_1 = tints.ambient;
#elif SHADING != UNLIT
  geometry_tint_0 = vec4(lighting.light, 1.0);
  geometry_tint_1 = vec4(lighting.extra, 1.0);
#else
  geometry_tint_0 = geometry_tint_1 = vec4(0.0);
#endif
#else
#if SHADING != UNLIT
#if SHADOW_MAPS && SHADING != PHONG
  float visible =
      light_number < 0 ? 1.0 : visible_share(light_number, AT_FRAGMENT(carried_position), normal, camera_z());
  lighting = Lighting(lighting.light * visible, lighting.extra * visible);
#endif
  colour = colour * lighting.light + lighting.extra;
#if STORY
  story_lighting = lighting;
#endif
#endif
#if MIRRORS || REFLECTION_MAP
#if ONE_LIGHT
  bool first_pass = light_number == first_light;
#else
  bool first_pass = true;
#endif
#endif
#if REFLECTION_MAP
  colour = reflect_picture(colour, AT_FRAGMENT(carried_position), unit_normal, reflective, first_pass);
#elif MIRRORS
  colour =
      mirror_environment(colour, AT_FRAGMENT(carried_position), unit_normal, reflective, environment_layer, first_pass);
#endif
  fragment_colour = vec4(colour, 1.0);
#endif
#if CHANNELS
  fragment_ids =
      ivec4(object_number, numbered == 1 ? triangle_number : 0, floatBitsToInt(camera_z()), floatBitsToInt(level));
  vec3 ray = ray_direction();
  fragment_normal = vec4(NORMAL_CHANNEL == 1 ? unit_normal : vec3(0.0), -dot(ray, face_normal) / length_of(ray));
  fragment_weights = vec4(numbered == 1 ? carried_weights.xy : vec2(NO_WEIGHTS), uv);
#endif
#if STORY
  vec3 unmapped = INTERPOLATED_NORMAL == 1 ? AT_FRAGMENT(carried_normal) : face_normal;
  float depth = gl_FragCoord.z;
#if DEPTH_BY_SHADER
  depth = gl_FragDepth;
#endif
#if PERSPECTIVE
  vec3 screen = story_screen * gl_FragCoord.w;
#else
  vec3 screen = story_screen;
#endif
  vec4 texel = vec4(0.0);
#if TEXTURE
  texel = vec4(of_surface.colour, asked_level(footprint_on(surface_layout, dx, dy)));
#endif
  story_value = vec4(0.0);
  switch (story_page) {
    case PAGE_SEEN:
      story_value = vec4(1.0, triangle_number, gl_FrontFacing, (story_cut_out ? 1 : 0) + (story_outside ? 2 : 0));
      break;
    case PAGE_WEIGHTS:
      story_value = vec4(carried_weights, camera_z());
      break;
    case PAGE_SCREEN:
      story_value = vec4(screen, depth);
      break;
    case PAGE_NORMAL:
      story_value = vec4(normal, 0.0);
      break;
    case PAGE_UNMAPPED:
      story_value = vec4(unmapped, 0.0);
      break;
    case PAGE_UV:
      story_value = vec4(surface_uv, uv);
      break;
    case PAGE_COLOUR:
      story_value = vec4(story_surface, level);
      break;
    case PAGE_TEXEL:
      story_value = texel;
      break;
#if RELIEF
    case PAGE_STORED:
      story_value = story_stored;
      break;
    case PAGE_TANGENT:
      story_value = vec4(story_tangent, 0.0);
      break;
    case PAGE_BITANGENT:
      story_value = vec4(story_bitangent, 0.0);
      break;
    case PAGE_RELIEF:
      story_value = story_relief;
      break;
#endif
  }
#if !DEFERRED
  report_shading(story_lighting, fragment_colour);
#endif
#endif
}
