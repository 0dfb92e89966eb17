#pragma once
#include "base/parallel.h"
#include "frame/region.h"
#include "frame/view.h"
#include "options/settings.h"
#include "record/field_query.h"
#include "scene/scene.h"
#include "scene/working_space.h"

namespace ps {

/// The inputs of a renderer that finds one number of every pixel's story: scene, view and settings in the working space
/// whose numbers `space` turns into world ones.
struct FieldInputs {
  const Scene& scene;
  const View& view;
  const Settings& settings;
  const WorkingSpace& space;
  const FieldQuery& query;
  TileRect region;  ///< the pixels that are wanted
  ParallelOptions parallel;
};

}  // namespace ps
