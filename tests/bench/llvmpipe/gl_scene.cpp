#include "bench/llvmpipe/gl_scene.h"

#include <cmath>
#include <glm/gtc/type_ptr.hpp>
#include <map>
#include <vector>

namespace ps::bench {
namespace {

const char* const vertex_source = R"(#version 330 core
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
const char* const lit_source = R"(#version 330 core
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

const char* const textured_source = R"(#version 330 core
in vec2 texture_position;
uniform vec3 surface_colour;
uniform sampler2D picture;
out vec4 colour;
void main() { colour = vec4(surface_colour * texture(picture, texture_position).rgb, 1.0); })";

const char* const plain_source = R"(#version 330 core
uniform vec3 surface_colour;
out vec4 colour;
void main() { colour = vec4(surface_colour, 1.0); })";

struct GlVertex {
  Vec3f position, normal;
  Vec2f uv;
};

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

const char* fragment_source(const Settings& settings, bool textured) {
  if (settings.lighting) return lit_source;
  return textured ? textured_source : plain_source;
}

}  // namespace

GlScene::GlScene(const Scene& scene, const View& view, const Settings& settings)
    : target_(view.width, view.height), settings_(settings), background_(scene.background) {
  const bool textured = settings.textures && scene.materials->front().texture >= 0;
  program_ = make_program(vertex_source, fragment_source(settings, textured));
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

void GlScene::upload_mesh(const Mesh& mesh) {
  // OpenGL has one index for position, normal and texture coordinate together.
  std::map<std::array<std::int64_t, 3>, std::uint32_t> known;
  std::vector<GlVertex> vertices;
  std::vector<std::uint32_t> indices;
  for (const MeshTriangle& triangle : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::array<std::int64_t, 3> key{triangle.position[k], triangle.normal[k], triangle.uv[k]};
      const auto [place, is_new] = known.try_emplace(key, static_cast<std::uint32_t>(vertices.size()));
      indices.push_back(place->second);
      if (!is_new) continue;
      GlVertex vertex{Vec3f(mesh.positions[triangle.position[k]]), {0, 0, 1}, {0, 0}};
      if (triangle.normal[k] >= 0) vertex.normal = Vec3f(mesh.normals[static_cast<std::size_t>(triangle.normal[k])]);
      if (triangle.uv[k] >= 0) vertex.uv = Vec2f(mesh.uvs[static_cast<std::size_t>(triangle.uv[k])]);
      vertices.push_back(vertex);
    }
  }
  index_count_ = static_cast<GLsizei>(indices.size());
  glGenVertexArrays(1, &vertex_array_);
  glBindVertexArray(vertex_array_);
  glGenBuffers(1, &vertices_);
  glBindBuffer(GL_ARRAY_BUFFER, vertices_);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(GlVertex)), vertices.data(),
               GL_STATIC_DRAW);
  glGenBuffers(1, &indices_);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size() * sizeof(std::uint32_t)), indices.data(),
               GL_STATIC_DRAW);
  const auto attribute = [](GLuint place, GLint size, std::size_t offset) {
    glEnableVertexAttribArray(place);
    glVertexAttribPointer(place, size, GL_FLOAT, GL_FALSE, sizeof(GlVertex), reinterpret_cast<const void*>(offset));
  };
  attribute(0, 3, offsetof(GlVertex, position));
  attribute(1, 3, offsetof(GlVertex, normal));
  attribute(2, 2, offsetof(GlVertex, uv));
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

void GlScene::set_uniforms(const Scene& scene, const View& view, const Mesh& mesh) const {
  const Camera& camera = view.camera;
  double z_near = 1e30, z_far = 0;
  for (const Vec3d& position : mesh.positions) {
    const double z = dot(position - camera.position, camera.forward);
    z_near = std::min(z_near, z);
    z_far = std::max(z_far, z);
  }
  z_near *= 0.9;
  z_far *= 1.1;
  // Rows of the matrix from the world to clip space, w = z along forward.
  const auto row = [&](const Vec3d& axis, double scale) {
    return Vec4d{axis * scale, -dot(axis, camera.position) * scale};
  };
  const Vec4d depth = row(camera.forward, 1);
  const std::array<Vec4d, 4> rows{
      row(camera.right, 2 * camera.projection_plane_d / camera.viewport_width),
      row(camera.up, 2 * camera.projection_plane_d / camera.viewport_height),
      depth * ((z_far + z_near) / (z_far - z_near)) - Vec4d{0, 0, 0, 2 * z_far * z_near / (z_far - z_near)}, depth};
  Mat4<float> matrix;
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 4; ++c) matrix[c][r] = static_cast<float>(rows[static_cast<std::size_t>(r)][c]);
  const auto place = [&](const char* name) { return glGetUniformLocation(program_, name); };
  const auto set = [&](const char* name, const Vec3d& value) {
    const Vec3f rounded(value);
    glUniform3fv(place(name), 1, glm::value_ptr(rounded));
  };
  glUniformMatrix4fv(place("to_clip"), 1, GL_FALSE, glm::value_ptr(matrix));
  set("eye", camera.position);
  const Material& material = scene.materials->front();
  set("surface_colour", material.colour);
  glUniform1f(place("exponent"), static_cast<float>(material.specular.value_or(1)));
  for (const Light& light : *scene.lights) {
    if (light.kind == LightKind::ambient) glUniform1f(place("ambient"), static_cast<float>(light.intensity));
    if (light.kind != LightKind::point) continue;
    glUniform1f(place("intensity"), static_cast<float>(light.intensity));
    set("light_position", light.position);
  }
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
