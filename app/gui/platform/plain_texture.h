#pragma once
#include <imgui.h>

#include "gui/platform/texture.h"

namespace ps::gui {

/// Adds a texture to the list as ImDrawList::AddImage does, but drawn as it is: without a tint and without blending.
/// Mesa's software driver copies such rectangles several times as fast as it shades them.
void add_plain_texture(ImDrawList& list, const Texture& texture, ImVec2 min, ImVec2 max);

}  // namespace ps::gui
