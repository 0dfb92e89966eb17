#include "bench/llvmpipe/gl_shaders.h"

namespace ps::bench {
namespace {

const char* const vertex_text = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 uv;
uniform mat4 to_clip;
out vec3 world_position;
out vec3 world_normal;
out vec2 texture_position;
void main() {
  world_position = position;
  world_normal = normal;
  texture_position = uv;
  gl_Position = to_clip * vec4(position, 1.0);
})";

// The illumination equation of CGFS ch. 3, with one ambient and one point light.
const char* const lit_text = R"(#version 330 core
in vec3 world_position;
in vec3 world_normal;
uniform vec3 eye, light_position, surface_colour;
uniform float ambient, intensity, exponent;
out vec4 colour;
void main() {
  vec3 n = normalize(world_normal);
  vec3 l = light_position - world_position;
  vec3 v = eye - world_position;
  float light = ambient;
  float n_dot_l = dot(n, l);
  if (n_dot_l > 0.0) light += intensity * n_dot_l / length(l);
  vec3 r = 2.0 * n * n_dot_l - l;
  float r_dot_v = dot(r, v);
  if (r_dot_v > 0.0) light += intensity * pow(r_dot_v / (length(r) * length(v)), exponent);
  colour = vec4(surface_colour * light, 1.0);
})";

const char* const textured_text = R"(#version 330 core
in vec2 texture_position;
uniform vec3 surface_colour;
uniform sampler2D picture;
out vec4 colour;
void main() { colour = vec4(surface_colour * texture(picture, texture_position).rgb, 1.0); })";

const char* const plain_text = R"(#version 330 core
uniform vec3 surface_colour;
out vec4 colour;
void main() { colour = vec4(surface_colour, 1.0); })";

}  // namespace

const char* vertex_source() { return vertex_text; }

const char* fragment_source(const Settings& settings, bool textured) {
  if (settings.lighting) return lit_text;
  return textured ? textured_text : plain_text;
}

}  // namespace ps::bench
