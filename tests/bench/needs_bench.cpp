// What following the advice saves on every built-in scene: the settings that study/needs.h finds beside the scene's
// own.

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <array>
#include <memory>
#include <string>

#include "bench/bench.h"
#include "options/scene_settings.h"
#include "scene/load.h"
#include "study/needs.h"
#include "study/same_machinery.h"

namespace ps::bench {
namespace {

struct AdvicePicture {
  Scene scene;
  Settings settings;
  Prepared prepared;  ///< trees are built once, outside the times

  View view() const { return {scene.camera, 320, 240}; }
  void render() {
    Progress progress;
    ps::render(scene, view(), settings, {}, prepared, progress);
  }
};

std::string advice_text(const Settings& base, const Settings& advice) {
  const std::vector<std::string> changes = settings_difference(base, advice);
  return changes.empty() ? "keep the settings" : fmt::format("{}", fmt::join(changes, " "));
}

Job needs_job(const std::string& name) {
  const auto before = std::make_shared<AdvicePicture>();
  before->scene = load_scene(name);
  before->settings = settings_for(before->scene);
  NeedsRequest request;
  request.scene = before->scene;
  request.view = before->view();
  request.base = before->settings;
  request.repeats = 1;  // the times are taken here
  StudyControl control;
  const Needs needs = find_needs(request, control);
  const auto after = std::make_shared<AdvicePicture>();
  after->scene = before->scene;
  after->settings = needs.advice;
  const std::array both{after->settings, before->settings};
  const std::array<std::string, 2> labels{"the advice", "the settings as they are"};
  const TimedSettings timed = on_same_machinery(both, labels, scene_traits(before->scene));
  const std::string advice = advice_text(before->settings, needs.advice);
  after->settings = timed.settings[0];
  before->settings = timed.settings[1];
  Job job;
  job.ours = [after] { after->render(); };
  job.yardstick = [before] { before->render(); };
  job.check = [needs]() -> std::string {
    if (needs.error <= needs.tolerance) return "";
    return fmt::format("the advice is off by {:.3f}, {:.3f} is allowed", needs.error, needs.tolerance);
  };
  job.note = fmt::format("{}; {}; error {:.3f} -> {:.3f}, work {:.3f} -> {:.3f} million", advice, timed.reason,
                         needs.default_error, needs.error, static_cast<double>(needs.default_work) * 1e-6,
                         static_cast<double>(needs.work) * 1e-6);
  return job;
}

}  // namespace

Benches needs_benches() {
  Benches benches;
  for (const BuiltinScene& scene : builtin_scenes())
    benches.push_back({"needs/" + scene.name, "ms", "as it is", [name = scene.name] { return needs_job(name); }});
  return benches;
}

}  // namespace ps::bench
