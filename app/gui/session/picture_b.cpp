// A picture from a file in the place of B.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <utility>

#include "base/check.h"
#include "gui/session/session.h"
#include "image/file.h"

namespace ps::gui {

bool is_picture_file(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  constexpr std::array pictures{".png", ".ppm", ".pgm", ".pbm", ".pnm", ".pfm", ".jpg", ".jpeg", ".tga", ".bmp"};
  return std::find(pictures.begin(), pictures.end(), extension) != pictures.end();
}

void Session::open_picture_b(const std::filesystem::path& path) {
  if (!has_scene()) return;
  try {
    picture_b_ = std::make_shared<const PictureFile>(PictureFile{path.string(), load_levels(path)});
  } catch (const InputError& error) {
    return say(Message::Kind::error, error.what());
  }
  const Vec2i size{picture_b_->levels.width(), picture_b_->levels.height()};
  if (document_.picture_b == path.string() && size == Vec2i{view().width, view().height}) return changed();  // anew
  edit("compare with " + path.filename().string(), [&](Document& document) {
    const Vec2i old{view().width, view().height};
    document.picture_b = path.string();
    document.view.region.reset();
    document.view.width = size.x;
    document.view.height = size.y;
    if (document.pixel.x >= 0) document.pixel = {document.pixel.x * size.x / old.x, document.pixel.y * size.y / old.y};
  });
  changed();
  say(Message::Kind::information, fmt::format("B is {} now, {} x {} pixels; A is rendered in that size.",
                                              path.filename().string(), size.x, size.y));
}

void Session::close_picture_b() {
  edit("render B", [](Document& document) { document.picture_b.clear(); });
}

void Session::follow_picture_b() {
  const std::string& path = document_.picture_b;
  if (path == (picture_b_ ? picture_b_->path : std::string())) return;
  const bool rendered = !picture_b_;
  picture_b_.reset();
  try {
    if (!path.empty()) picture_b_ = std::make_shared<const PictureFile>(PictureFile{path, load_levels(path)});
  } catch (const InputError& error) {
    return give_up_picture_b(error.what());
  }
  if (!rendered && !picture_b_)
    renderers_[1] = std::make_unique<RenderWorker>(prepared_, host_.wake);  // all of its picture is new to the window
}

void Session::give_up_picture_b(const std::string& why) {
  say(Message::Kind::warning, why + " (B is rendered instead)");
  document_.picture_b.clear();
  picture_b_.reset();
  renderers_[1] = std::make_unique<RenderWorker>(prepared_, host_.wake);
}

}  // namespace ps::gui
