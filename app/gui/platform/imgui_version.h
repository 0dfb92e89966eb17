#pragma once
// The differences between the versions 1.86 and 1.91 of Dear ImGui. imgui_version.cpp alone asks for the version.
#include <imgui.h>

#include <cstdint>

#include "gui/input/key.h"

struct SDL_Renderer;
struct SDL_Window;

namespace ps::gui {

// --- input, which InputTracker reports in place of Dear ImGui's back end for SDL ---------------------------------

/// Before the first frame.
void begin_tracked_input(ImGuiIO& io);
/// In pixels of the window; -FLT_MAX where the pointer is not over it. Overrules what the back end said in this frame.
void set_pointer(ImGuiIO& io, ImVec2 at);
void set_key(ImGuiIO& io, Key key, bool down);
void set_modifiers(ImGuiIO& io, bool ctrl, bool shift, bool alt);

enum class KeyRepeat { repeats, once };
/// Whether the key went down in this frame or, if it `repeats`, is held long enough to count again. For keys that Dear
/// ImGui acts on: Enter, Esc, arrows and the like.
bool key_pressed(Key key, KeyRepeat repeat = KeyRepeat::repeats);

/// Gives the keyboard to the next item and to its window: newer versions leave it where it is if another window has it.
void give_keyboard_to_next_item();

/// Keeps the wheel from scrolling the panel while the pointer is over the last item, from the next frame on.
void take_wheel_for_item();
/// Whether an item took the wheel in the frame before this one.
bool wheel_is_taken();

/// To be called before a text field of this name that others may fill as well. Dear ImGui keeps what undo needs of the
/// field that was edited last, and up to 1.90 applies it to another text, with places beyond its end.
void forget_edits_before(const char* label);

// --- items over which later items may lie ------------------------------------------------------------------------

/// Lives while such an item is made. The later item is then hovered alone.
class Overlappable {
 public:
  Overlappable();
  ~Overlappable();
  Overlappable(const Overlappable&) = delete;
  Overlappable& operator=(const Overlappable&) = delete;

  /// To be added to the flags if the item is a button.
  static ImGuiButtonFlags button_flags();
};

// --- the back end for SDL ----------------------------------------------------------------------------------------

void attach_to_window(SDL_Window* window, void* opengl_context);
void attach_to_window(SDL_Window* window, SDL_Renderer* renderer);
void detach_from_window();
/// Before ImGui::NewFrame(): time, size and shape of the pointer. A drag goes on outside the window.
void begin_window_frame();

// --- numbers of textures: a pointer or an integer ----------------------------------------------------------------

inline std::uintptr_t texture_number(ImTextureID texture) { return std::uintptr_t(texture); }
// NOLINTNEXTLINE(performance-no-int-to-ptr): where it is a pointer, Dear ImGui only hands it on
inline ImTextureID texture_of_number(std::uintptr_t number) { return ImTextureID(number); }

}  // namespace ps::gui
