#include "render/left_out.h"

#include <fmt/format.h>

#include "base/sentence.h"
#include "render/renderer_table.h"

namespace ps {

std::vector<LeftOut> left_out(const SceneTraits& traits, const Settings& settings) {
  return renderer_row(settings.renderer).left_out(traits, settings);
}

std::vector<std::string> briefs_together(const std::vector<std::string>& briefs) {
  constexpr std::string_view lead = "leaves out ";
  std::vector<std::string> left, texts;
  for (const std::string& brief : briefs)
    (brief.starts_with(lead) ? left : texts).push_back(brief.starts_with(lead) ? brief.substr(lead.size()) : brief);
  if (!left.empty()) texts.insert(texts.begin(), std::string(lead) + listed(left));
  return texts;
}

bool leaves_out_all(const SceneTraits& traits, const Settings& settings) {
  const bool has_objects = traits.spheres || traits.triangles || traits.solids || traits.csg || traits.canvas_items;
  return has_objects && !renderer_row(settings.renderer).shows_objects(traits, settings);
}

std::string left_out_words(const SceneTraits& traits, const Settings& settings) {
  const RendererRow& row = renderer_row(settings.renderer);
  std::vector<std::string> briefs;
  for (const LeftOut& one : row.left_out(traits, settings)) briefs.push_back(one.brief);
  if (briefs.empty()) return {};
  return fmt::format("; {} {}", row.subject(traits, settings), fmt::join(briefs_together(briefs), ", and "));
}

}  // namespace ps
