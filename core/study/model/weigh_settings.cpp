#include <array>

#include <fmt/format.h>

#include "options/option.h"
#include "study/model/model_search.h"

namespace ps::model {
namespace {

constexpr double visibly_wrong = 0.001;        ///< share of the pixels; fewer are rounding at edges
constexpr std::size_t most_without_tree = 64;  ///< primitives: to test all of more never pays

std::size_t primitives_of(const Scene& scene) {
  std::size_t count = 0;
  for (const Object& object : scene.geometry->objects) {
    const auto* instance = std::get_if<Instance>(&object.shape);
    count += instance ? scene.geometry->meshes[instance->mesh]->triangles.size() : 1;
  }
  return count;
}

/// An option whose cheapest value that holds is looked for.
struct WeighedOption {
  ModelPart part{};
  std::string_view key;
  std::vector<std::string_view> values;  ///< the cheapest first; only those before the present one are tried
  Worth worth = Worth::lossy;
};

const std::array<WeighedOption, 5>& weighed_options() {
  static const std::array<WeighedOption, 5> all{{
      {ModelPart::reflection_depth, "reflection-depth", {"0", "1", "2", "3", "4", "5", "6", "8", "12"}},
      {ModelPart::samples, "samples-per-pixel", {"1", "4", "16", "64"}},
      {ModelPart::precision, "precision", {"float"}, Worth::uncounted},
      {ModelPart::tessellation, "tessellation", {"4", "2", "1"}},
      {ModelPart::accelerator, "accelerator", {"none"}, Worth::halved},
  }};
  return all;
}

/// ModelSaving::goes.
std::string gone_words(ModelPart part, const Settings& now, const Settings& then) {
  const auto of = [](int fewer, int all, std::string_view one, std::string_view many) {
    return part_of_all(static_cast<std::size_t>(all - fewer), static_cast<std::size_t>(all), one, many);
  };
  if (part == ModelPart::reflection_depth) return of(then.reflection_depth, now.reflection_depth, "bounce", "bounces");
  if (part == ModelPart::samples) return of(then.samples_per_pixel, now.samples_per_pixel, "sample", "samples");
  if (part == ModelPart::precision) return "double precision";
  if (part == ModelPart::tessellation) return fmt::format("tessellation finer than {} px", then.tessellation);
  return "the accelerator";
}

}  // namespace

void ModelSearch::weigh_settings() {
  for (const WeighedOption& weighed : weighed_options()) {
    const Option& option = *find_option(weighed.key);
    if (inactive_reason(option, settings(), scene_traits(scene()))) continue;
    if (weighed.part == ModelPart::accelerator && primitives_of(scene()) > most_without_tree) continue;
    const std::string now = option_text(option, settings());
    for (const std::string_view value : weighed.values) {
      Settings cheaper = settings();
      parse_option(option, value, cheaper);
      const bool is_less = option.kind == OptionKind::choice ? value != now
                                                             : (weighed.part == ModelPart::tessellation) ==
                                                                   (option.get(cheaper) > option.get(settings()));
      if (!is_less || option.get(cheaper) == option.get(settings())) continue;
      if (!holds(scene(), cheaper, weighed.worth)) continue;
      ModelSaving saving{.part = weighed.part, .goes = gone_words(weighed.part, settings(), cheaper)};
      saving.things.push_back({.name = fmt::format("{}: {} does for {}", option.label, value, now)});
      take(std::move(saving));
      break;
    }
  }
  if (request_.base.precision == Precision::float64) return;  // it was drawn in float above
  if (const double wrong = held_.wrong_in_float(scene(), settings()); wrong >= visibly_wrong)
    needs_.remarks.push_back(fmt::format(
        "Numbers and depths are hardly exact enough: in {:.1f} % of the pixels double shows another surface.",
        100 * wrong));
}

}  // namespace ps::model
