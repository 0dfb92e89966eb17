#pragma once
#include <optional>
#include <vector>

#include "gui/panels/pictures/picture_transform.h"
#include "gui/session/handles.h"

namespace ps::gui {

/// With more things than this in a scene their handles would hide the picture; then there are none.
inline constexpr std::size_t most_handles = 60;

/// The handles that lie in the visible part of the picture.
std::vector<Handle> visible_handles(const Scene& scene, const View& view, const Settings& settings,
                                    const PictureTransform& transform, const Area& area);

/// The handle at a point of the window, if it is near enough to be taken.
const Handle* handle_at(const std::vector<Handle>& handles, ImVec2 point, const PictureTransform& transform,
                        const Area& area);

/// All handles as small marks, the one at `held` (a path) large and with its name.
void draw_handles(ImDrawList& list, const std::vector<Handle>& handles, const std::string& held,
                  const PictureTransform& transform, const Area& area);

/// Makes the handles known to scripts as PREFIX/handle/PATH.
void record_handles(const std::string& prefix, const std::vector<Handle>& handles, const PictureTransform& transform,
                    const Area& area);

}  // namespace ps::gui
