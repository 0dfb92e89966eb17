#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "frame/view.h"
#include "study/control.h"
#include "study/model/held_pictures.h"
#include "study/needs.h"

namespace ps {

/// A part of a scene or of its settings that is weighed.
enum class ModelPart {
  objects,        ///< that no ray ends on and no fragment shows
  shapes,         ///< models of which a box or a rectangle shows the same
  triangles,      ///< of models, that no ray ends on and no fragment shows
  small_objects,  ///< that show in so few pixels that their loss stays within the tolerance
  textures,       ///< levels finer than any pixel reads
  detail,         ///< divisions of curved models
  lights,         ///< whose loss stays within the tolerance
  reflection_depth,
  samples,
  precision,
  tessellation,
  accelerator,
  depth_buffer,
};

/// One thing that goes, or becomes smaller.
struct ModelThing {
  std::string name;                 ///< "object 'floor'", "light 3"
  std::optional<double> picture{};  ///< share of the pixels that it shows in
  std::uint64_t bytes = 0;          ///< that are saved
  std::optional<double> work{};     ///< share of the work that is saved
  double increase = 0;              ///< of its loss alone, where that was tried
};

/// The saving of one part.
struct ModelSaving {
  ModelPart part{};
  std::string goes;    ///< within a sentence: "three of twelve lights"
  std::string kept{};  ///< what does in its place: "64 x 64 texels"; may be empty
  std::vector<ModelThing> things{};
  double work = 0;         ///< share of the full model's work; below 0 where it grows
  double bytes = 0;        ///< share of the full model's bytes
  model::Change change{};  ///< of all pictures, with everything that went before
  Scene scene{};           ///< after it
  Settings settings{};
};

/// Something that the scene would do with, and that is not in the reduced scene, as a sentence.
using ModelRemark = std::string;

struct ModelNeeds {
  double tolerance = 0;
  std::size_t views = 0;
  std::vector<ModelSaving> savings;  ///< in the order in which they were made, each on top of those before
  std::vector<ModelRemark> remarks;
  std::size_t objects = 0, lights = 0;  ///< of the full scene
  Scene scene;                          ///< reduced
  Settings settings;
  std::uint64_t work = 0, default_work = 0;  ///< counted_work() of pictures of a quarter of the sides
  std::uint64_t bytes = 0, default_bytes = 0;
  model::Change change;
  int pictures = 0;  ///< that were rendered
};

struct ModelRequest {
  Scene scene;
  std::vector<View> views;  ///< for all of which the reduced scene must hold
  Settings base;
  double tolerance = NeedsRequest{}.tolerance;
  WorkerPriority priority = WorkerPriority::normal;
};

/// Finds the parts of the model that no picture would miss, and calls `update` before each part with how many have been
/// weighed. First go those that no kernel reports; then those that
/// may change a picture by no more than the tolerance in its worst tile, as long as it saves least_saving. Every
/// step is drawn afresh, by rays and by fragments from every view, before it is taken; where several go at once and
/// that is too much, halves of them are tried. Throws Cancelled.
ModelNeeds find_model_needs(const ModelRequest& request, StudyControl& control,
                            const std::function<void(const StudyStatus&)>& update = {});

/// Draws a reduced scene afresh and compares it with the full one.
model::Change check_reduction(const ModelRequest& request, const Scene& reduced, const Settings& settings,
                              StudyControl& control);

}  // namespace ps
