#include "gui/panels/studies/pixel_map.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "gui/widgets/widgets.h"

namespace ps::gui {

std::optional<Vec2i> pixel_map(const char* name, const Texture& texture, ImVec2 room, Session& session, Side side) {
  const auto w = static_cast<float>(texture.width()), h = static_cast<float>(texture.height());
  const float shrink = std::min(room.x / std::max(w, 1.f), room.y / std::max(h, 1.f));
  const ImVec2 at = ImGui::GetCursorScreenPos(), size{std::max(w * shrink, 1.f), std::max(h * shrink, 1.f)};
  const bool clicked = ImGui::InvisibleButton(name, size);
  controls().record(name, fmt::format("{}x{}", texture.width(), texture.height()));
  ImGui::GetWindowDrawList()->AddImage(texture.id(), at, {at.x + size.x, at.y + size.y});
  if (!ImGui::IsItemHovered() && !clicked) return {};
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const Vec2i pixel{std::clamp(static_cast<int>((mouse.x - at.x) / shrink), 0, texture.width() - 1),
                    std::clamp(static_cast<int>((mouse.y - at.y) / shrink), 0, texture.height() - 1)};
  if (clicked)
    session.navigate([&](Document& document) {
      document.pixel = pixel;
      document.picked = side;
    });
  return pixel;
}

}  // namespace ps::gui
