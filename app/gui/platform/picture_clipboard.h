#pragma once
#include <filesystem>

namespace ps::gui {

/// Puts a PNG file as a picture on the clipboard, in place of its text: by wl-copy under Wayland, else by xclip,
/// which keep it after the program has ended. False where that program is not installed.
bool copy_picture(const std::filesystem::path& file);

}  // namespace ps::gui
