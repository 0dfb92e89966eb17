#include "gui/panels/studies/method_signs.h"

#include "gui/theme/theme.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/shorten.h"
#include "gui/widgets/widgets.h"

namespace ps::gui {
namespace {

std::string text_of(const MethodNames& names, Method method) {
  return method == Method::naive ? "naive: " + names.naive : "robust: " + names.robust;
}

float width_of(const std::string& text) { return px(34) + text_width(text, Face::small); }

bool in_one_line(const MethodNames& names, float width) {
  return width_of(text_of(names, Method::naive)) + width_of(text_of(names, Method::robust)) <= width;
}

}  // namespace

const ImVec4& method_colour(Method method) {
  return method == Method::naive ? palette().wrong_mark : palette().right_mark;
}

void draw_method_sign(ImDrawList& list, ImVec2 at, Method method, bool strong) {
  const float r = px(strong ? 6 : 4.5), width = px(strong ? 3 : 2);
  const ImU32 ink = colour_u32(method_colour(method));
  switch (method) {
  case Method::naive:
    list.AddLine({at.x - r, at.y - r}, {at.x + r, at.y + r}, ink, width);
    list.AddLine({at.x - r, at.y + r}, {at.x + r, at.y - r}, ink, width);
    break;
  case Method::robust:
    list.AddCircleFilled(at, r, colour_u32(palette().field), 20);
    list.AddCircle(at, r, ink, 20, width);
    break;
  }
}

float MethodNames::height(float width) const {
  const float line = theme().font(Face::small)->FontSize;
  return in_one_line(*this, width) ? line + px(6) : 2 * line + px(8);
}

std::string MethodNames::draw(ImDrawList& list, const Area& area, ImVec2 mouse) const {
  const FontScope small(Face::small);
  const float height = ImGui::GetFontSize();
  const bool in_line = in_one_line(*this, area.width());
  std::string cut;
  ImVec2 at = area.min;
  for (const Method method : {Method::naive, Method::robust}) {
    const std::string text = text_of(*this, method);
    const Area line{at, {area.max.x, at.y + height + px(2)}};
    if (at.x + width_of(text) - px(18) > area.max.x && line.contains(mouse)) cut = text;
    draw_method_sign(list, {at.x + px(6), at.y + height / 2}, method, false);
    draw_text({at.x + px(16), at.y}, {area.max.x, at.y + height}, whole_words(text, area.max.x - at.x - px(16)),
              palette().text, 0);
    if (in_line)
      at.x += width_of(text);
    else
      at.y += height + px(2);
  }
  return cut;
}

}  // namespace ps::gui
