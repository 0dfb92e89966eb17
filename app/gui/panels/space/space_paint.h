#pragma once
#include <array>
#include <optional>

#include "gui/panels/pictures/picture_transform.h"
#include "gui/panels/space/space_style.h"
#include "gui/platform/texture.h"
#include "inspect/space_projection.h"

namespace ps::gui {

/// The parts of a model that are drawn, and their style.
struct SpaceLook {
  std::array<bool, space_groups.size()> groups{};  ///< by SpaceGroup
  double least_contribution = 0;                   ///< rays below are left out with what belongs to them
  int deepest_level = 0;                           ///< of the boxes
  int up_to_event = -1;                            ///< events after it have not happened yet; -1 = all have
  int highlighted = -1;                            ///< event
  const Texture* picture = nullptr;                ///< to be stuck on the image plane; may be null
};

/// What was drawn.
struct SpaceDrawn {
  int items = 0, rays = 0, shadow_rays = 0, boxes = 0;
  int hovered = -1;                       ///< event of what is under the pointer
  std::optional<ImVec2> highlight_place;  ///< somewhere on what is highlighted
};

bool is_shown(const SpaceItem& item, const SpaceLook& look);

/// Draws the model over the picture that `projection` and `depth` belong to, into `area`. Parts behind surfaces are
/// thin and dashed. `pointer` picks what is hovered, unless it is outside.
SpaceDrawn draw_space(ImDrawList& list, const Area& area, const SpaceModel& model, const SpaceProjection& projection,
                      const Image<float>& depth, const SpaceLook& look, ImVec2 pointer);

}  // namespace ps::gui
