#pragma once
#include "gui/base/file_question.h"
#include "gui/panels/messages.h"
#include "gui/panels/pictures/pictures_panel.h"
#include "gui/session/session.h"

namespace ps::gui {

// What the window asks files for. The session, and the pictures, must outlive the answer.

FileQuestion scene_question(Session& session);    ///< a scene to open
FileQuestion compare_question(Session& session);  ///< a picture in B's place
FileQuestion picture_question(Session& session, const PicturesState& pictures);
FileQuestion save_scene_question(Session& session);
FileQuestion save_screen_question(Session& session);
FileQuestion save_bundle_question(Session& session);
FileQuestion save_story_question(Session& session);
FileQuestion save_drawing_question(Session& session, const SaveDrawing& drawing);

}  // namespace ps::gui
