#include "study/renderer_sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "options/renderer_kind.h"
#include "scene/scene.h"
#include "study/stability/added_renderer.h"

namespace ps {
namespace {

std::optional<std::string_view> why_not_here(const RendererKind& kind) {
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
      absent.push_back(fmt::format("{}: {}", kind.label, *reason));
  const auto all = renderer_kinds();
  const std::string_view key = stability::hardware_renderer_key;
  if (std::none_of(all.begin(), all.end(), [&](const RendererKind& kind) { return kind.key == key; }))
    absent.push_back(fmt::format("{0}: this program was built without the {0} renderer", key));
  return absent;
}

}  // namespace ps
