#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include "study/model/model_search.h"

namespace ps::model {
namespace {

struct LightLoss {
  std::size_t light = 0;
  double increase = 0;  ///< of small pictures, where it alone is gone
  std::uint64_t work = 0;
};

std::string light_name(const Scene& scene, std::size_t light) {
  return fmt::format("light {} ({})", light, light_kind_key((*scene.lights)[light].kind));
}

}  // namespace

// How much each is missed alone orders them. Together they are missed more, so that the least missed go first, as many
// as the tolerance allows.
void ModelSearch::weigh_lights() {
  const Scene before = scene();
  const std::size_t all = before.lights->size();
  const auto without = [&](const Candidates& gone) {
    Marks marks(all, 0);
    for (const std::size_t light : gone) marks[light] = 1;
    return without_lights(before, marks);
  };
  std::vector<LightLoss> losses;
  for (std::size_t i = 0; i < all; ++i) {
    const Scene less = without({i});
    const double increase = held_.small_change(less, settings()).increase;
    if (increase <= request_.tolerance) losses.push_back({i, increase, held_.work(less, settings())});
  }
  std::stable_sort(losses.begin(), losses.end(),
                   [](const LightLoss& a, const LightLoss& b) { return a.increase < b.increase; });
  while (!losses.empty()) {
    Candidates gone;
    for (const LightLoss& loss : losses) gone.push_back(loss.light);
    const bool missed = losses.back().increase > 0;
    if (holds(without(gone), settings(), missed ? Worth::lossy : Worth::unseen)) break;
    losses.pop_back();
  }
  if (losses.empty()) return;
  ModelSaving saving{.part = ModelPart::lights, .goes = part_of_all(losses.size(), all, "light", "lights")};
  std::sort(losses.begin(), losses.end(), [](const LightLoss& a, const LightLoss& b) { return a.light < b.light; });
  for (const LightLoss& loss : losses) {
    const double work = needs_.default_work > 0 ? (static_cast<double>(needs_.work) - static_cast<double>(loss.work)) /
                                                      static_cast<double>(needs_.default_work)
                                                : 0;
    saving.things.push_back({.name = light_name(before, loss.light),
                             .picture = static_cast<double>(evidence_.touched.lights[loss.light]) / evidence_.pixels,
                             .bytes = sizeof(Light),
                             .work = work,
                             .increase = loss.increase});
  }
  take(std::move(saving));
}

}  // namespace ps::model
