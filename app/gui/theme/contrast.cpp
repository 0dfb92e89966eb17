#include "gui/theme/contrast.h"

#include <fmt/format.h>

#include <algorithm>

namespace ps::gui {
namespace {

struct NamedColour {
  const char* name;
  ImVec4 colour;
};

/// Half-transparent colours are what they are over their ground.
ImVec4 over(const ImVec4& colour, const ImVec4& ground) {
  const auto mix = [&](float c, float g) { return colour.w * c + (1 - colour.w) * g; };
  return {mix(colour.x, ground.x), mix(colour.y, ground.y), mix(colour.z, ground.z), 1};
}

void check(const std::vector<NamedColour>& inks, const std::vector<NamedColour>& grounds, double needed,
           const ImVec4& below, std::vector<std::string>& faults) {
  for (const NamedColour& ground : grounds)
    for (const NamedColour& ink : inks) {
      const ImVec4 solid = over(ground.colour, below);
      const double found = contrast(over(ink.colour, solid), solid);
      if (!(found >= needed))
        faults.push_back(fmt::format("{} on {}: {:.2f}, needs {}", ink.name, ground.name, found, needed));
    }
}

}  // namespace

std::vector<std::string> contrast_faults(const Palette& p) {
  std::vector<std::string> faults;
  const std::vector<NamedColour> grounds{{"window", p.window},
                                         {"panel", p.panel},
                                         {"field", p.field},
                                         {"field_hover", p.field_hover},
                                         {"field_active", p.field_active},
                                         {"selection", p.selection}};
  check({{"text", p.text}, {"text_quiet", p.text_quiet}, {"text_disabled", p.text_disabled}}, grounds, text_contrast,
        p.panel, faults);
  // Rings of `attention`, as around what a link leads to, lie between two lines of `text`.
  check({{"text as the edge of a ring", p.text}}, grounds, mark_contrast, p.panel, faults);
  const double ring = std::max(contrast(p.attention, p.text), contrast(p.attention, p.panel));
  if (!(ring >= mark_contrast))
    faults.push_back(fmt::format("attention in a ring: {:.2f}, needs {}", ring, mark_contrast));
  // Marks lie on panels and in fields. `right`, `wrong` and `attention` are areas, whose edge is `text_quiet`.
  check({{"a", p.a},
         {"b", p.b},
         {"right_mark", p.right_mark},
         {"wrong_mark", p.wrong_mark},
         {"line_strong", p.line_strong},
         {"text_quiet as an edge", p.text_quiet}},
        {{"panel", p.panel}, {"field", p.field}}, mark_contrast, p.panel, faults);

  ImVec4 colours[ImGuiCol_COUNT];
  apply_colours(p, colours);
  std::vector<NamedColour> imgui_grounds;
  for (const ImGuiCol ground :
       {ImGuiCol_WindowBg,       ImGuiCol_ChildBg,       ImGuiCol_PopupBg,      ImGuiCol_FrameBg,
        ImGuiCol_FrameBgHovered, ImGuiCol_FrameBgActive, ImGuiCol_TitleBg,      ImGuiCol_MenuBarBg,
        ImGuiCol_Button,         ImGuiCol_ButtonHovered, ImGuiCol_ButtonActive, ImGuiCol_Header,
        ImGuiCol_HeaderHovered,  ImGuiCol_HeaderActive,  ImGuiCol_Tab,          ImGuiCol_TabHovered,
        ImGuiCol_TabActive,      ImGuiCol_TableHeaderBg, ImGuiCol_TableRowBg,   ImGuiCol_TableRowBgAlt,
        ImGuiCol_TextSelectedBg})
    imgui_grounds.push_back({ImGui::GetStyleColorName(ground), colours[ground]});
  check({{"ImGui's Text", colours[ImGuiCol_Text]}, {"ImGui's TextDisabled", colours[ImGuiCol_TextDisabled]}},
        imgui_grounds, text_contrast, p.panel, faults);
  check({{"ImGui's CheckMark", colours[ImGuiCol_CheckMark]},
         {"ImGui's NavHighlight", colours[ImGuiCol_NavHighlight]},
         {"ImGui's SliderGrab", colours[ImGuiCol_SliderGrab]}},
        {{"FrameBg", colours[ImGuiCol_FrameBg]}}, mark_contrast, p.panel, faults);
  return faults;
}

}  // namespace ps::gui
