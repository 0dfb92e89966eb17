#include "study/model/model_search.h"

#include <array>

#include <fmt/format.h>

namespace ps::model {
namespace {

double saved_share(std::uint64_t before, std::uint64_t after, std::uint64_t whole) {
  return whole > 0 ? (static_cast<double>(before) - static_cast<double>(after)) / static_cast<double>(whole) : 0;
}

bool saves(double part, std::uint64_t before, std::uint64_t after) {
  return static_cast<double>(after) <= (1 - part) * static_cast<double>(before);
}

}  // namespace

bool is_worth_it(Worth worth, const ModelNeeds& now, std::uint64_t work, std::uint64_t bytes) {
  constexpr double noise = 0.01;
  const auto either = [&](double part) { return saves(part, now.work, work) || saves(part, now.bytes, bytes); };
  switch (worth) {
  case Worth::unseen:
  case Worth::uncounted:
    return true;
  case Worth::unchanged:
    return either(noise) && saves(-noise, now.work, work);
  case Worth::lossy:
    return either(least_saving) && saves(-noise, now.work, work);
  case Worth::halved:
    return saves(0.5, now.work, work);
  }
  return false;
}

ModelSearch::ModelSearch(const ModelRequest& request, StudyControl& control)
    : request_(request), control_(control),
      held_(request.scene, request.views, request.base, control, request.priority),
      evidence_(gather_evidence(request.scene, request.views, HeldPictures::by_rays(request.base),
                                HeldPictures::by_fragments(request.base), control, request.priority)) {
  needs_.tolerance = request.tolerance;
  needs_.views = request.views.size();
  needs_.objects = request.scene.geometry->objects.size();
  needs_.lights = request.scene.lights->size();
  needs_.scene = request.scene;
  needs_.settings = request.base;
  needs_.work = needs_.default_work = held_.work(request.scene, request.base);
  needs_.bytes = needs_.default_bytes = model_bytes(request.scene);
}

bool ModelSearch::holds(const Scene& scene, const Settings& settings, Worth worth) {
  Held tried{scene, settings, {}, held_.work(scene, settings), model_bytes(scene)};
  if (!is_worth_it(worth, needs_, tried.work, tried.bytes)) return false;
  tried.change = held_.change(scene, settings, request_.tolerance);
  needs_.pictures = held_.rendered();
  if (tried.change.increase > request_.tolerance) return false;
  last_ = std::move(tried);
  return true;
}

void ModelSearch::take(ModelSaving saving) {
  saving.work = saved_share(needs_.work, last_.work, needs_.default_work);
  saving.bytes = saved_share(needs_.bytes, last_.bytes, needs_.default_bytes);
  saving.change = last_.change;
  saving.scene = needs_.scene = last_.scene;
  saving.settings = needs_.settings = last_.settings;
  needs_.work = last_.work;
  needs_.bytes = last_.bytes;
  needs_.change = last_.change;
  needs_.savings.push_back(std::move(saving));
}

void ModelSearch::halve(const Candidates& candidates, Worth worth,
                        const std::function<Scene(const Candidates&)>& reduced, Candidates& held) {
  if (candidates.empty()) return;
  Candidates with = held;
  with.insert(with.end(), candidates.begin(), candidates.end());
  if (holds(reduced(with), settings(), worth)) {
    held = std::move(with);
    return;
  }
  if (candidates.size() == 1) return;
  const auto middle = candidates.begin() + static_cast<std::ptrdiff_t>(candidates.size() / 2);
  halve({candidates.begin(), middle}, worth, reduced, held);
  halve({middle, candidates.end()}, worth, reduced, held);
}

Candidates ModelSearch::hold_together(const Candidates& candidates, Worth worth,
                                      const std::function<Scene(const Candidates&)>& reduced) {
  Candidates held;
  halve(candidates, worth, reduced, held);
  return held;
}

std::string object_name(const Scene& scene, std::size_t object) {
  const std::string& name = scene.geometry->objects[object].name;
  return name.empty() ? fmt::format("object {}", object) : fmt::format("object '{}'", name);
}

std::string number_word(std::size_t number) {
  constexpr std::array words{"no",    "one",   "two",  "three", "four",   "five",  "six",
                             "seven", "eight", "nine", "ten",   "eleven", "twelve"};
  return number < words.size() ? words[number] : fmt::format("{}", number);
}

std::string part_of_all(std::size_t some, std::size_t all, std::string_view one, std::string_view many) {
  if (some == all && all == 1) return fmt::format("the {}", one);
  if (some == all && all == 2) return fmt::format("both {}", many);
  if (some == all) return fmt::format("all {} {}", number_word(all), many);
  return fmt::format("{} of {} {}", number_word(some), number_word(all), many);
}

}  // namespace ps::model

namespace ps {

ModelNeeds find_model_needs(const ModelRequest& request, StudyControl& control,
                            const std::function<void(const StudyStatus&)>& update) {
  using model::ModelSearch;
  constexpr std::array weighed{
      &ModelSearch::weigh_objects,       &ModelSearch::weigh_shapes,   &ModelSearch::weigh_triangles,
      &ModelSearch::weigh_small_objects, &ModelSearch::weigh_textures, &ModelSearch::weigh_detail,
      &ModelSearch::weigh_lights,        &ModelSearch::weigh_settings, &ModelSearch::weigh_depth_buffer};
  ModelSearch search(request, control);
  StudyStatus status{0, static_cast<int>(weighed.size())};
  for (const auto& weigh : weighed) {
    if (update) update(status);
    (search.*weigh)();
    ++status.done;
  }
  return std::move(search.needs());
}

model::Change check_reduction(const ModelRequest& request, const Scene& reduced, const Settings& settings,
                              StudyControl& control) {
  model::HeldPictures held(request.scene, request.views, request.base, control, request.priority);
  model::Change change = held.change(reduced, settings, request.tolerance);
  if (change.increase <= request.tolerance || reduced.textures->empty()) return change;
  held.allow_means();
  return held.change(reduced, settings);
}

}  // namespace ps
