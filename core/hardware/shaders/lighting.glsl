// The illumination equation of CGFS ch. 3 and 4, in the order of core/shade/illumination.h, under LIGHTS lights.
#include "power.glsl"
#include "tints.glsl"
#include "unit.glsl"
#if SHADOW_MAPS && SHADING == PHONG
#include "shadows.glsl"
#endif

#if LIGHTS > 0
// Of each light: colour and intensity; position or direction, and kind; attenuation, and whether it attenuates; the
// colours of its highlights and of the ambient light that it adds everywhere.
#if TERM_COLOURS
const int light_rows = 5;
#else
const int light_rows = 3;  // one colour for all
#endif
layout(std140) uniform Lights {
  vec4 lights[light_rows * LIGHTS];
};
#endif

#if STORY
// Of light number story_light, for the inspector.
uniform int story_light;
vec4 story_to_light = vec4(0.0);  // not normalised; and its cosine with the normal
vec4 story_terms = vec4(0.0);     // cosine of the highlight, diffuse, specular, share that reaches the point
#endif

const float pi = 3.14159265358979;

// However near a light is, no more arrives.
const float least = 1.17549435e-38;
float spread(float intensity, float divisor) {
  return min(intensity / max(divisor, least), 1e12);
}

#if LIGHTS > 0
// What arrives of the light's intensity before the angle counts.
float arriving(int i, vec3 to_light) {
  float intensity = lights[light_rows * i].w;
  if (int(lights[light_rows * i + 1].w) != POINT_LIGHT) return intensity;
  float square = dot(to_light, to_light);
  bool exact = factor_for_square(square) == 1.0;
  float distance = exact ? sqrt(square) : max(length_of(to_light), least);
#if RADIOMETRIC
  if (!exact) return spread(intensity / (4.0 * pi) / distance, distance);
  return spread(intensity, 4.0 * pi * square);
#elif ATTENUATION
  vec4 attenuation = lights[light_rows * i + 2];
  if (attenuation.w == 0.0) return intensity;
  float quadratic = exact ? attenuation.z * square : attenuation.z * distance * distance;
  return spread(intensity, attenuation.x + attenuation.y * distance + quadratic);
#else
  return intensity;
#endif
}

// The cosine that decides how bright the highlight is, or 0.
float highlight_cosine(vec3 normal, vec3 to_light, vec3 to_eye) {
#if BLINN_PHONG
  vec3 a = normal;
  vec3 b = unit_of(to_light) + unit_of(to_eye);
#else
  vec3 a = normal * (2.0 * dot(normal, to_light)) - to_light;
  vec3 b = to_eye;
#endif
  float product = dot(a, b);
  return product > 0.0 ? product / (length_of(a) * length_of(b)) : 0.0;
}

void add_ambient(vec3 light, Tints tints, inout Lighting sum) {
  if (tints.ambient.w > 0.0)
    sum.extra += tints.ambient.xyz * light;
  else
    sum.light += light;
}

#if TERM_COLOURS
// The ambient light that a light of another kind adds. Shadows do not stop it, so that it comes before them.
void add_ambient_of(int i, vec3 position, Tints tints, inout Lighting sum) {
  int kind = int(lights[light_rows * i + 1].w);
  if (kind == AMBIENT_LIGHT) return;
  vec3 vector = lights[light_rows * i + 1].xyz;
  vec3 to_light = kind == POINT_LIGHT ? vector - position : vector;
  add_ambient(lights[light_rows * i + 4].xyz * arriving(i, to_light), tints, sum);
}
#endif

void add_light(int i, vec3 position, vec3 normal, Tints tints, float z, inout Lighting sum) {
  vec3 colour = lights[light_rows * i].xyz;
  int kind = int(lights[light_rows * i + 1].w);
  if (kind == AMBIENT_LIGHT) {
    add_ambient(colour * lights[light_rows * i].w, tints, sum);
#if STORY
    if (i == story_light) story_terms = vec4(0.0, lights[light_rows * i].w, 0.0, 1.0);
#endif
    return;
  }
  vec3 vector = lights[light_rows * i + 1].xyz;
  vec3 to_light = kind == POINT_LIGHT ? vector - position : vector;
  float intensity = arriving(i, to_light);
#if STORY
  if (i == story_light) {
    story_to_light = vec4(to_light, dot(normal, to_light) / (length_of(normal) * length_of(to_light)));
    story_terms = vec4(0.0, 0.0, 0.0, 1.0);
  }
#endif
#if SHADOW_MAPS && SHADING == PHONG
  float visible = visible_share(i, position, normal, z);
#if STORY
  if (i == story_light) story_terms.w = visible;
#endif
  if (!(visible > 0.0)) return;
  intensity *= visible;
#endif
  float n_dot_l = dot(normal, to_light);
  float cosine = n_dot_l / (length_of(normal) * length_of(to_light));
#if DIFFUSE
  if (n_dot_l > 0.0) {
    float diffuse = intensity * cosine;
#if RADIOMETRIC
    diffuse *= 1.0 / pi;
#endif
    sum.light += colour * diffuse;
#if STORY
    if (i == story_light) story_terms.y = diffuse;
#endif
  }
#endif
#if SPECULAR
#if TERM_COLOURS
  vec3 shine_colour = lights[light_rows * i + 3].xyz;
#else
  vec3 shine_colour = colour;
#endif
  float shine = tints.exponent < 0.0 ? 0.0 : highlight_cosine(normal, to_light, direction_to_eye(position));
#if STORY
  if (i == story_light) story_terms.x = shine;
#endif
  if (shine > 0.0) {
    float specular = intensity * power(shine, tints.exponent);
#if RADIOMETRIC
    specular *= cosine > 0.0 ? (tints.exponent + 8.0) / (8.0 * pi) * cosine : 0.0;
#endif
#if STORY
    if (i == story_light) story_terms.z = specular;
#endif
    if (tints.specular.w > 0.0)
      sum.extra += tints.specular.xyz * shine_colour * specular;
    else
      sum.light += shine_colour * specular;
  }
#endif
}
#endif

// `z` of the point before the camera only matters for shadow maps.
Lighting illuminate(vec3 position, vec3 normal, Tints tints, float z) {
  Lighting sum = Lighting(vec3(0.0), vec3(0.0));
#if ONE_LIGHT
  if (light_number >= 0) add_light(light_number, position, normal, tints, z, sum);
#elif LIGHTS > 0
  for (int i = 0; i < LIGHTS; ++i) add_light(i, position, normal, tints, z, sum);
#endif
#if LIGHTS > 0 && TERM_COLOURS
#if ONE_LIGHT
  if (light_number >= 0) return sum;
#endif
  for (int i = 0; i < LIGHTS; ++i) add_ambient_of(i, position, tints, sum);
#endif
  return sum;
}
