#pragma once
#include "gui/panels/pictures/picture_transform.h"
#include "gui/platform/texture.h"
#include "inspect/space_drawing.h"

namespace ps::gui {

/// Draws a texture on the image plane of the model, if that is shown, into `area`.
void draw_on_image_plane(ImDrawList& list, const Area& area, const SpaceModel& model, const SpaceProjection& projection,
                         const SpaceLook& look, const Texture& texture);

/// The event of the line or point nearest to a place of `area`, -1 if none is near.
int event_under(ImVec2 pointer, const Area& area, const SpaceModel& model, const SpaceProjection& projection,
                const SpaceLook& look);

}  // namespace ps::gui
