#pragma once
#include "gui/base/values.h"
#include "gui/panels/pictures/pictures_panel.h"

namespace ps::gui {

/// Values of the pictures on the screen for scripts. Both must outlive the offers.
void offer_picture_values(Values& out, Session& session, PicturesState& pictures);

}  // namespace ps::gui
