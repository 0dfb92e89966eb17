#include <algorithm>
#include <limits>

#include "hardware/story_drawer.h"
#include "shade/illumination.h"

namespace ps::hardware {
namespace {

constexpr int most_lights = 64;  ///< whose terms are asked for, each in draws of its own

LightEvent light_event(const PicturePlan& plan, int light, const Vec4f& to_light, const Vec4f& terms) {
  LightEvent event;
  event.light = light;
  event.kind = plan.lights[static_cast<std::size_t>(light)].kind;
  event.to_light = vector_of(to_light);
  event.n_dot_l = static_cast<double>(to_light.w);
  event.r_dot_v = static_cast<double>(terms.x);
  event.diffuse = static_cast<double>(terms.y);
  event.specular = static_cast<double>(terms.z);
  event.visible = static_cast<double>(terms.w);
  const ShadingLight<float>& source = plan.lights[static_cast<std::size_t>(light)];
  if (source.adds_ambient)
    event.ambient = static_cast<double>(arriving(source, Vec3f(event.to_light), illumination_options(plan.settings)));
  event.below_horizon = event.kind != LightKind::ambient && !(to_light.w > 0);
  return event;
}

}  // namespace

int StoryDrawer::first_light_of(const DrawPass& pass) const {
  return lights_separately(plan_) ? std::max(pass.light, 0) : 0;
}

int StoryDrawer::end_light_of(const DrawPass& pass) const {
  if (lights_separately(plan_)) return pass.light + 1;
  return std::min(static_cast<int>(plan_.lights.size()), most_lights);
}

CapturedTriangle StoryDrawer::capture(const NearTriangle& triangle, const DrawPass& pass, int light) {
  Program& program = story_program(triangle.run.surface);
  prepare_run(program, triangle.run, pass);
  bind_streams(triangle.run.object);
  program.set("story_light", light);
  return capture_corners([&] { draw_triangles(triangle.run); });
}

void StoryDrawer::report_lights(const FragmentEvent& fragment, NearTriangle& triangle, const Asked& asked,
                                const DrawPass& pass, const Outcome& outcome) {
  if (plan_.settings.shading != Shading::phong) return report_vertex_lights(fragment, triangle, pass);
  for (int light = first_light_of(pass); light < end_light_of(pass); ++light) {
    asked.program.use();
    asked.program.set("story_light", light);
    const Vec4f to_light = page(asked, Page::to_light);
    const Vec4f terms = page(asked, Page::terms);
    recorder_.event([&] {
      LightEvent event = light_event(plan_, light, to_light, terms);
      if (outcome.written == 0) event.diffuse = event.specular = event.visible = 0;
      return event;
    });
  }
}

// Where light is computed for the vertices or once for the triangle, that is what happened to it.
void StoryDrawer::report_vertex_lights(const FragmentEvent& fragment, NearTriangle& triangle, const DrawPass& pass) {
  const bool flat = plan_.settings.shading == Shading::flat;
  std::vector<CapturedTriangle> by_light;
  for (int light = first_light_of(pass); light < end_light_of(pass); ++light)
    by_light.push_back(capture(triangle, pass, light));
  const CapturedTriangle corners = by_light.empty() ? capture(triangle, pass, -1) : by_light.front();
  for (std::size_t k = 0; k < (flat ? 1 : 3); ++k) {
    recorder_.begin([&] {
      VertexLightEvent event;
      event.id = triangle.id;
      if (!flat) event.vertex = static_cast<int>(k);
      if (!flat) event.weight = fragment.weights[k];
      event.position = Vec3d(corners[k].point);
      event.normal = Vec3d(corners[k].normal);
      event.light = Vec3d(corners[k].light);
      event.extra = Vec3d(corners[k].extra);
      return event;
    });
    int light = first_light_of(pass);
    for (const CapturedTriangle& one : by_light)
      recorder_.event([&] { return light_event(plan_, light++, one[k].to_light, one[k].terms); });
    recorder_.end();
  }
}

}  // namespace ps::hardware
