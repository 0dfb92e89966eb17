#pragma once
#include <string>
#include <string_view>

namespace ps::cli {

/// The files of a new lesson: a lesson.md that explains its own form, shows each kind of block and passes the
/// check.
std::string lesson_template();
/// The scene file beside it, balls.scene.
extern const std::string_view lesson_template_scene;

}  // namespace ps::cli
