#pragma once
#include <ctime>
#include <filesystem>
#include <functional>
#include <string>

#include "gui/input/actions.h"
#include "gui/panels/pictures/pictures_panel.h"

namespace ps::gui {

/// "cgfs-shadows-20250131-140507": a scene and a local time as the start of a file's name.
std::string shot_name(const std::string& scene, const std::tm& time);

/// Where shots go: $XDG_PICTURES_DIR if it is set, else the folder in which the program was started.
std::filesystem::path shot_folder();

/// FOLDER/NAME followed by SUFFIX.png, with a number before the suffix where such a file is there already.
std::filesystem::path free_shot(const std::filesystem::path& folder, const std::string& name,
                                const std::string& suffix);

/// Asks for a picture of the window as it is drawn next.
using AskShot = std::function<void(std::function<void(Image<Rgb8>)>)>;

/// The keys that save both pictures, or the window, at once under such a name.
void add_shot_actions(Actions& actions, Session& session, const PicturesState& pictures, const AskShot& ask);

}  // namespace ps::gui
