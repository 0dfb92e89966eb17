#pragma once
#include "gui/session/session.h"

namespace ps::gui {

/// The lesson that shows a newcomer round.
constexpr const char* first_look_lesson = "a_first_look";

/// Offers that lesson, in the lesson's place; its height there, with text so wide.
float first_look_height(float width);
enum class FirstLookAnswer { none, start, not_now };
FirstLookAnswer first_look_offer();

}  // namespace ps::gui
