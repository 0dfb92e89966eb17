#include <algorithm>
#include <array>
#include <glm/gtc/type_ptr.hpp>

#include "bench/llvmpipe/gl_scene.h"

namespace ps::bench {

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

}  // namespace ps::bench
