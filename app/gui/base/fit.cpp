#include "gui/base/fit.h"

#include <imgui_internal.h>

#include <algorithm>
#include <array>

namespace ps::gui {
namespace {

constexpr float slack = 1.5f;  // pixels that rounding may take

bool inside(ImVec2 min, ImVec2 max, ImVec2 outer_min, ImVec2 outer_max) {
  return min.x >= outer_min.x - slack && min.y >= outer_min.y - slack && max.x <= outer_max.x + slack &&
         max.y <= outer_max.y + slack;
}

/// Whether what is in the window can be brought into sight up and down. Menus could, but are to be seen whole.
bool scrolls(const ImGuiWindow* window) {
  if ((window->Flags & ImGuiWindowFlags_ChildMenu) != 0) return false;
  for (; window; window = window->ParentWindow) {
    if ((window->Flags & ImGuiWindowFlags_NoScrollbar) == 0) return true;  // it gets a bar when it needs one
    if ((window->Flags & ImGuiWindowFlags_ChildWindow) == 0) return false;
  }
  return false;
}

bool same(ImVec2 a, ImVec2 b) { return a.x == b.x && a.y == b.y; }

/// Whether the part of the name before a "/" is the whole other name.
bool part_of(std::string_view name, std::string_view whole) {
  return name.size() > whole.size() && name.substr(0, whole.size()) == whole && name[whole.size()] == '/';
}

/// What is there to have other things over it: pictures, plots, and lines whose parts have names of their own.
bool is_ground(std::string_view name) {
  constexpr std::array<std::string_view, 14> ends{"/picture", "/nan",   "/divider",  "/notice", "/view",
                                                  "/pixel",   "/plot",  "/axis",     "/strip",  "/footer",
                                                  "/time",    "/scale", "/left-out", "/covered"};
  return std::any_of(ends.begin(), ends.end(), [&](std::string_view end) { return name.ends_with(end); });
}

/// What lies where its value puts it: points of a plot, handles of what is in a picture.
bool is_datum(std::string_view name) {
  return name.find("/handle/") != std::string_view::npos || name.find("/gizmo/") != std::string_view::npos ||
         name.ends_with("/orbit") || name.find("/point/") != std::string_view::npos || name.ends_with("/highlight");
}

void add(std::string& list, const std::string& item) { list += (list.empty() ? "" : "; ") + item; }

}  // namespace

FitWatch& fit_watch() {
  static FitWatch watch;
  return watch;
}

FitWatch::Frame& FitWatch::now() {
  const int number = ImGui::GetFrameCount();
  if (now_.number != number) {
    std::swap(before_, now_);
    now_.controls.clear();
    now_.texts.clear();
    now_.number = number;
  }
  return now_;
}

const FitWatch::Frame& FitWatch::finished() const {
  const bool drawing = ImGui::GetCurrentContext()->WithinFrameScope && now_.number == ImGui::GetFrameCount();
  return drawing ? before_ : now_;
}

void FitWatch::placed(const std::string& name, ImVec2 min, ImVec2 max, ImVec2 clip_min, ImVec2 clip_max) {
  const ImGuiWindow& window = *ImGui::GetCurrentWindow();
  const ImVec2 seen_min{std::max(min.x, clip_min.x), std::max(min.y, clip_min.y)};
  const ImVec2 seen_max{std::min(max.x, clip_max.x), std::min(max.y, clip_max.y)};
  // Rows that can be selected reach half a gap beyond what they show.
  const float beside = std::max(slack, ImGui::GetStyle().ItemSpacing.x / 2 + 1);
  const bool out_of_width = min.x < clip_min.x - beside || max.x > clip_max.x + beside;
  const bool out_of_height = min.y < clip_min.y - slack || max.y > clip_max.y + slack;
  // A part that is scrolled out of sight as a whole has no width there.
  const bool out_of_sight = clip_max.x <= clip_min.x || clip_max.y <= clip_min.y;
  const bool cut = (out_of_width && !out_of_sight) || (out_of_height && !scrolls(&window));
  now().controls.push_back({name, min, max, seen_min, seen_max, window.RootWindow, cut});
}

void FitWatch::shortened(ImVec2 min, ImVec2 max, std::string_view text) {
  now().texts.push_back({min, max, std::string(text)});
}

std::string FitWatch::cut() const {
  const Frame& frame = finished();
  std::string list;
  for (const Control& control : frame.controls)
    if (control.cut && !is_ground(control.name) && !is_datum(control.name)) add(list, control.name);
  for (const Text& text : frame.texts) {
    const auto owner = std::find_if(frame.controls.begin(), frame.controls.end(), [&](const Control& control) {
      return inside(text.min, text.max, control.min, control.max);
    });
    add(list, owner == frame.controls.end() ? "'" + text.text + "'" : owner->name + " '" + text.text + "'");
  }
  return list;
}

std::string FitWatch::overlap() const {
  const auto& controls = finished().controls;
  std::string list;
  for (std::size_t i = 0; i < controls.size(); ++i)
    for (std::size_t j = i + 1; j < controls.size(); ++j) {
      const Control &a = controls[i], &b = controls[j];
      if (a.layer != b.layer || is_ground(a.name) || is_ground(b.name)) continue;
      if (is_datum(a.name) || is_datum(b.name)) continue;
      if (a.name == b.name || part_of(a.name, b.name) || part_of(b.name, a.name)) continue;
      if (same(a.min, b.min) && same(a.max, b.max)) continue;  // one thing with two names
      const float width = std::min(a.seen_max.x, b.seen_max.x) - std::max(a.seen_min.x, b.seen_min.x);
      const float height = std::min(a.seen_max.y, b.seen_max.y) - std::max(a.seen_min.y, b.seen_min.y);
      if (width > slack && height > slack) add(list, a.name + " and " + b.name);
    }
  return list;
}

}  // namespace ps::gui
