#pragma once
#include <optional>
#include <string>

#include "inspect/space_orbit.h"
#include "inspect/vertex_chain.h"

namespace ps {

/// The scene from outside: the place of the viewer, and the parts of the story that are drawn.
struct OutsideView {
  SpacePreset preset = SpacePreset::outside;
  std::optional<SpaceOrbit> orbit;  ///< instead of the preset; turned by hand
  bool through_camera = false;      ///< instead of both
  std::string switched;             ///< keys of the groups that are not as at first, separated by commas
  double least_contribution = 0;    ///< rays that bring a smaller share of the pixel's colour are left out
  double deepest_level = 3;         ///< of the accelerator's boxes
  bool operator==(const OutsideView&) const = default;
};

/// The state of the views of a pixel's story beside the selected event. Belongs to the picked pixel and its side.
struct StoryView {
  OutsideView outside;
  bool until_event = false;        ///< the story is gone through: no event after the selected one is drawn
  int listing_instance = -1;       ///< the run of a loop that was chosen in the listing; -1 = none was
  std::optional<Vec2d> sample;     ///< the microscope's point, in pixels from the pixel's top left corner
  int micro_triangle = -1;         ///< whose numbers the microscope shows; -1 = the one in front
  std::optional<VertexId> vertex;  ///< that is kept; empty = the one next to the picked pixel
  VertexEdits vertex_edits;        ///< steps of its way that are tried out
  bool operator==(const StoryView&) const = default;
};

/// The parts that stay when another pixel is picked: all but the run of the loop, the sample, the triangle, and how far
/// the story was gone through.
StoryView for_another_pixel(StoryView before);

/// The parts that stay when another document takes the place of the one that it belongs to: in the same scene all of
/// the view from outside and the kept vertex, else only what is drawn and what not.
StoryView carried_over(const StoryView& before, bool same_scene);

}  // namespace ps
