#pragma once
#include <string>

#include "gui/frame/plan.h"
#include "gui/session/session.h"

namespace ps::gui {

/// The margins above and below what is in a region: those of a region of one line are tight.
enum class RegionPadding { normal, tight };

/// Notes where a part of the window is drawn, for scripts.
void note_area(std::string_view name, const Area& area);
/// Where it was drawn last: "LEFT,TOP RIGHT,BOTTOM" in window pixels; empty if it never was.
std::string noted_area(std::string_view name);

/// Begins a region of the window; ImGui::EndChild() after what is in it. With a heading, a double click on that lets
/// the region fill the window, another one or Esc takes it back. `name` is one of region_names.
void begin_region(Session& session, std::string_view name, const Area& area, const std::string& heading = {},
                  RegionPadding padding = RegionPadding::normal);

/// The heading alone, for a region that was begun without one: what lies over it is drawn before it.
/// `reserved`: so much at its right end is left to something else, window pixels.
void region_heading(Session& session, std::string_view name, const std::string& heading, float reserved = 0);

}  // namespace ps::gui
