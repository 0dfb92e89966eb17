#include "engine/check_figures.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "engine/figure.h"
#include "render/render.h"

namespace ps {
namespace {

constexpr double tolerance = 0.005, least_tolerance = 0.0005;

PixelStory own_story(const Lesson& lesson, int step, Progress& progress) {
  const Document document = lesson_document(lesson, step, Document{});
  Prepared prepared;
  return inspect(document.scene, view_of(document), side_of(document, document.picked).settings, document.pixel,
                 prepared, progress);
}

/// Empty where the lesson has the number of the story.
std::string fault_of(const FigureNumber& number, const PixelStory& story) {
  const auto fault = [&](const std::string& found, const std::string& expected) {
    return std::string(InputError(number.place, found, expected).what());
  };
  const auto value = number_at(number, story);
  if (!value)
    return fault(fmt::format("'{}'", number.name),
                 "a number that the step's own pixel has: no " + field_query_words(number.query));
  if (std::abs(*value - number.own) <= tolerance * std::abs(*value) + least_tolerance) return {};
  return fault(fmt::format("'{}' = {}", number.name, number.own),
               fmt::format("{:.4g}, as at the step's own pixel", *value));
}

}  // namespace

std::vector<std::string> figure_faults(const Lesson& lesson, int step, Progress& progress) {
  std::vector<std::string> faults;
  std::optional<PixelStory> story;
  std::vector<TextBlock> blocks = lesson.steps[static_cast<std::size_t>(step)].blocks;
  if (step == 0) blocks.insert(blocks.begin(), lesson.blocks.begin(), lesson.blocks.end());  // it shows these too
  for (const TextBlock& block : blocks) {
    if (!block.figure) continue;
    for (const FigureNumber& number : block.figure->of_pixel) {
      if (!story) story = own_story(lesson, step, progress);
      if (std::string fault = fault_of(number, *story); !fault.empty()) faults.push_back(std::move(fault));
    }
  }
  return faults;
}

}  // namespace ps
