#include "study/model/model_sweep.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/check.h"
#include "base/enumerators.h"
#include "options/scene_settings.h"
#include "study/model/model_words.h"

namespace ps {

std::vector<SweepPoint> model_sweep(const ModelNeeds& needs, const Settings& base, const Settings& scene_start) {
  if (needs.savings.empty()) throw InputError(fmt::format("sweep {}: {}", model_sweep_key, model_sentence(needs)));
  const auto settings_text = [&](const Settings& settings) {
    return fmt::format("{}", fmt::join(settings_difference(scene_start, settings), ";"));
  };
  std::vector<SweepPoint> points{{"full", "Model: full", settings_text(base), base}};
  std::string gone;
  for (const ModelSaving& saving : needs.savings) {
    gone += fmt::format("{}{}", gone.empty() ? "" : ", ", enumerator_key(saving.part));
    points.push_back({fmt::format("reduced {}", gone), fmt::format("Model: reduced {}", gone),
                      settings_text(saving.settings), saving.settings, std::make_shared<const Scene>(saving.scene)});
  }
  return points;
}

ModelRequest model_request(const ChartRequest& chart) {
  ModelRequest model;
  model.scene = chart.scene;
  model.views = {chart.view};
  model.base = chart.base;
  model.priority = chart.priority;
  return model;
}

std::vector<SweepPoint> model_sweep(const ChartRequest& chart, const Settings& scene_start, StudyControl& control) {
  return model_sweep(find_model_needs(model_request(chart), control), chart.base, scene_start);
}

}  // namespace ps
