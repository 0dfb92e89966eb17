#include "gui/frame/file_questions.h"

#include <filesystem>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "base/archived_file.h"
#include "document/permalink_file.h"
#include "gui/frame/exports.h"

namespace ps::gui {
namespace {

FileQuestion saves_with(Session& session, void (*save)(Session&, std::filesystem::path), FileQuestion question) {
  question.answer = [&session, save](const FileAnswer& file) { save(session, file.path); };
  return question;
}

/// The name under which something of the scene is saved: "spheres.png" for "cgfs/spheres".
std::string suggested_name(const Session& session, std::string_view extension) {
  const std::string stem = std::filesystem::path(session.scene().name).stem().string();
  return fmt::format("{}{}", stem.empty() ? "scene" : stem, extension);
}

}  // namespace

FileQuestion scene_question(Session& session) {
  return {.title = "Open a scene",
          .use = FileUse::open,
          .extensions = {".scene", ".obj", permalink_extension, archive_extension},
          .hint = "path or name",
          .answer = [&session](const FileAnswer& file) {
            // A built-in name may be typed as well; the dialog puts its folder before what is not absolute.
            std::error_code error;
            const bool is_file = std::filesystem::exists(file.path, error);
            session.open(is_file ? file.path.string() : file.typed);
          }};
}

FileQuestion compare_question(Session& session) {
  return {.title = "Compare with a picture",
          .use = FileUse::open,
          .extensions = {".png", ".ppm", ".pfm"},
          .hint = "picture.png",
          .answer = [&session](const FileAnswer& file) { session.open_picture_b(file.path); }};
}

FileQuestion picture_question(Session& session, const PicturesState& pictures) {
  return {.title = "Save the pictures",
          .extensions = {".png", ".ppm"},
          .hint = "picture.png",
          .suggestion = suggested_name(session, ".png"),
          .answer = [&session, &pictures](const FileAnswer& file) { save_pictures(session, pictures, file.path); }};
}

FileQuestion save_scene_question(Session& session) {
  return saves_with(session, save_scene_as,
                    {.title = "Save the scene",
                     .extensions = {".scene"},
                     .hint = "my.scene",
                     .suggestion = suggested_name(session, ".scene"),
                     .answer = {}});
}

FileQuestion save_screen_question(Session& session) {
  return saves_with(session, save_permalink_as,
                    {.title = "Save the screen",
                     .extensions = {std::string(permalink_extension)},
                     .hint = "screen.permalink",
                     .suggestion = suggested_name(session, permalink_extension),
                     .answer = {}});
}

FileQuestion save_bundle_question(Session& session) {
  return saves_with(session, save_bundle_as,
                    {.title = "Save a bundle",
                     .extensions = {archive_extension},
                     .hint = "bundle.tar",
                     .suggestion = suggested_name(session, archive_extension),
                     .answer = {}});
}

FileQuestion save_story_question(Session& session) {
  return saves_with(session, save_story_as,
                    {.title = "Save the pixel's story",
                     .extensions = {".md", ".csv", ".json"},
                     .hint = "story.md, .csv or .json",
                     .suggestion = "story.md",
                     .answer = {}});
}

FileQuestion save_drawing_question(Session& session, const SaveDrawing& drawing) {
  return {.title = drawing.title,
          .extensions = {".svg"},
          .hint = "drawing.svg",
          .suggestion = drawing.suggestion,
          .answer = [&session, svg = drawing.svg](const FileAnswer& file) { save_drawing(session, file.path, svg()); }};
}

}  // namespace ps::gui
