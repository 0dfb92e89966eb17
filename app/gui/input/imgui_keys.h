#pragma once
#include "gui/input/key.h"

struct ImGuiIO;

namespace ps::gui {

/// Where Dear ImGui keeps the state of a key; for ImGui::IsKeyDown and IsKeyPressed.
constexpr int imgui_key(Key key) { return static_cast<int>(key); }
/// Lets the keys that Dear ImGui itself acts on be found there.
void map_imgui_keys(ImGuiIO& io);

}  // namespace ps::gui
