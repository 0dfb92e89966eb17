// The illumination equation of CGFS ch. 3 and 4, in the order of core/shade/illumination.h, under LIGHTS lights.
#include "power.glsl"
#include "tints.glsl"
#include "unit.glsl"
#if SHADOW_MAPS && SHADING == PHONG
#include "shadows.glsl"
#endif

#if LIGHTS > 0
// Of each light: colour and intensity; position or direction, and kind; attenuation, and whether it attenuates.
layout(std140) uniform Lights {
  vec4 lights[3 * LIGHTS];
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
  float intensity = lights[3 * i].w;
  if (int(lights[3 * i + 1].w) != POINT_LIGHT) return intensity;
  float square = dot(to_light, to_light);
  bool exact = factor_for_square(square) == 1.0;
  float distance = exact ? sqrt(square) : max(length_of(to_light), least);
#if RADIOMETRIC
  if (!exact) return spread(intensity / (4.0 * pi) / distance, distance);
  return spread(intensity, 4.0 * pi * square);
#elif ATTENUATION
  vec4 attenuation = lights[3 * i + 2];
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

void add_light(int i, vec3 position, vec3 normal, Tints tints, float z, inout Lighting sum) {
  vec3 colour = lights[3 * i].xyz;
  int kind = int(lights[3 * i + 1].w);
  if (kind == AMBIENT_LIGHT) {
    if (tints.ambient.w > 0.0)
      sum.extra += tints.ambient.xyz * colour * lights[3 * i].w;
    else
      sum.light += colour * lights[3 * i].w;
#if STORY
    if (i == story_light) story_terms = vec4(0.0, lights[3 * i].w, 0.0, 1.0);
#endif
    return;
  }
  vec3 vector = lights[3 * i + 1].xyz;
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
#if SPECULAR
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
      sum.extra += tints.specular.xyz * colour * specular;
    else
      sum.light += colour * specular;
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
  return sum;
}
