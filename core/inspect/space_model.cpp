#include "inspect/space_model.h"

#include <algorithm>

#include "inspect/space_parts.h"
#include "options/renderer_kind.h"

namespace ps {

SpaceModel build_space(const Scene& scene, const View& view, const Settings& settings, const PixelStory* story) {
  SpaceInputs inputs{scene, view, settings, story, SpaceImage(view, settings), {}};
  inputs.bounds = space_bounds(inputs);
  SpaceModel model;
  model.bounds = inputs.bounds;
  model.ground = ground_objects(inputs);
  add_camera(inputs, model);
  add_lights(inputs, model);
  add_shadow_methods(inputs, model);
  if (story) {
    switch (picture_way(story->renderer)) {
    case PictureWay::rays:
      add_rays(inputs, model);
      break;
    case PictureWay::fragments:
      add_fragments(inputs, model);
      break;
    case PictureWay::listing:  // the lines of the listing show its story
      break;
    }
  }
  for (const SpaceItem& item : model.items) {
    if (item.kind == SpaceKind::node) model.deepest_level = std::max(model.deepest_level, item.level);
    if (item.event >= 0 && item.kind != SpaceKind::node) model.steps.push_back(item.event);
  }
  std::sort(model.steps.begin(), model.steps.end());
  model.steps.erase(std::unique(model.steps.begin(), model.steps.end()), model.steps.end());
  return model;
}

int count_of(const SpaceModel& model, SpaceKind kind) {
  return static_cast<int>(
      std::count_if(model.items.begin(), model.items.end(), [&](const SpaceItem& item) { return item.kind == kind; }));
}

}  // namespace ps
