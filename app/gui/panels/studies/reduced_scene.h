#pragma once
#include <filesystem>
#include <memory>

#include "gui/session/session.h"
#include "study/model/model_needs.h"

namespace ps::gui {

/// Makes the reduced scene that of the window, in one step that undo takes back: A renders it, and B shows the picture
/// of the full scene, with the settings `before`, from a file. The files lie in `folder`, which is made. Loads in the
/// background; what cannot be written becomes a message.
void open_reduced(Session& session, std::shared_ptr<const ModelNeeds> needs, const Settings& before,
                  const std::filesystem::path& folder);

}  // namespace ps::gui
