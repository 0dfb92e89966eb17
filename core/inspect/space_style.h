#pragma once
#include <array>

#include "base/enumerators.h"
#include "image/painter.h"
#include "inspect/space_model.h"

namespace ps {

/// Kinds that are shown and hidden together in the space view.
enum class SpaceGroup {
  camera,
  grid,
  rays,
  shadows,
  normals,
  surfaces,
  lights,
  rejected,
  nodes,
  near_plane,
  shadow_methods
};
inline constexpr std::size_t space_group_count = enumerator_count<SpaceGroup>();
SpaceGroup group_of(SpaceKind kind);

/// Which groups are shown, by SpaceGroup.
using SpaceGroups = std::array<bool, space_group_count>;
/// Those that are shown at first: without rejected triangles, the accelerator's boxes and clipping planes.
SpaceGroups first_space_groups();

/// The parts of a model that are drawn, and their style.
struct SpaceLook {
  SpaceGroups groups = first_space_groups();
  double least_contribution = 0;  ///< rays below are left out with what belongs to them
  int deepest_level = 3;          ///< of the boxes
  int up_to_event = -1;           ///< events after it have not happened yet; -1 = all have
  int highlighted = -1;           ///< event
};
bool is_shown(const SpaceItem& item, const SpaceLook& look);

/// The line of a kind. Colours are of the Okabe-Ito palette and never the only sign.
Stroke stroke_of(const SpaceItem& item);

}  // namespace ps
