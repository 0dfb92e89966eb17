#include <fmt/format.h>

#include "scene/scene_draft.h"

namespace ps {
namespace {

void charge(const SceneSource& source, const SceneEntry& entry, std::size_t count, std::size_t& sum, std::size_t most,
            std::string_view what) {
  sum += count;
  if (sum > most)
    source.values.fail_at(entry.line, entry.column, fmt::format("{} {} by '{}'", sum, what, entry.key),
                          fmt::format("at most {} in a scene", most));
}

}  // namespace

void charge_triangles(const SceneSource& source, const SceneEntry& entry, std::size_t count, SceneDraft& draft) {
  charge(source, entry, count, draft.triangles, max_scene_triangles, "triangles");
}

void charge_texels(const SceneSource& source, const SceneEntry& entry, std::size_t count, SceneDraft& draft) {
  charge(source, entry, count, draft.texels, max_scene_texels, "texels");
}

}  // namespace ps
