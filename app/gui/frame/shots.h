#pragma once
#include <ctime>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "gui/input/actions.h"
#include "gui/panels/pictures/pictures_panel.h"

namespace ps::gui {

/// "cgfs-shadows-20250131-140507": a scene and a local time as the start of a file's name.
std::string shot_name(const std::string& scene, const std::tm& time);

/// Where shots go: $XDG_PICTURES_DIR if it is set, else the folder that was used last.
std::filesystem::path shot_folder(const std::filesystem::path& last);

/// NAME, with a number behind it where FOLDER has a file NAME followed by SUFFIX.png already.
std::string free_name(const std::filesystem::path& folder, const std::string& name, std::string_view suffix);

/// Services of the window for shots.
struct ShotHost {
  /// Asks for a picture of the window as it is drawn next.
  std::function<void(std::function<void(Image<Rgb8>)>)> ask;
  std::function<void(const std::string&)> copy;  ///< puts text on the clipboard
  std::function<std::filesystem::path()> last_folder;
};

/// The actions that save both pictures, the window, or a picture for slides at once under such a name.
void add_shot_actions(Actions& actions, Session& session, const PicturesState& pictures, const ShotHost& host);

}  // namespace ps::gui
