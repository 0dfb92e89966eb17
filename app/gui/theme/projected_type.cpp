#include "gui/theme/projected_type.h"

namespace ps::gui {
namespace {

/// The window's, and the presenter's.
struct Themes {
  Theme window, projected;
  Theme* in_use = &window;
  bool wanted = false;
};

Themes& themes() {
  static Themes both;
  return both;
}

}  // namespace

Theme& theme() { return *themes().in_use; }

void want_projected_type(bool wanted) { themes().wanted = wanted; }

bool prepare_themes() {
  auto& [window, projected, in_use, wanted] = themes();
  const bool reloaded = window.prepare();
  if (reloaded) projected = Theme();  // its faces went with the atlas
  if (!wanted) return reloaded;
  const ImGuiStyle style = ImGui::GetStyle();
  projected.set_brightness(window.brightness());
  projected.set_scale(window.scale() * projected_share());
  const bool added = projected.prepare();
  ImGui::GetStyle() = style;
  return reloaded || added;
}

ProjectedType::ProjectedType() : outside_(ImGui::GetStyle()) {
  Themes& both = themes();
  acts_ = both.wanted && both.projected.font(Face::body);
  if (!acts_) return;
  both.in_use = &both.projected;
  ImGui::GetStyle().ScaleAllSizes(static_cast<float>(projected_share()));
  ImGui::PushFont(theme().font(Face::body));
}

ProjectedType::~ProjectedType() {
  if (!acts_) return;
  ImGui::PopFont();
  ImGui::GetStyle() = outside_;
  themes().in_use = &themes().window;
}

bool ProjectedType::in_use() { return themes().in_use == &themes().projected; }

}  // namespace ps::gui
