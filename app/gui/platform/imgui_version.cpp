#include "gui/platform/imgui_version.h"

#include <SDL.h>
#include <imgui_internal.h>  // who has the wheel, and buttons under later items

#include <algorithm>
#include <iterator>
#include <optional>
#if __has_include(<backends/imgui_impl_sdl2.h>)
#include <backends/imgui_impl_sdl2.h>
#else
#include <backends/imgui_impl_sdl.h>
#endif

#include "base/check.h"

#define PS_IMGUI_SINCE_1_87 (IMGUI_VERSION_NUM >= 18700)    // input as events, a name for each key
#define PS_IMGUI_SINCE_1_89 (IMGUI_VERSION_NUM >= 18900)    // items own keys, and the wheel is one
#define PS_IMGUI_SINCE_1_89_7 (IMGUI_VERSION_NUM >= 18970)  // what may lie over an item is said before it

namespace ps::gui {
namespace {

struct ImguiRow {
  ImGuiKey theirs;
  Key ours;
};

/// The keys that Dear ImGui acts on itself.
constexpr ImguiRow imgui_rows[] = {
    {ImGuiKey_Tab, Key::tab},
    {ImGuiKey_LeftArrow, Key::left},
    {ImGuiKey_RightArrow, Key::right},
    {ImGuiKey_UpArrow, Key::up},
    {ImGuiKey_DownArrow, Key::down},
    {ImGuiKey_PageUp, Key::page_up},
    {ImGuiKey_PageDown, Key::page_down},
    {ImGuiKey_Home, Key::home},
    {ImGuiKey_End, Key::end},
    {ImGuiKey_Insert, Key::insert},
    {ImGuiKey_Delete, Key::del},
    {ImGuiKey_Backspace, Key::backspace},
    {ImGuiKey_Space, Key::space},
    {ImGuiKey_Enter, Key::enter},
    {ImGuiKey_Escape, Key::escape},
    {ImGuiKey_A, Key::a},
    {ImGuiKey_C, Key::c},
    {ImGuiKey_V, Key::v},
    {ImGuiKey_X, Key::x},
    {ImGuiKey_Y, Key::y},
    {ImGuiKey_Z, Key::z},
#if PS_IMGUI_SINCE_1_87
    {ImGuiKey_KeypadEnter, Key::keypad_enter},
};

/// What ImGui::IsKeyPressed asks for; none for another key.
std::optional<ImGuiKey> imgui_key(Key key) {
  const auto row =
      std::find_if(std::begin(imgui_rows), std::end(imgui_rows), [&](const ImguiRow& r) { return r.ours == key; });
  return row == std::end(imgui_rows) ? std::nullopt : std::optional(row->theirs);
}
#else
    {ImGuiKey_KeyPadEnter, Key::keypad_enter},
};
static_assert(std::size(imgui_rows) == ImGuiKey_COUNT);

/// What ImGui::IsKeyPressed asks for: where a program keeps the state of a key is its own choice.
std::optional<int> imgui_key(Key key) { return static_cast<int>(key); }
#endif

}  // namespace

// --- input -------------------------------------------------------------------------------------------------------

void begin_tracked_input([[maybe_unused]] ImGuiIO& io) {
#if PS_IMGUI_SINCE_1_87
  io.ConfigInputTrickleEventQueue = false;  // InputTracker spreads events over frames
#else
  for (const ImguiRow& row : imgui_rows) io.KeyMap[row.theirs] = *imgui_key(row.ours);
#endif
}

void set_pointer(ImGuiIO& io, ImVec2 at) {
#if PS_IMGUI_SINCE_1_87
  io.AddMousePosEvent(at.x, at.y);
#else
  io.MousePos = at;
#endif
}

void set_key(ImGuiIO& io, Key key, bool down) {
  const auto theirs = imgui_key(key);
  if (!theirs) return;
#if PS_IMGUI_SINCE_1_87
  io.AddKeyEvent(*theirs, down);
#else
  io.KeysDown[*theirs] = down;
#endif
}

void set_modifiers(ImGuiIO& io, bool ctrl, bool shift, bool alt) {
#if PS_IMGUI_SINCE_1_87
  io.AddKeyEvent(ImGuiKey_ModCtrl, ctrl);
  io.AddKeyEvent(ImGuiKey_ModShift, shift);
  io.AddKeyEvent(ImGuiKey_ModAlt, alt);
#else
  io.KeyCtrl = ctrl;
  io.KeyShift = shift;
  io.KeyAlt = alt;
  io.KeySuper = false;
#endif
}

bool key_pressed(Key key, KeyRepeat repeat) {
  const auto theirs = imgui_key(key);
  PS_ASSERT(theirs, "every key that the window asks for has a name in Dear ImGui");
  return ImGui::IsKeyPressed(*theirs, repeat == KeyRepeat::repeats);
}

void forget_edits_before(const char* label) {
  const ImGuiID field = ImGui::GetID(label);
  if (field == ImGui::GetActiveID()) return;
  if (ImGuiInputTextState* state = ImGui::GetInputTextState(field)) state->ID = 0;
}

void give_keyboard_to_next_item() {
#if PS_IMGUI_SINCE_1_87
  ImGui::SetWindowFocus();
#endif
  ImGui::SetKeyboardFocusHere();
}

void take_wheel_for_item() {
#if PS_IMGUI_SINCE_1_89
  ImGui::SetItemKeyOwner(ImGuiKey_MouseWheelY, 0);
#else
  ImGui::SetItemUsingMouseWheel();
#endif
}

bool wheel_is_taken() {
#if PS_IMGUI_SINCE_1_89
  constexpr auto no_owner = static_cast<ImGuiID>(-1);  // Dear ImGui gave it another name in 1.90.6
  return !ImGui::TestKeyOwner(ImGuiKey_MouseWheelY, no_owner);
#else
  return ImGui::GetCurrentContext()->HoveredIdPreviousFrameUsingMouseWheel;
#endif
}

// --- items over which later items may lie ------------------------------------------------------------------------

Overlappable::Overlappable() {
#if PS_IMGUI_SINCE_1_89_7
  ImGui::SetNextItemAllowOverlap();
#endif
}

Overlappable::~Overlappable() {
#if !PS_IMGUI_SINCE_1_89_7
  ImGui::SetItemAllowOverlap();
#endif
}

ImGuiButtonFlags Overlappable::button_flags() {
#if PS_IMGUI_SINCE_1_89_7
  return ImGuiButtonFlags_None;
#else
  return ImGuiButtonFlags_AllowItemOverlap;
#endif
}

// --- the back end for SDL ----------------------------------------------------------------------------------------

void attach_to_window(SDL_Window* window, void* opengl_context) {
  ImGui_ImplSDL2_InitForOpenGL(window, opengl_context);
}

void attach_to_window(SDL_Window* window, [[maybe_unused]] SDL_Renderer* renderer) {
#if PS_IMGUI_SINCE_1_87
  ImGui_ImplSDL2_InitForSDLRenderer(window, renderer);
#else
  ImGui_ImplSDL2_InitForSDLRenderer(window);
#endif
}

void detach_from_window() { ImGui_ImplSDL2_Shutdown(); }

void begin_window_frame() {
  ImGui_ImplSDL2_NewFrame();
  // The back end of 1.87 counts buttons in events that it does not get here.
  SDL_CaptureMouse(ImGui::IsAnyMouseDown() ? SDL_TRUE : SDL_FALSE);
}

}  // namespace ps::gui
