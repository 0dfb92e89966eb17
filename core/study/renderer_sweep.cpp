#include "study/renderer_sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "render/renderer_table.h"
#include "scene/scene.h"

namespace ps {
namespace {

std::optional<IdleReason> why_not_here(const RendererKind& kind) {
  return kind.inactive ? kind.inactive(Settings{}, SceneTraits{}) : std::nullopt;
}

bool draws_any_scene(const RendererKind& kind) { return kind.way != PictureWay::listing; }

}  // namespace

std::string renderer_sweep_axis() {
  std::string keys;
  for (const RendererKind& kind : renderer_kinds())
    if (draws_any_scene(kind)) keys += fmt::format("{}{}", keys.empty() ? "" : ",", kind.key);
  return "renderer=" + keys;
}

std::vector<SweepAxis> without_absent_renderers(std::vector<SweepAxis> axes) {
  for (SweepAxis& axis : axes) {
    if (axis.option->key != "renderer") continue;
    for (const RendererKind& kind : renderer_kinds())
      if (why_not_here(kind)) std::erase(axis.values, kind.key);
  }
  return axes;
}

std::vector<std::string> absent_renderers(std::span<const SweepAxis> axes) {
  if (sweep_text(axes) != renderer_sweep) return {};
  std::vector<std::string> absent;
  for (const RendererKind& kind : renderer_kinds())
    if (const auto reason = why_not_here(kind); reason && draws_any_scene(kind))
      absent.push_back(fmt::format("{}: {}", kind.label, reason->text()));
  if (!driver_renderer())
    absent.emplace_back("graphics driver: this program was built without a renderer that uses it");
  return absent;
}

}  // namespace ps
