#include "gui/panels/pictures/picture_size.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "gui/widgets/widgets.h"

namespace ps::gui {
namespace {

constexpr double smallest_side = 1, largest_side = 8192;  // pixels

void set_size(Session& session, Vec2d wanted) {
  const auto side = [](double pixels) {
    return static_cast<int>(std::clamp(std::round(pixels), smallest_side, largest_side));
  };
  const Vec2i size{side(wanted.x), side(wanted.y)}, old{session.view().width, session.view().height};
  if (size == old) return;
  session.edit(fmt::format("picture size {} x {}", size.x, size.y), "picture size", [&](Document& document) {
    document.view.region.reset();
    document.view.width = size.x;
    document.view.height = size.y;
    if (document.pixel.x >= 0) document.pixel = {document.pixel.x * size.x / old.x, document.pixel.y * size.y / old.y};
  });
}

Vec2d present(const Session& session) {
  return {static_cast<double>(session.view().width), static_cast<double>(session.view().height)};
}

}  // namespace

void add_size_actions(Actions& actions, Session& session, PicturesState& pictures) {
  // A picture file as B decides on the size of both.
  ActionGroup size(actions, "View", [&session] { return session.has_scene() && session.document().picture_b.empty(); });
  size.add("size-own", "Render at the scene's own size", "", [&session] {
    const View own = view_of(session.scene(), {}, 0, 0);
    set_size(session, {static_cast<double>(own.width), static_cast<double>(own.height)});
  });
  size.add("size-half", "Render at half the size", "", [&session] { set_size(session, present(session) * 0.5); });
  size.add("size-double", "Render at double the size", "", [&session] { set_size(session, present(session) * 2.0); });
  size.add("size-shown", "Render at the size at which it is shown", "",
           [&session, &pictures] { set_size(session, present(session) * pictures.drawn.transform.zoom); });
}

void size_fields(Session& session) {
  const NameScope names("size");
  const DisabledScope fixed(!session.document().picture_b.empty());
  quiet_text("Width and height");
  Vec2d size = present(session);
  const NumberRange range{.minimum = smallest_side,
                          .maximum = largest_side,
                          .scale = OptionScale::logarithmic,
                          .integer = true,
                          .unit = "px"};
  const Edit width = number("width", size.x, range, {.tooltip = "Width of both pictures.", .width = px(110)});
  ImGui::SameLine();
  const Edit height = number("height", size.y, range, {.tooltip = "Height of both pictures.", .width = px(110)});
  if (width.changed || height.changed) set_size(session, size);
}

}  // namespace ps::gui
