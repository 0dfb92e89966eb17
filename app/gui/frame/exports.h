#pragma once
#include <filesystem>
#include <string>

#include "gui/panels/pictures/pictures_panel.h"
#include "gui/session/session.h"

namespace ps::gui {

// Each of these writes a file with where it comes from, in the form that its extension names, and says so. An
// InputError becomes a message. None writes over a file that the open scene was read from, but for a scene over itself.

/// What is shown of A and B as NAME-a.png and NAME-b.png, and of the difference as NAME-difference.png while it is on
/// the screen.
void save_pictures(Session& session, const PicturesState& pictures, const std::filesystem::path& path);
/// One picture, with the permalink of the screen.
void save_picture(Session& session, const Image<Rgb8>& picture, const std::filesystem::path& path);
/// The scene as it is now, with its edits and the camera that is looked through.
void save_scene_as(Session& session, std::filesystem::path path);
/// Everything on the screen as a file of one line, which opens as a scene does.
void save_permalink_as(Session& session, std::filesystem::path path);
/// The same with the scene's own files, for other people and other machines.
void save_bundle_as(Session& session, std::filesystem::path path);
/// The story of the picked pixel: md, csv or json.
void save_story_as(Session& session, std::filesystem::path path);
/// A drawing; `svg` is empty while there is none.
void save_drawing(Session& session, std::filesystem::path path, const std::string& svg);

}  // namespace ps::gui
