#include "bench/llvmpipe/gl_scene.h"

#include <cmath>
#include <vector>

namespace ps::bench {
namespace {

/// Passes world positions, normals and texture coordinates on.
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

/// Lit by the book's equation, textured, or of one colour.
const char* fragment_source(const Settings& settings, bool textured) {
  if (settings.lighting) return lit_text;
  return textured ? textured_text : plain_text;
}

GLenum minifying(TextureFilter filter) {
  switch (filter) {
  case TextureFilter::nearest:
    return GL_NEAREST;
  case TextureFilter::bilinear:
    return GL_LINEAR;
  case TextureFilter::mipmap:
    return GL_LINEAR_MIPMAP_NEAREST;
  case TextureFilter::trilinear:
    return GL_LINEAR_MIPMAP_LINEAR;
  }
  return GL_NEAREST;
}

}  // namespace

GlScene::GlScene(const Scene& scene, const View& view, const Settings& settings)
    : target_(view.width, view.height), settings_(settings), background_(scene.background) {
  const bool textured = settings.textures && scene.materials->front().texture >= 0;
  program_ = make_program(vertex_text, fragment_source(settings, textured));
  glUseProgram(program_);
  const Mesh& mesh = *scene.geometry->meshes.front();
  upload_mesh(mesh);
  if (textured) upload_texture(scene.textures->front());
  set_uniforms(scene, view, mesh);
  check_gl("setting up the scene");
}

GlScene::~GlScene() {
  glDeleteProgram(program_);
  glDeleteVertexArrays(1, &vertex_array_);
  glDeleteBuffers(1, &vertices_);
  glDeleteBuffers(1, &indices_);
  glDeleteTextures(1, &texture_);
}

void GlScene::upload_texture(const Texture& texture) {
  const Image<Vec3f>& texels = *texture.texels;
  std::vector<std::uint8_t> bytes;
  for (const Vec3f& texel : texels.pixels()) {
    for (int channel = 0; channel < 3; ++channel)
      bytes.push_back(static_cast<std::uint8_t>(std::lround(texel[channel] * 255.0f)));
    bytes.push_back(255);
  }
  glGenTextures(1, &texture_);
  glBindTexture(GL_TEXTURE_2D, texture_);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, texels.width(), texels.height(), 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
  glGenerateMipmap(GL_TEXTURE_2D);
  const bool nearest = settings_.texture_filter == TextureFilter::nearest;
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, static_cast<GLint>(minifying(settings_.texture_filter)));
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, nearest ? GL_NEAREST : GL_LINEAR);
}

void GlScene::draw() const {
  target_.bind();
  glUseProgram(program_);
  glBindVertexArray(vertex_array_);
  glBindTexture(GL_TEXTURE_2D, texture_);
  glEnable(GL_DEPTH_TEST);
  if (settings_.backface_culling)
    glEnable(GL_CULL_FACE);
  else
    glDisable(GL_CULL_FACE);
  glClearColor(background_.x, background_.y, background_.z, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glDrawElements(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr);
  glFinish();
}

}  // namespace ps::bench
