// A picture from a file in the place of B.
#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <utility>

#include "base/check.h"
#include "base/extension.h"
#include "gui/session/session.h"
#include "image/display.h"
#include "image/file.h"
#include "image/picture_format.h"

namespace ps::gui {

namespace {

/// Whether the first bytes of a file are those of a picture, whatever its name is.
bool begins_like_a_picture(const std::string& path) {
  std::string head(16, ' ');
  std::ifstream file(path, std::ios::binary);
  return file.read(head.data(), static_cast<std::streamsize>(head.size())) && format_by_content(head);
}

PictureFile read_picture_file(const std::string& path) {
  StoredPicture stored = load_picture(path);
  Image<Rgb8> levels = display_image(stored.colour);
  return {path, std::move(stored), std::move(levels)};
}

}  // namespace

bool is_picture_file(const std::string& path) {
  const std::string extension = lower_extension(path);
  return format_by_name(path) || extension == ".pbm" || extension == ".bmp" || begins_like_a_picture(path);
}

void Session::open_picture_b(const std::filesystem::path& path) {
  if (!has_scene()) return;
  try {
    picture_b_ = std::make_shared<const PictureFile>(read_picture_file(path.string()));
  } catch (const InputError& error) {
    return say(Message::Kind::error, error.what());
  }
  const Vec2i size{picture_b_->levels.width(), picture_b_->levels.height()};
  if (document().picture_b == path.string() && size == Vec2i{view().width, view().height}) return changed();  // anew
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
  for (const std::string& note : picture_b_->stored.notes)
    say(Message::Kind::warning, fmt::format("{}: {}.", path.filename().string(), note));
}

void Session::close_picture_b() {
  edit("render B", [](Document& document) { document.picture_b.clear(); });
}

void Session::follow_picture_b() {
  const std::string& path = document().picture_b;
  if (path == (picture_b_ ? picture_b_->path : std::string())) return;
  const bool rendered = !picture_b_;
  picture_b_.reset();
  try {
    if (!path.empty()) picture_b_ = std::make_shared<const PictureFile>(read_picture_file(path));
  } catch (const InputError& error) {
    return give_up_picture_b(error.what());
  }
  if (!rendered && !picture_b_) work_.begin_anew(Side::b);
}

void Session::give_up_picture_b(const std::string& why) {
  say(Message::Kind::warning, why + " (B is rendered instead)");
  change_silently().picture_b.clear();
  picture_b_.reset();
  work_.begin_anew(Side::b);
}

}  // namespace ps::gui
