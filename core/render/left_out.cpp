#include "render/left_out.h"

#include <fmt/format.h>

#include "base/sentence.h"
#include "render/renderer_table.h"

namespace ps {

std::vector<LeftOut> left_out(const SceneTraits& traits, const Settings& settings) {
  return renderer_row(settings.renderer).left_out(traits, settings);
}

std::vector<std::string> briefs_together(const std::vector<LeftOutBrief>& briefs) {
  std::vector<std::string> left, texts;
  for (const LeftOutBrief& brief : briefs) (brief.verb == BriefVerb::leaves_out ? left : texts).push_back(brief.words);
  if (!left.empty()) texts.insert(texts.begin(), brief_text({BriefVerb::leaves_out, listed(left)}));
  return texts;
}

bool leaves_out_all(const SceneTraits& traits, const Settings& settings) {
  const bool has_objects = traits.spheres || traits.triangles || traits.solids || traits.csg || traits.canvas_items;
  return has_objects && !renderer_row(settings.renderer).shows_objects(traits, settings);
}

std::string left_out_words(const SceneTraits& traits, const Settings& settings) {
  const RendererRow& row = renderer_row(settings.renderer);
  std::vector<LeftOutBrief> briefs;
  for (const LeftOut& one : row.left_out(traits, settings)) briefs.push_back(one.brief);
  if (briefs.empty()) return {};
  return fmt::format("; {} {}", row.subject(traits, settings), fmt::join(briefs_together(briefs), ", and "));
}

}  // namespace ps
