#include "gui/panels/pictures/handles_view.h"

#include <cmath>
#include <numbers>

#include "gui/base/record.h"
#include "gui/panels/pictures/marks.h"

namespace ps::gui {
namespace {

constexpr double handle_reach = 10;  // window pixels at scale 1 within which a handle is taken

void mark(ImDrawList& list, const Handle& handle, ImVec2 at, float radius) {
  light_on_dark(false, [&](ImU32 colour, float thickness) {
    list.AddCircle(at, radius, colour, 0, thickness);
    if (handle.is_light) {
      for (int ray = 0; ray < 8; ++ray) {
        const float angle = static_cast<float>(ray) * std::numbers::pi_v<float> / 4;
        const ImVec2 sense{std::cos(angle), std::sin(angle)};
        list.AddLine({at.x + sense.x * radius * 1.4f, at.y + sense.y * radius * 1.4f},
                     {at.x + sense.x * radius * 1.9f, at.y + sense.y * radius * 1.9f}, colour, thickness);
      }
    } else {
      list.AddLine({at.x - radius, at.y}, {at.x + radius, at.y}, colour, thickness);
      list.AddLine({at.x, at.y - radius}, {at.x, at.y + radius}, colour, thickness);
    }
  });
}

void small_mark(ImDrawList& list, ImVec2 at) {
  list.AddCircleFilled(at, px(4.5), IM_COL32(0, 0, 0, 170));
  list.AddCircleFilled(at, px(3), IM_COL32(255, 255, 255, 255));
}

}  // namespace

std::vector<Handle> visible_handles(const Scene& scene, const View& view, const Settings& settings,
                                    const PictureTransform& transform, const Area& area) {
  if (scene.geometry->objects.size() + scene.lights->size() > most_handles) return {};
  auto handles = handles_of(scene, view, settings);
  std::erase_if(handles, [&](const Handle& handle) {
    return handle.place.x < 0 || handle.place.y < 0 || handle.place.x >= view.width || handle.place.y >= view.height ||
           !area.contains(transform.to_window(handle.place, area));
  });
  return handles;
}

const Handle* handle_at(const std::vector<Handle>& handles, ImVec2 point, const PictureTransform& transform,
                        const Area& area) {
  const Handle* nearest = nullptr;
  float least = px(handle_reach);
  for (const Handle& handle : handles) {
    const ImVec2 at = transform.to_window(handle.place, area);
    const float distance = std::hypot(at.x - point.x, at.y - point.y);
    if (distance > least) continue;
    least = distance;
    nearest = &handle;
  }
  return nearest;
}

void draw_handles(ImDrawList& list, const std::vector<Handle>& handles, const std::string& held,
                  const PictureTransform& transform, const Area& area) {
  list.PushClipRect(area.min, area.max, true);
  for (const Handle& handle : handles)
    if (handle.path != held) small_mark(list, transform.to_window(handle.place, area));
  for (const Handle& handle : handles) {
    if (handle.path != held) continue;
    const ImVec2 at = transform.to_window(handle.place, area);
    mark(list, handle, at, px(8));
    name_plate(list, "drag " + handle.name, at, 18, area);
  }
  list.PopClipRect();
}

void record_handles(const std::string& prefix, const std::vector<Handle>& handles, const PictureTransform& transform,
                    const Area& area) {
  for (const Handle& handle : handles) {
    const ImVec2 at = transform.to_window(handle.place, area);
    const float half = px(4);
    controls().record(prefix + "/handle/" + handle.path, {at.x - half, at.y - half}, {at.x + half, at.y + half},
                      handle.name);
  }
}

}  // namespace ps::gui
