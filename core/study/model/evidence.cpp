#include "study/model/evidence.h"

#include <algorithm>
#include <cmath>

#include "study/study_frame.h"
#include "study/view_pixels.h"

namespace ps::model {
namespace {

bool is_curved(const Scene& scene, const Object& object) {
  const auto* instance = std::get_if<Instance>(&object.shape);
  return instance && !scene.geometry->meshes[instance->mesh]->patches.empty();
}

/// The fragments that a picture keeps.
void add_fragments(const Scene& scene, const Frame& frame, Evidence& evidence) {
  std::vector<std::uint64_t> seen(evidence.touched.objects.size());
  for (std::size_t i = 0; i < frame.ids.pixels().size(); ++i) {
    const PixelId id = frame.ids.pixels()[i];
    if (id.object < 0) continue;
    const double depth = static_cast<double>(frame.depth.pixels()[i]);
    evidence.nearest = std::min(evidence.nearest, depth);
    evidence.farthest = std::max(evidence.farthest, depth);
    const auto object = static_cast<std::size_t>(id.object);
    ++seen[object];
    if (is_curved(scene, scene.geometry->objects[object])) continue;  // drawn as triangles of its patches
    const auto triangle = static_cast<std::size_t>(id.triangle);
    std::vector<std::uint8_t>& triangles = evidence.touched.objects[object].triangles;
    if (triangle < triangles.size()) triangles[triangle] = 1;
    const int texture = material_of(scene, id.object, id.triangle).texture;
    const float level = frame.mip.pixels()[i];
    if (texture < 0 || level < 0) continue;
    std::optional<float>& finest = evidence.finest_level[static_cast<std::size_t>(texture)];
    finest = std::min(finest.value_or(level), level);
  }
  for (std::size_t i = 0; i < seen.size(); ++i) {
    Touched::Object& object = evidence.touched.objects[i];
    object.pixels = std::max(object.pixels, seen[i]);
    object.seen = std::max(object.seen, seen[i]);
  }
}

}  // namespace

Evidence gather_evidence(const Scene& scene, const std::vector<View>& views, const Settings& rays, Settings fragments,
                         StudyControl& control, WorkerPriority priority) {
  fragments.texture_filter = TextureFilter::trilinear;
  Evidence all;
  all.finest_level.resize(scene.textures->size());
  for (const View& view : views) {
    control.wait_here();
    Prepared prepared;
    Evidence one;
    one.touched = touched_by_rays(scene, view, rays, prepared, control.progress(), priority);
    one.finest_level = all.finest_level;
    constexpr Channel shown = Channel::ids | Channel::mip | Channel::depth;
    add_fragments(scene, study_frame(scene, view, fragments, control, priority, prepared, shown), one);
    if (&view == &views.front())
      all.touched = std::move(one.touched);
    else
      all.touched.add(one.touched);
    all.finest_level = std::move(one.finest_level);
    all.nearest = std::min(all.nearest, one.nearest);
    all.farthest = std::max(all.farthest, one.farthest);
    all.pixels += pixels_of(view);
  }
  return all;
}

}  // namespace ps::model
