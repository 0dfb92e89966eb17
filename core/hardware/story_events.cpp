#include <bit>

#include "hardware/story_drawer.h"
#include "raster/setup/textures.h"

namespace ps::hardware {
namespace {

/// Pixels from the top left; what lies behind the camera is where division by its w puts it.
Vec2d on_canvas(const PicturePlan& plan, const Vec4f& clip) {
  const Vec4d at(clip);
  return {(at.x / at.w + 1) / 2 * plan.viewport.columns, (at.y / at.w + 1) / 2 * plan.viewport.rows};
}

FragmentEvent::Pass name_of(const DrawPass& pass) {
  switch (pass.kind) {
  case DrawPass::Kind::whole:
    return FragmentEvent::Pass::only;
  case DrawPass::Kind::depth:
  case DrawPass::Kind::geometry:
    return FragmentEvent::Pass::depth_first;
  case DrawPass::Kind::shade:
  case DrawPass::Kind::light:
    return FragmentEvent::Pass::shading;
  }
  return FragmentEvent::Pass::only;
}

}  // namespace

const CapturedTriangle& StoryDrawer::corners_of(NearTriangle& triangle, const DrawPass& pass) {
  if (!triangle.corners) triangle.corners = capture(triangle, pass, -1);
  return *triangle.corners;
}

FragmentEvent StoryDrawer::fragment_event(NearTriangle& triangle, const Asked& asked, const DrawPass& pass,
                                          const Outcome& outcome) {
  FragmentEvent event;
  event.id = triangle.id;
  event.sphere_triangle = triangle.sphere_triangle;
  event.back_face = !triangle.front;
  const Vec4f weights = page(asked, Page::weights);
  const Vec4f screen = page(asked, Page::screen);
  const CapturedTriangle& corners = corners_of(triangle, pass);
  for (std::size_t k = 0; k < 3; ++k) {
    const int axis = static_cast<int>(k);
    event.weights[k] = static_cast<double>(weights[axis]);
    event.weights_2d[k] = static_cast<double>(screen[axis]);
    event.corners[k] = on_canvas(plan_, corners[k].clip);
    event.corner_depth[k] = static_cast<double>(corners[k].camera_z.x);
  }
  event.z = static_cast<double>(weights.w);
  event.inverse_z = 1 / event.z;
  event.depth = outcome.depth;
  event.pass = name_of(pass);
  event.samples = samples();
  event.samples_covered = std::popcount(triangle.covered);
  if (outcome.depth == FragmentEvent::Depth::off) return event;
  if (samples() > 1) {
    if (outcome.samples.own.empty()) return event;
    const auto first = static_cast<std::size_t>(std::countr_zero(outcome.sample));
    event.depth_stored = static_cast<double>(outcome.samples.stored[first]);
    event.depth_new = static_cast<double>(outcome.samples.own[first]);
    return event;
  }
  if (outcome.stored) event.depth_stored = *outcome.stored;
  event.depth_new = outcome.stored_after ? *outcome.stored_after : static_cast<double>(screen.w);
  return event;
}

// What the surface itself brings: relief, texture, normal map.
void StoryDrawer::report_surface(const NearTriangle& triangle, const Asked& asked) {
  const raster::Surface<float>& surface = plan_.surfaces.list[triangle.run.surface];
  const Settings& s = plan_.settings;
  const auto ask = [&](Page what) { return page(asked, what); };
  if (!fills(s.draw) || surface.layout.uv == raster::AttributeLayout::absent) return;
  const Vec4d uv(ask(Page::uv));
  if (surface.layout.relief)
    if (const Vec4d relief(ask(Page::relief)); relief.w > 0)
      recorder_.event([&] {
        ParallaxEvent event;
        event.texture = surface.material.height_map;
        event.from = {uv.x, uv.y};
        event.to = {uv.z, uv.w};
        event.shift = {relief.x, relief.y};
        event.depth = relief.z;
        return event;
      });
  if (s.textures && surface.material.texture >= 0) {
    const Vec4f texel = ask(Page::texel);
    recorder_.event([&] {
      TextureEvent event;
      event.texture = surface.material.texture;
      event.uv = {uv.z, uv.w};
      event.level = raster::reads_mip_levels(s.texture_filter) ? static_cast<double>(texel.w) : 0;
      event.result = vector_of(texel);
      return event;
    });
  }
  if (!surface.layout.mapped_normal) return;
  const Vec4f stored = ask(Page::stored);
  if (!(stored.w > 0)) return;
  recorder_.event([&] {
    return NormalMapEvent{surface.material.normal_map,
                          {uv.z, uv.w},
                          vector_of(stored),
                          vector_of(ask(Page::tangent)),
                          vector_of(ask(Page::bitangent)),
                          vector_of(ask(Page::unmapped)),
                          vector_of(ask(Page::normal))};
  });
}

bool StoryDrawer::shows_surroundings(const NearTriangle& triangle) const {
  const raster::Surface<float>& surface = plan_.surfaces.list[triangle.run.surface];
  return mirrors(plan_, surface) || reflects_picture(plan_, surface);
}

void StoryDrawer::report_mirror(const NearTriangle& triangle, const Asked& asked) {
  const raster::Surface<float>& surface = plan_.surfaces.list[triangle.run.surface];
  if (!shows_surroundings(triangle)) return;
  const auto ask = [&](Page what) { return page(asked, what); };
  const Vec4f place = ask(Page::mirror_place);
  if (!(place.z > 0)) return;
  const Vec4f mirrored = ask(Page::mirrored);
  const Vec2d at(static_cast<double>(place.x), static_cast<double>(place.y));
  if (reflects_picture(plan_, surface)) {
    recorder_.event([&] {
      return TextureEvent{surface.material.reflection_map, at, 0, {}, vector_of(mirrored), TextureUse::reflection};
    });
  } else {
    const auto& map = (*plan_.environment)[static_cast<std::size_t>(surface.object)];
    if (!map) return;
    recorder_.event([&] {
      return EnvironmentEvent{
          map->centre,  vector_of(ask(Page::mirror_direction)), static_cast<int>(mirrored.w), at, vector_of(mirrored),
          map->left_out};
    });
  }
  recorder_.event([&] {
    return ReflectionEvent{static_cast<double>(place.z), vector_of(ask(Page::unmirrored)), vector_of(mirrored),
                           vector_of(ask(Page::shaded))};
  });
}

void StoryDrawer::report_write(const FragmentEvent& fragment, NearTriangle& triangle, const Asked& asked,
                               const DrawPass& pass, const Outcome& outcome) {
  const auto report_samples = [&] {
    if (samples() > 1) recorder_.event([&] { return samples_event(triangle, asked.covered, outcome); });
  };
  if (outcome.depth == FragmentEvent::Depth::failed) return report_samples();
  const bool whole_picture = plan_.defers;
  if (outcome.written == 0) {
    // The stencil buffer kept it away: in a shadow volume, or else because an equal depth was shaded before.
    if (plan_.counts_volumes) report_lights(fragment, triangle, asked, pass, outcome);
    return report_samples();
  }
  if (!whole_picture) report_surface(triangle, asked);
  const Vec4f shaded = page(asked, Page::shaded);
  if (plan_.settings.lighting && fills(plan_.settings.draw)) {
    report_lights(fragment, triangle, asked, pass, outcome);
    const auto ask = [&](Page what) { return page(asked, what); };
    const Vec4f unmirrored = shows_surroundings(triangle) ? ask(Page::unmirrored) : shaded;
    recorder_.event([&] {
      return ShadeEvent{vector_of(ask(Page::colour)), vector_of(ask(Page::light)), vector_of(ask(Page::extra)),
                        vector_of(unmirrored)};
    });
  }
  report_mirror(triangle, asked);
  report_samples();
  recorder_.event([&] { return WriteEvent{triangle.id, outcome.before, vector_of(shaded), outcome.after}; });
  if (pass.counted && samples() == 1) recorder_.count(Counter::pixels_written);
}

}  // namespace ps::hardware
