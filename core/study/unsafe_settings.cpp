#include "study/unsafe_settings.h"

#include <algorithm>
#include <cmath>

#include "frame/display_frame.h"
#include "image/difference.h"
#include "options/option.h"

namespace ps {
namespace {

Settings made_safe(Settings settings, std::string_view assignments) {
  parse_assignments(assignments, settings);
  return settings;
}

bool differ(Rgb8 a, Rgb8 b) {
  constexpr int visible = 8;
  return largest_difference(a, b) > visible;
}

View reduced(View view, int side) {
  const int longer = std::max(view.width, view.height);
  if (longer <= side) return view;
  view.width = std::max(1, view.width * side / longer);
  view.height = std::max(1, view.height * side / longer);
  return view;
}

}  // namespace

std::vector<UnsafeSetting> unsafe_settings(const Scene& scene, const View& view, const Settings& settings,
                                           Progress& progress, const UnsafeOptions& options) {
  const SceneTraits traits = scene_traits(scene);
  const View small = reduced(view, options.side);
  Prepared prepared;
  RenderRequest request;
  request.priority = options.priority;
  const auto picture = [&](const Settings& s) {
    return display_frame(render(scene, small, s, request, prepared, progress), s);
  };
  const auto measured = [&](const OptionExperiment& experiment) {
    const Settings probed = made_safe(settings, experiment.probe);
    const Settings safe = made_safe(probed, experiment.safe);
    Settings exact = safe;
    exact.precision = Precision::float64;
    const Image<Rgb8> shown = picture(probed), same = picture(safe), truth = picture(exact);
    double bad = 0;
    for (std::size_t i = 0; i < shown.pixels().size(); ++i)
      bad += differ(shown.pixels()[i], truth.pixels()[i]) && !differ(same.pixels()[i], truth.pixels()[i]) ? 1 : 0;
    return 100 * bad / static_cast<double>(shown.pixels().size());
  };
  std::vector<UnsafeSetting> found;
  for (const Option& option : option_table())
    for (const OptionExperiment& experiment : option.shown_by.experiments.list) {
      if (!experiment.unsafe || !experiment.unsafe(settings) || inactive_reason(option, settings, traits)) continue;
      const double bad_percent = options.only_known ? 0 : measured(experiment);
      found.push_back(
          {experiment.key, option.key, option_text(option, settings), std::string(experiment.safe), bad_percent});
    }
  std::stable_sort(found.begin(), found.end(),
                   [](const UnsafeSetting& a, const UnsafeSetting& b) { return a.bad_percent > b.bad_percent; });
  return found;
}

}  // namespace ps
