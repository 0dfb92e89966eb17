#pragma once
#include "gui/base/values.h"
#include "gui/panels/pictures/pictures_panel.h"

namespace ps::gui {

/// What scripts may ask of the pictures as they are on the screen. Both must outlive the offers.
void offer_picture_values(Values& out, Session& session, PicturesState& pictures);

}  // namespace ps::gui
