#include <algorithm>

#include <fmt/format.h>

#include "study/model/model_search.h"

namespace ps::model {
namespace {

constexpr double most_pixels = 64;      ///< of a small object: a quarter of a tile, by which changes are judged
constexpr double most_share = 0.002;    ///< of the pixels of all views; in a tiny picture each pixel is much
constexpr std::size_t most_tried = 16;  ///< objects that are left out one by one

struct ObjectLoss {
  std::size_t object = 0;
  double share = 0;     ///< of the pixels of all views
  double increase = 0;  ///< where it alone is gone
};

}  // namespace

// Each is left out alone, and drawn; then as many together as the tolerance allows, the least missed first.
void ModelSearch::weigh_small_objects() {
  const Scene before = scene();
  const std::size_t all = before.geometry->objects.size();
  const auto without = [&](const Candidates& gone) {
    Marks marks(all, 0);
    for (const std::size_t object : gone) marks[object] = 1;
    return without_objects(before, marks);
  };
  Candidates small;
  for (std::size_t i = 0; i < all; ++i) {
    const auto pixels = static_cast<double>(evidence_.touched.objects[i].seen);
    if (pixels > 0 && pixels <= std::min(most_pixels, most_share * evidence_.pixels)) small.push_back(i);
  }
  std::stable_sort(small.begin(), small.end(), [&](std::size_t a, std::size_t b) {
    return evidence_.touched.objects[a].seen < evidence_.touched.objects[b].seen;
  });
  small.resize(std::min(small.size(), most_tried));
  // Together they would not be worth it: none needs to be drawn.
  if (small.empty() ||
      !is_worth_it(Worth::lossy, needs_, held_.work(without(small), settings()), model_bytes(without(small))))
    return;
  std::vector<ObjectLoss> losses;
  for (const std::size_t object : small) {
    const double increase = held_.change(without({object}), settings(), request_.tolerance).increase;
    if (increase > request_.tolerance) continue;
    const auto seen = static_cast<double>(evidence_.touched.objects[object].seen);
    losses.push_back({object, seen / evidence_.pixels, increase});
  }
  std::stable_sort(losses.begin(), losses.end(),
                   [](const ObjectLoss& a, const ObjectLoss& b) { return a.increase < b.increase; });
  const auto indices = [&] {
    Candidates gone;
    for (const ObjectLoss& loss : losses) gone.push_back(loss.object);
    return gone;
  };
  while (!losses.empty() && !holds(without(indices()), settings(), Worth::lossy)) losses.pop_back();
  if (losses.empty()) return;
  ModelSaving saving{.part = ModelPart::small_objects,
                     .goes =
                         fmt::format("{} small object{}", number_word(losses.size()), losses.size() == 1 ? "" : "s")};
  for (const ObjectLoss& loss : losses)
    saving.things.push_back({.name = object_name(before, loss.object),
                             .picture = loss.share,
                             .bytes = model_bytes(before) - model_bytes(without({loss.object})),
                             .increase = loss.increase});
  take(std::move(saving));
  forget(before, indices());
}

}  // namespace ps::model
