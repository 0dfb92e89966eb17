#include "gui/panels/pictures/picture_text.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>
#include <vector>

#include "base/number_text.h"
#include "options/difference_words.h"
#include "options/option.h"
#include "options/renderer_kind.h"

namespace ps::gui {
namespace {

std::string label_of(std::string_view key, const Settings& settings) {
  const Option* option = find_option(key);
  if (!option) return {};
  return std::string(chosen(*option, settings).label);
}

/// The value of an option in a word, or what a picture is without; numbers with four digits, unless `other` then looks
/// the same but is not.
std::string value_word(const Option& option, const Settings& settings, const Settings* other) {
  if (option.kind == OptionKind::boolean || is_without(option, settings)) return setting_words(option, settings);
  if (option.kind == OptionKind::choice) return std::string(chosen(option, settings).label);
  if (option.kind != OptionKind::real) return option_text(option, settings);
  const auto four_digits = [&](const Settings& of) { return fmt::format("{:.4g}", option.get(of)); };
  const bool differs = other && option.get(settings) != option.get(*other);
  return differs && four_digits(settings) == four_digits(*other) ? option_text(option, settings)
                                                                 : four_digits(settings);
}

/// One part of a title.
struct TitlePart {
  std::string text;
  bool differs = false;    ///< from the other picture
  std::string brief = {};  ///< the value alone; empty = the text
};

/// "shading: flat", "exposure 0.3333"
std::string title_words(const Option& option, const Settings& settings, const std::string& value) {
  if (option.kind != OptionKind::real) return setting_words(option, settings);
  std::string words = setting_words(option, settings);
  return words.substr(0, words.rfind(' ') + 1) + value;
}

std::vector<TitlePart> title_parts(const Settings& settings, const SceneTraits& traits, const Settings* other) {
  const auto differs = [&](const Option& option) { return other && option.get(settings) != option.get(*other); };
  const auto key_differs = [&](std::string_view key) {
    const Option* option = find_option(key);
    return option && differs(*option);
  };
  const bool other_renderer = key_differs("renderer");
  const bool bug_alone = key_differs("listing-bug") && !other_renderer && !key_differs("listing");
  std::vector<TitlePart> parts{{label_of("renderer", settings), other_renderer}};
  switch (picture_way(settings.renderer)) {
  case PictureWay::rays: {
    const bool other_depth = key_differs("reflection-depth");
    const int depth = settings.reflection_depth;
    if (traits.reflective && (depth > 0 || (other_depth && !other_renderer)))
      parts.push_back(
          {depth == 0 ? "without reflections" : fmt::format("{} reflection{}", depth, depth == 1 ? "" : "s"),
           other_renderer || other_depth});
    break;
  }
  case PictureWay::fragments:
    if (fills(settings.draw) && settings.lighting)
      parts.push_back({label_of("shading", settings), other_renderer || key_differs("shading")});
    break;
  case PictureWay::listing:
    // Beside the listing itself a copy with a bug needs no more words, and the bug's name would help to find it.
    if (bug_alone) {
      parts.front() = {settings.listing_bug > 0 ? "one changed line" : "the listing", true};
      break;
    }
    if (settings.listing > 0 || (key_differs("listing") && !other_renderer)) {
      parts.front().text += " " + label_of("listing", settings);
      parts.front().differs = other_renderer || key_differs("listing");
    }
    break;
  }
  for (const auto& option : option_table()) {
    if (option.key == "renderer" || option.key == "listing" || option.key == "reflection-depth" ||
        option.key == "shading" || (bug_alone && option.key == "listing-bug"))
      continue;
    const bool is_default = option.get(settings) == option.default_value();
    if ((is_default && !differs(option)) || inactive_reason(option, settings, traits)) continue;
    const std::string value = value_word(option, settings, other);
    parts.push_back({title_words(option, settings, value), differs(option), value});
  }
  return parts;
}

}  // namespace

std::string count_text(std::uint64_t count) {
  if (count >= 100'000) {
    const double value = static_cast<double>(count);
    if (count >= 1'000'000'000) return fmt::format("{:.3g} G", value / 1e9);
    return fmt::format("{:.3g} M", value / 1e6);
  }
  return with_thousands(std::to_string(count));
}

std::string three_digits(double value) { return fmt::format("{:.{}f}", value, value >= 100 ? 0 : value >= 10 ? 1 : 2); }

std::string two_digits(double value) {
  if (value < 10) return fmt::format("{:.2g}", value);
  const double place = std::pow(10, std::floor(std::log10(value)) - 1);
  return fmt::format("{:.0f}", std::round(value / place) * place);
}

PictureTitle picture_title_words(const Settings& settings, const SceneTraits& traits, const Settings* other) {
  PictureTitle title;
  const auto add = [](std::string& text, const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
  for (const TitlePart& part : title_parts(settings, traits, other)) {
    add(part.differs ? title.differing : title.shared, part.text);
    if (part.differs) add(title.brief, part.brief.empty() ? part.text : part.brief);
  }
  if (title.differing.empty()) title.differing = title.brief = std::exchange(title.shared, {});
  return title;
}

std::string PictureTitle::text() const { return differing + (shared.empty() ? "" : " · ") + shared; }

std::string state_text(const RenderStatus& status, const RenderResult* result) {
  switch (status.state) {
  case RenderState::failed:
    return "not rendered: " + status.message;
  case RenderState::cancelled:
    return "cancelled; any change renders again";
  case RenderState::idle:
  case RenderState::coarse:
  case RenderState::full:
  case RenderState::done:
    break;
  }
  return result ? "" : "rendering";
}

std::string counters_text(const RenderResult& result) {
  std::string text;
  for (std::size_t i = 0; i < counter_count; ++i) {
    const auto counter = static_cast<Counter>(i);
    if (const auto value = result.frame.counters.get(counter); value.value_or(0) > 0)
      text += fmt::format("{}{} {}", text.empty() ? "" : "\n", *value, counter_label(counter));
  }
  return text;
}

}  // namespace ps::gui
