#include "gui/base/record.h"

#include <imgui_internal.h>

#include <vector>

#include "gui/base/fit.h"

namespace ps::gui {
namespace {

std::string& name_prefix() {
  static std::string prefix;
  return prefix;
}
std::vector<std::size_t>& prefix_lengths() {
  static std::vector<std::size_t> lengths;
  return lengths;
}

}  // namespace

NameScope::NameScope(std::string_view prefix) {
  prefix_lengths().push_back(name_prefix().size());
  name_prefix().append(prefix);
  name_prefix().push_back('/');
}

NameScope::~NameScope() {
  name_prefix().resize(prefix_lengths().back());
  prefix_lengths().pop_back();
}

std::string full_name(std::string_view name) { return name_prefix() + std::string(name); }

void ControlRecords::record(std::string_view name, std::string value, bool enabled) {
  record(name, ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), std::move(value), enabled);
}

void ControlRecords::record(std::string_view name, ImVec2 min, ImVec2 max, std::string value, bool enabled) {
  const std::string full = full_name(name);
  // In a table the window's clip rectangle is the column's, but rows span all columns.
  const ImGuiTable* table = ImGui::GetCurrentTable();
  const ImRect& clip = table ? table->InnerClipRect : ImGui::GetCurrentWindow()->ClipRect;
  const bool dead = (ImGui::GetCurrentContext()->CurrentItemFlags & ImGuiItemFlags_Disabled) != 0;
  records_[full] = {min, max, clip.Min, clip.Max, enabled && !dead, std::move(value), ImGui::GetFrameCount()};
  fit_watch().placed(full, min, max, clip.Min, clip.Max);
  if (!reveals(full)) return;
  ImGuiWindow* window = ImGui::GetCurrentWindow();
  if (!visible(records_[full])) ImGui::ScrollToBringRectIntoView(window, {min, max});
}

const ControlRecord* ControlRecords::find(std::string_view name) const {
  const auto found = records_.find(name);
  if (found == records_.end() || found->second.frame + 1 < ImGui::GetFrameCount()) return nullptr;
  return &found->second;
}

bool ControlRecords::visible(const ControlRecord& control) const {
  const ImVec2 middle{(control.min.x + control.max.x) / 2, (control.min.y + control.max.y) / 2};
  return middle.x >= control.clip_min.x && middle.x < control.clip_max.x && middle.y >= control.clip_min.y &&
         middle.y < control.clip_max.y;
}

ControlRecords& controls() {
  static ControlRecords records;
  return records;
}

}  // namespace ps::gui
