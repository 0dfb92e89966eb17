#include "gui/frame/exports.h"

#include <fmt/format.h>

#include "base/archived_file.h"
#include "base/atomic_file.h"
#include "base/check.h"
#include "base/kept_inputs.h"
#include "document/bundle.h"
#include "document/document_provenance.h"
#include "document/permalink_file.h"
#include "image/file.h"
#include "inspect/story_json.h"
#include "inspect/story_markdown.h"
#include "scene/load.h"
#include "scene/scene_writer.h"

namespace ps::gui {
namespace {

std::vector<std::string> inputs_of(const Session& session) { return files_of(session.document().base); }

/// Runs `write` and shows what was saved, or why it was not.
template <class Write>
void saving(Session& session, const std::filesystem::path& path, Write&& write) {
  session.say_saved([&] {
    write();
    return fmt::format("Saved {}.", path.string());
  });
}

}  // namespace

void save_pictures(Session& session, const PicturesState& pictures, const std::filesystem::path& path) {
  // The permalink goes along, so that the state can be had again from the file.
  const auto texts_of = [&](Side side) {
    return SaveOptions{image_texts(document_provenance(session.document(), side, {}, path))};
  };
  auto named = [&](const char* suffix) {
    auto result = path;
    std::string extension = path.extension().string();
    if (extension.empty()) extension = ".png";
    result.replace_filename(path.stem().string() + suffix + extension);
    return result;
  };
  session.say_saved([&] {
    for (const char* suffix : {"-a", "-b", "-difference"}) require_no_input(named(suffix), inputs_of(session));
    for (const Side side : both_sides)
      save_image(named(side == Side::a ? "-a" : "-b"), pictures.pictures[index_of(side)].levels, texts_of(side));
    const bool difference = session.document().compare == CompareMode::difference;
    if (difference) save_image(named("-difference"), pictures.difference.picture.levels, texts_of(Side::a));
    return fmt::format("Saved {} and {}{}.", named("-a").string(), named("-b").filename().string(),
                       difference ? " and the difference" : "");
  });
}

void save_picture(Session& session, const Image<Rgb8>& picture, const std::filesystem::path& path) {
  saving(session, path, [&] {
    save_image(path, picture, SaveOptions{image_texts(document_provenance(session.document(), Side::a, {}, path))});
  });
}

void save_scene_as(Session& session, std::filesystem::path path) {
  if (path.extension().empty()) path += ".scene";
  saving(session, path, [&] {
    std::vector<std::string> inputs = inputs_of(session);
    // A scene may be saved over itself; a model that was opened by itself, and what a scene includes, may not.
    if (!inputs.empty() && std::filesystem::path(inputs.front()).extension() == ".scene") inputs.erase(inputs.begin());
    require_no_input(path, inputs);
    Scene scene = session.scene();
    scene.camera = session.view().camera;
    save_scene(scene, path);
  });
}

void save_permalink_as(Session& session, std::filesystem::path path) {
  if (path.extension() != permalink_extension) path += permalink_extension;
  saving(session, path, [&] {
    require_no_input(path, inputs_of(session));
    save_permalink(path, session.document());
  });
}

void save_bundle_as(Session& session, std::filesystem::path path) {
  if (path.extension() != archive_extension) path += archive_extension;
  saving(session, path, [&] {
    require_no_input(path, inputs_of(session));
    save_bundle(path, session.document());
  });
}

void save_story_as(Session& session, std::filesystem::path path) {
  const auto story = session.story(inspected_side(session));
  if (!story) return;
  if (path.extension().empty()) path += ".md";
  const std::string extension = path.extension().string();
  const Provenance made = document_provenance(session.document(), inspected_side(session));
  saving(session, path, [&] {
    require_no_input(path, inputs_of(session));
    if (extension == ".csv")
      write_file_atomically(path, story_csv(*story, session.scene(), made));
    else if (extension == ".json")
      write_file_atomically(path, story_json(*story, session.scene(), session.view(), made));
    else if (extension == ".md")
      write_file_atomically(path, story_markdown(*story, session.scene(), session.view(), made));
    else
      throw InputError(fmt::format("{}: found extension '{}', expected md, csv or json", path.string(), extension));
  });
}

void save_drawing(Session& session, std::filesystem::path path, const std::string& svg) {
  if (svg.empty()) return session.say(Message::Kind::warning, "There is nothing to draw yet.");
  if (path.extension().empty()) path += ".svg";
  saving(session, path, [&] {
    require_no_input(path, inputs_of(session));
    write_file_atomically(path,
                          svg_with_provenance(svg, document_provenance(session.document(), inspected_side(session))));
  });
}

}  // namespace ps::gui
