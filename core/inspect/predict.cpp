#include "inspect/predict.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <initializer_list>

#include "base/check.h"
#include "base/enumerators.h"
#include "inspect/guess_text.h"
#include "inspect/vertex_chain.h"
#include "options/renderer_kind.h"
#include "render/story/names.h"

namespace ps {
namespace {

constexpr int right_within = 4, wrong_beyond = 64;  // levels

std::string object_text(int object, const Scene& scene) {
  if (object < 0) return "the background";
  return fmt::format("'{}'", scene.geometry->objects.at(static_cast<std::size_t>(object)).name);
}

std::string levels_text(const std::array<int, 3>& c) { return fmt::format("{} {} {}", c[0], c[1], c[2]); }

Judgement judge_colour(const Guess& guess, const PixelStory& story) {
  int apart = 0;
  for (std::size_t i = 0; i < 3; ++i) apart = std::max(apart, std::abs(guess.colour[i] - story.display[i]));
  Judgement judgement;
  judgement.points =
      std::clamp(1.0 - static_cast<double>(apart - right_within) / (wrong_beyond - right_within), 0.0, 1.0);
  judgement.sentence = apart == 0 ? fmt::format("Right: {}.", levels_text(story.display))
                                  : fmt::format("It is {}; you said {}, {} level{} off.", levels_text(story.display),
                                                levels_text(guess.colour), apart, apart == 1 ? "" : "s");
  return judgement;
}

}  // namespace

std::string_view question_key(Question question) { return enumerator_key(question); }

Question parse_question(std::string_view text) {
  if (const auto question = enumerator_named<Question>(text)) return *question;
  throw InputError(fmt::format("found '{}', expected one of {}", text, fmt::join(enumerator_keys<Question>, " ")));
}

namespace {

/// nullopt if the renderer does not count all of these.
std::optional<std::uint64_t> sum_of(const PixelStory& story, std::initializer_list<Counter> counters) {
  std::uint64_t sum = 0;
  for (const Counter counter : counters) {
    const auto count = story.counters.get(counter);
    if (!count) return {};
    sum += *count;
  }
  return sum;
}

std::optional<std::uint64_t> counted_rays(const PixelStory& story) {
  return sum_of(story, {Counter::eye_rays, Counter::shadow_rays, Counter::reflection_rays, Counter::refraction_rays});
}

std::optional<std::uint64_t> counted_tests(const PixelStory& story) {
  return sum_of(story, {Counter::sphere_tests, Counter::triangle_tests, Counter::solid_tests});
}

Judgement judge_tests(const Guess& guess, const PixelStory& story) {
  const int tests = tests_of(story), apart = std::abs(guess.tests - tests);
  const auto plural = [](int count) { return fmt::format("{} test{}", count, count == 1 ? "" : "s"); };
  if (apart == 0) return {1, fmt::format("Right: {}.", plural(tests))};
  const bool close = apart <= tests / 20, near = guess.tests <= 2 * tests && 2 * guess.tests >= tests;
  return {close ? 1.0 : near ? 0.5 : 0.0, fmt::format("It is {}; you said {}.", plural(tests), plural(guess.tests))};
}

}  // namespace

std::optional<std::string_view> not_askable(Question question, const PixelStory& story) {
  if (question == Question::rays && !sends_rays(story.renderer))
    return "Only the ray tracer sends rays; ask for the colour or the winner here.";
  if (question == Question::rays && !counted_rays(story))
    return "This renderer does not count its rays; ask for the colour or the winner here.";
  if (question == Question::tests && (!sends_rays(story.renderer) || !counted_tests(story)))
    return "Only the ray tracer tests rays against objects; ask for the colour or the winner here.";
  if ((question == Question::winner || question == Question::triangle) && runs_listing(story.renderer))
    return "A listing reports no winner; ask for the colour here.";
  return {};
}

std::vector<PixelId> askable_triangles(const Scene& scene) {
  constexpr std::size_t most = 24;
  std::vector<PixelId> all;
  const auto& objects = scene.geometry->objects;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const auto* instance = std::get_if<Instance>(&objects[i].shape);
    if (!instance) continue;
    const std::size_t count = scene.geometry->meshes.at(instance->mesh)->triangles.size();
    if (all.size() + count > most) return {};
    for (std::size_t t = 0; t < count; ++t) all.push_back({static_cast<int>(i), static_cast<int>(t)});
  }
  return all;
}

int winner_of(const PixelStory& story) { return shown_triangle(story).object; }

int rays_of(const PixelStory& story) {
  const auto rays = counted_rays(story);
  PS_ASSERT(rays, "asked only where not_askable() has no objection");
  return static_cast<int>(*rays);
}

int tests_of(const PixelStory& story) {
  const auto tests = counted_tests(story);
  PS_ASSERT(tests, "asked only where not_askable() has no objection");
  return static_cast<int>(*tests);
}

std::string guess_text(Question question, const Guess& guess, const Scene& scene) {
  switch (question) {
  case Question::colour:
    return fmt::format("{} {} {}", guess.colour[0], guess.colour[1], guess.colour[2]);
  case Question::winner:
    return object_text(guess.object, scene);
  case Question::triangle:
    return guess.object < 0 ? object_text(-1, scene) : primitive_name(scene, {guess.object, guess.triangle});
  case Question::rays:
    return fmt::format("{}", guess.rays);
  case Question::tests:
    return fmt::format("{}", guess.tests);
  }
  return {};
}

Judgement judge(Question question, const Guess& guess, const PixelStory& story, const Scene& scene) {
  switch (question) {
  case Question::colour:
    return judge_colour(guess, story);
  case Question::winner: {
    const int winner = winner_of(story);
    const bool right = guess.object == winner;
    return {right ? 1.0 : 0.0, right ? fmt::format("Right: {}.", object_text(winner, scene))
                                     : fmt::format("It is {}; you said {}.", object_text(winner, scene),
                                                   object_text(guess.object, scene))};
  }
  case Question::triangle: {
    const PixelId shown = shown_triangle(story), said{guess.object, guess.triangle};
    const auto words = [&](const PixelId& id) {
      return id.object < 0 ? std::string("the background") : primitive_name(scene, id);
    };
    const bool right = said == shown;
    return {right ? 1.0 : 0.0, right ? fmt::format("Right: {}.", words(shown))
                                     : fmt::format("It is {}; you said {}.", words(shown), words(said))};
  }
  case Question::tests:
    return judge_tests(guess, story);
  case Question::rays: {
    const int rays = rays_of(story), apart = std::abs(guess.rays - rays);
    const auto plural = [](int count) { return fmt::format("{} ray{}", count, count == 1 ? "" : "s"); };
    return {apart == 0   ? 1.0
            : apart == 1 ? 0.5
                         : 0.0,
            apart == 0 ? fmt::format("Right: {}.", plural(rays))
                       : fmt::format("It is {}; you said {}.", plural(rays), plural(guess.rays))};
  }
  }
  return {};
}

}  // namespace ps
