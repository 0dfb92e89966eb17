#include "inspect/predict.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <initializer_list>

#include "base/check.h"
#include "base/enumerators.h"
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

std::string triangle_text(const PixelId& id, const Scene& scene) {
  return id.object < 0 ? object_text(id.object, scene) : primitive_name(scene, id);
}

std::string counted_text(int count, std::string_view what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

double points_of_colour(int apart) {
  return std::clamp(1.0 - static_cast<double>(apart - right_within) / (wrong_beyond - right_within), 0.0, 1.0);
}

double points_of_tests(int said, int tests) {
  const bool close = std::abs(said - tests) <= tests / 20, near = said <= 2 * tests && 2 * said >= tests;
  return close ? 1.0 : near ? 0.5 : 0.0;
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
    return levels_text(guess.colour);
  case Question::winner:
    return object_text(guess.object, scene);
  case Question::triangle:
    return triangle_text({guess.object, guess.triangle}, scene);
  case Question::rays:
    return counted_text(guess.rays, "ray");
  case Question::tests:
    return counted_text(guess.tests, "test");
  }
  return {};
}

Guess right_guess(Question question, const PixelStory& story) {
  Guess right;
  switch (question) {
  case Question::colour:
    right.colour = story.display;
    break;
  case Question::winner:
    right.object = winner_of(story);
    break;
  case Question::triangle:
    right.object = shown_triangle(story).object;
    right.triangle = shown_triangle(story).triangle;
    break;
  case Question::rays:
    right.rays = rays_of(story);
    break;
  case Question::tests:
    right.tests = tests_of(story);
    break;
  }
  return right;
}

std::string right_answer_text(Question question, const PixelStory& story, const Scene& scene) {
  return fmt::format("It is {}", guess_text(question, right_guess(question, story), scene));
}

Judgement judge(Question question, const Guess& guess, const PixelStory& story, const Scene& scene) {
  const Guess right = right_guess(question, story);
  int apart = 0;  // by how much the guess is wrong; 0 if it is right
  double points = 0;
  std::string off;
  switch (question) {
  case Question::colour:
    for (std::size_t i = 0; i < 3; ++i) apart = std::max(apart, std::abs(guess.colour[i] - right.colour[i]));
    points = points_of_colour(apart);
    off = ", " + counted_text(apart, "level") + " off";
    break;
  case Question::winner:
    apart = guess.object == right.object ? 0 : 1;
    points = 1 - apart;
    break;
  case Question::triangle:
    apart = guess.object == right.object && guess.triangle == right.triangle ? 0 : 1;
    points = 1 - apart;
    break;
  case Question::rays:
    apart = std::abs(guess.rays - right.rays);
    points = apart == 0 ? 1.0 : apart == 1 ? 0.5 : 0.0;
    break;
  case Question::tests:
    apart = std::abs(guess.tests - right.tests);
    points = points_of_tests(guess.tests, right.tests);
    break;
  }
  if (apart == 0) return {points, fmt::format("Right: {}.", guess_text(question, right, scene))};
  return {points, fmt::format("{}; you said {}{}.", right_answer_text(question, story, scene),
                              guess_text(question, guess, scene), off)};
}

}  // namespace ps
