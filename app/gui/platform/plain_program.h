#pragma once
#include <imgui.h>

namespace ps::gui {

/// Dear ImGui's callback before a rectangle with a texture that is drawn as it is: without a tint and without blending.
/// Mesa's software driver copies such rectangles several times as fast as it shades them. Without a program of ours,
/// ImGui's own draws the same, only slower. Of OpenGL.
void begin_plain(const ImDrawList* list, const ImDrawCmd* command);
/// The same for an enlarged texture with a smooth filter, whose pixels are mixed only within a pixel of the window.
void begin_even(const ImDrawList* list, const ImDrawCmd* command);

}  // namespace ps::gui
