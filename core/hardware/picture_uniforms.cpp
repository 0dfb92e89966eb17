#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <glm/matrix.hpp>

#include "hardware/definitions.h"
#include "hardware/picture_drawer.h"
#include "hardware/picture_units.h"
#include "math/unit.h"
#include "raster/setup/textures.h"

namespace ps::hardware {
namespace {

/// The matrix of cofactors is the inverse transpose times the determinant: triangles' own normals.
Mat3d surface_matrix(const raster::DrawObject& object) {
  const Mat3d& m = object.linear;
  return Mat3d(cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1])) * (object.mirrored ? -1.0 : 1.0);
}

/// A matrix for directions, whose length does not matter, with entries within float's range.
Mat3d for_directions(const Mat3d& matrix) {
  const double largest =
      std::max({largest_component(matrix[0]), largest_component(matrix[1]), largest_component(matrix[2])});
  return largest > 0 ? matrix * std::ldexp(1, -std::ilogb(largest)) : matrix;
}

/// The factor that keeps a depth within 0..1: a power of two, which changes no comparison.
float depth_factor(const PicturePlan& plan) {
  if (plan.depth.value == DepthValue::inverse_z)
    return static_cast<float>(std::exp2(std::floor(std::log2(plan.depth.near))));
  const Vec2d reach(plan.viewport.columns / plan.projection.scale.x, plan.viewport.rows / plan.projection.scale.y);
  const double longest = plan.perspective() ? plan.farthest * std::sqrt(1 + dot(reach, reach)) : plan.farthest;
  return static_cast<float>(std::exp2(-std::floor(std::log2(longest)) - 1));
}

}  // namespace

std::unique_ptr<Program> make_program(const KeptProgram& kept, ShaderFiles& files, Api api) {
  auto program =
      std::make_unique<Program>(files, kept.vertex_file, kept.fragment_file, api, kept.definitions, kept.captured);
  program->bind_block("Lights", lights_binding);
  program->bind_block("ShadowMaps", maps_binding);
  return program;
}

Program& PictureDrawer::program_of(const raster::Surface<float>& surface) {
  const std::string key = hardware::definitions(plan_, surface, shop_.driver().clip_control);
  return program_of("vertex.glsl", "fragment.glsl", key);
}

Program& PictureDrawer::program_of(const char* vertex_file, const char* fragment_file, const std::string& definitions,
                                   std::span<const char* const> captured) {
  KeptProgram& kept = shop_.programs[fragment_file + definitions];
  if (!kept.program) {
    KeptProgram made{vertex_file, fragment_file, definitions, captured, nullptr, 0};
    made.program = make_program(made, shop_.shaders, shop_.context.api());
    kept = std::move(made);
  }
  kept.used = ++shop_.clock;
  return *kept.program;
}

void PictureDrawer::set_object(Program& program, std::size_t object) {
  const raster::DrawObject& draw = plan_.objects[object];
  const MeshBuffers& buffers = shop_.meshes.get(draw.mesh);
  const Vec3d centre = draw.world(buffers.centre());
  const Mat3d linear = draw.linear * (1 / buffers.scale());
  program.set("to_world", linear);
  program.set("world_shift", Vec3f(centre));
  const Mat3d& from_world = plan_.camera_space.from_world;
  program.set("from_world", from_world);
  program.set("to_camera", plan_.settings.camera_relative ? from_world * linear : from_world);
  program.set("camera_shift", Vec3f(plan_.camera_space.point(centre)));
  program.set("normal_matrix", for_directions(draw.normal_matrix));
  program.set("surface_matrix", for_directions(surface_matrix(draw)));
  program.set("object_number", draw.object);
  program.set("numbered", draw.sphere ? 0 : 1);
}

void PictureDrawer::set_view(Program& program) {
  const Vec2d size(plan_.viewport.columns, plan_.viewport.rows), scale = plan_.projection.scale;
  const Vec2d centre = shifted_centre(plan_);
  program.set("canvas_scale", Vec2f(Vec2d(2 * scale.x / size.x, -2 * scale.y / size.y)));
  program.set("canvas_shift", Vec2f(Vec2d(2 * centre.x / size.x - 1, 2 * centre.y / size.y - 1)));
  program.set("canvas_size", Vec2f(size));
  program.set("eye", Vec3f(plan_.camera.position));
  program.set("backward", Vec3f(-plan_.camera.forward));
  program.set("camera_right", Vec3f(plan_.camera.right));
  program.set("camera_up", Vec3f(plan_.camera.up));
  program.set("camera_forward", Vec3f(plan_.camera.forward));
  program.set("view_scale", Vec2f(Vec2d(scale.x, -scale.y)));
  program.set("view_centre", Vec2f(centre));
  program.set("plane_scale", Vec2f(Vec2d(scale.x, -scale.y)));
  program.set("plane_centre", Vec2f(centre));
  program.set("mip_bias", static_cast<float>(plan_.settings.mip_bias));
}

void PictureDrawer::set_depth(Program& program) {
  const raster::DepthCode& depth = plan_.depth;
  program.set("near_z", static_cast<float>(depth.near));
  program.set("far_share", static_cast<float>(depth.far > 0 ? depth.near / depth.far : 0));
  program.set("far_z", static_cast<float>(plan_.farthest));
  program.set("far_limit", static_cast<float>(depth.far));
  program.set("depth_near", static_cast<float>(depth.near));
  program.set("depth_far", static_cast<float>(depth.far));
  program.set("depth_factor", depth_factor(plan_));
  program.set("depth_steps", static_cast<float>(std::exp2(depth.bits)));
}

void PictureDrawer::set_surface(Program& program, const raster::Surface<float>& surface) {
  const ShadingMaterial<float>& material = surface.material;
  const Vec3f none(0);
  program.set("surface_colour", material.colour);
  program.set("exponent", material.specular.value_or(1.0f));
  program.set("specular_colour", Vec4f(material.specular_colour.value_or(none), material.specular_colour ? 1 : 0));
  program.set("ambient_colour", Vec4f(material.ambient_colour.value_or(none), material.ambient_colour ? 1 : 0));
  program.set("relief_depth", material.relief_depth);
  if (plan_.shadow_maps) {
    set_shadow_maps(program);
    program.set("surface_error_scale", surface_error(surface));
  }
  if (mirrors(plan_, surface)) {
    set_environment(program);
    program.set("environment_layer", shop_.environment.first_layer(surface.object));
  }
  program.set("reflective", material.reflective);
  if (surface.placing) {
    program.set("placing", Mat3d(surface.placing->to_world));
    program.set("placing_normals", Mat3d(surface.placing->normals));
  }
  if (!plan_.textures) return;
  int unit = 0;
  for (const auto& [name, texture] : {std::pair{"surface", material.texture},
                                      {"opacity", material.opacity_map},
                                      {"specular", material.specular_map},
                                      {"ambient", material.ambient_map},
                                      {"normal", material.normal_map},
                                      {"height", material.height_map},
                                      {"reflection", material.reflection_map}}) {
    if (texture < 0) continue;
    const MipChain& chain = (*plan_.textures)[static_cast<std::size_t>(texture)];
    const Vec4<int> layout = shop_.textures.bind(chain, unit, plan_.settings, shop_.driver().max_size);
    program.set(fmt::format("{}_layout", name), layout);
    program.set(fmt::format("{}_picture", name), unit);
    program.set(fmt::format("{}_wrap", name), static_cast<int>(raster::wrap_of(chain, plan_.settings)));
    ++unit;
  }
}

/// How far the triangles of a round surface lie within it, per unit of z.
float PictureDrawer::surface_error(const raster::Surface<float>& surface) const {
  const Vec2d& scale = plan_.projection.scale;
  return surface.sphere ? static_cast<float>(plan_.settings.tessellation / std::min(scale.x, scale.y)) : 0.0f;
}

void PictureDrawer::set_shadow_maps(Program& program) {
  const Settings& s = plan_.settings;
  shop_.maps.bind(plan_.shadow_maps, maps_unit, maps_binding);
  program.set("shadow_depths", maps_unit);
  program.set("shadow_map_size", s.shadow_map_size);
  program.set("shadow_bias", static_cast<float>(s.shadow_bias));
  program.set("shadow_slope_bias", static_cast<float>(s.shadow_slope_bias));
}

void PictureDrawer::set_environment(Program& program) {
  shop_.environment.bind(plan_.environment, environment_unit);
  program.set("environment_faces", environment_unit);
  program.set("environment_size", plan_.settings.environment_size);
}

void PictureDrawer::set_geometry(Program& program) {
  shop_.geometry->bind_textures(geometry_unit);
  int unit = geometry_unit;
  for (const char* name :
       {"geometry_surface", "geometry_normal", "geometry_position", "geometry_tint_0", "geometry_tint_1"})
    program.set(name, unit++);
  program.set("surface_table", surface_table_unit);
  if (plan_.shadow_maps) set_shadow_maps(program);
  if (plan_.environment) set_environment(program);
}

}  // namespace ps::hardware
