#include "study/sweep.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/check.h"
#include "base/number_text.h"
#include "options/renderer_kind.h"
#include "options/scene_settings.h"
#include "study/renderer_sweep.h"

namespace ps {
namespace {

constexpr int most_standard_values = 8;
constexpr std::size_t most_points = 100000;
constexpr const char* no_axes = "none";  // as text

std::string canonical(const Option& option, std::string_view text) {
  Settings settings;
  parse_option(option, text, settings);
  return option_text(option, settings);
}

/// The text of the nearest whole number or, for a real option, of the nearest one that four digits write: 1.5, where an
/// even division gives 1.5000000000000002.
std::string number_text(const Option& option, double value) {
  Settings settings;
  option.set(settings, option.kind == OptionKind::integer ? std::round(value)
                                                          : parse_number(fmt::format("{:.4g}", value)).value());
  return option_text(option, settings);
}

void add_new(std::vector<std::string>& values, std::string value) {
  if (std::find(values.begin(), values.end(), value) == values.end()) values.push_back(std::move(value));
}

/// Powers of two for whole numbers, powers of ten for others, thinned out evenly.
std::vector<std::string> spread(const Option& option) {
  std::vector<double> steps;
  if (option.minimum <= 0) steps.push_back(option.minimum);
  if (option.scale == OptionScale::linear && option.kind == OptionKind::real) {
    steps.clear();
    for (int i = 0; i < most_standard_values; ++i)
      steps.push_back(option.minimum + (option.maximum - option.minimum) * i / (most_standard_values - 1));
  } else if (option.kind == OptionKind::integer) {
    for (double v = std::max(1.0, option.minimum); v <= option.maximum && v < 2e9; v *= 2) steps.push_back(v);
  } else {
    const double smallest = option.minimum > 0 ? option.minimum : option.maximum * 1e-7;
    for (double v = smallest; v <= option.maximum * 1.0001; v *= 10) steps.push_back(std::min(v, option.maximum));
  }
  std::vector<std::string> values;
  const std::size_t wanted = std::min<std::size_t>(steps.size(), most_standard_values);
  for (std::size_t i = 0; i < wanted; ++i) {
    const std::size_t place = wanted == 1 ? 0 : i * (steps.size() - 1) / (wanted - 1);
    add_new(values, number_text(option, steps[place]));
  }
  return values;
}

bool any_number(const std::vector<std::string>& values, const Option& option) {
  return option.kind != OptionKind::choice && !values.empty();
}

/// "Map size" as it is written within a sentence: "map size", but "MSAA" as it is.
std::string begun_small(std::string label) {
  const bool word = label.size() > 1 && label[1] >= 'a' && label[1] <= 'z';
  if (word && label[0] >= 'A' && label[0] <= 'Z') label[0] = static_cast<char>(label[0] - 'A' + 'a');
  return label;
}

/// How many letters the swept numbers' names have in common, in whole words that end with `separator`: the 7 of
/// "shadow-" in shadow-map-size and shadow-filter, none if only one is swept.
std::size_t common_start(std::span<const SweepAxis> axes, std::string_view Option::*text, char separator) {
  std::optional<std::string_view> common;
  int numbers = 0;
  for (const SweepAxis& axis : axes) {
    if (axis.values.size() < 2 || !any_number(axis.values, *axis.option)) continue;
    ++numbers;
    const std::string_view name = axis.option->*text;
    if (!common) common = name;
    const auto parted = std::mismatch(common->begin(), common->end(), name.begin(), name.end());
    common = common->substr(0, static_cast<std::size_t>(parted.first - common->begin()));
  }
  if (numbers < 2) return 0;
  const auto end = common->rfind(separator);
  return end == std::string_view::npos ? 0 : end + 1;
}

/// Whether an axis says something about a point. What cannot act there is left out.
bool sets_apart(std::span<const SweepAxis> axes, const SweepAxis& axis, const Settings& settings,
                const SceneTraits& traits) {
  return axis.values.size() >= 2 && (axes.size() == 1 || !inactive_reason(*axis.option, settings, traits));
}

/// A choice's value says enough; a number or on/off needs its name.
std::string short_label(std::span<const SweepAxis> axes, const Settings& settings, const SceneTraits& traits) {
  const std::size_t start = common_start(axes, &Option::key, '-');
  std::string label;
  for (const SweepAxis& axis : axes) {
    if (!sets_apart(axes, axis, settings, traits)) continue;
    const std::string text = option_text(*axis.option, settings);
    label += label.empty() ? "" : ", ";
    label += any_number(axis.values, *axis.option) ? fmt::format("{} {}", axis.option->key.substr(start), text) : text;
  }
  return label.empty() ? "as set" : label;
}

/// The value as people read it: a choice by its label.
std::string value_words(const Option& option, const Settings& settings) {
  return option.kind == OptionKind::choice ? std::string(chosen(option, settings).label)
                                           : option_text(option, settings);
}

/// short_label() in the words of the option table. Of one option alone the name comes first, with a colon.
std::string short_name(std::span<const SweepAxis> axes, const Settings& settings, const SceneTraits& traits) {
  if (axes.size() == 1) return fmt::format("{}: {}", axes[0].option->label, value_words(*axes[0].option, settings));
  const std::size_t start = common_start(axes, &Option::label, ' ');
  std::string name;
  for (const SweepAxis& axis : axes) {
    if (!sets_apart(axes, axis, settings, traits)) continue;
    const std::string value = value_words(*axis.option, settings);
    name += name.empty() ? "" : ", ";
    if (!any_number(axis.values, *axis.option)) {
      name += value;
      continue;
    }
    const std::string label = std::string(axis.option->label.substr(start));
    name += fmt::format("{} {}", name.empty() ? label : begun_small(label), value);
  }
  return name.empty() ? "as set" : name;
}

std::string assignments(std::span<const SweepAxis> axes, const Settings& settings) {
  std::string text;
  for (const SweepAxis& axis : axes)
    text += fmt::format("{}{}={}", text.empty() ? "" : ";", axis.option->key, option_text(*axis.option, settings));
  return text;
}

std::string all_words(std::span<const SweepAxis> axes, const Settings& settings) {
  std::string text;
  for (const SweepAxis& axis : axes)
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ",
                        text.empty() ? std::string(axis.option->label) : begun_small(std::string(axis.option->label)),
                        value_words(*axis.option, settings));
  return text;
}

std::string all_assignments(std::span<const SweepAxis> axes, const Settings& start, const Settings& settings) {
  std::string text = assignments(axes, settings);
  for (const std::string& assignment : settings_difference(start, settings)) {
    const std::string key = assignment.substr(0, assignment.find('='));
    const bool swept = std::any_of(axes.begin(), axes.end(), [&](const SweepAxis& a) { return a.option->key == key; });
    if (!swept) text += fmt::format("{}{}", text.empty() ? "" : ";", assignment);
  }
  return text;
}

/// Every combination, the last axis fastest.
std::vector<Settings> combinations(std::span<const SweepAxis> axes, const Settings& base) {
  std::vector<Settings> all{base};
  for (const SweepAxis& axis : axes) {
    std::vector<Settings> next;
    for (const Settings& settings : all)
      for (const std::string& value : axis.values) {
        next.push_back(settings);
        parse_option(*axis.option, value, next.back());
      }
    if (next.size() > most_points) throw InputError(fmt::format("the sweep has more than {} points", most_points));
    all = std::move(next);
  }
  return all;
}

/// Puts swept options that cannot act back to their value in `base`, until nothing changes.
Settings without_idle(std::span<const SweepAxis> axes, Settings settings, const Settings& base,
                      const SceneTraits& traits) {
  for (std::size_t round = 0; round < axes.size(); ++round)
    for (const SweepAxis& axis : axes)
      if (inactive_reason(*axis.option, settings, traits)) axis.option->set(settings, axis.option->get(base));
  return settings;
}

bool acts_somewhere(const SweepAxis& axis, const std::vector<Settings>& all, const SceneTraits& traits) {
  return std::any_of(all.begin(), all.end(),
                     [&](const Settings& settings) { return !inactive_reason(*axis.option, settings, traits); });
}

}  // namespace

std::vector<std::string> standard_values(const Option& option) {
  std::vector<std::string> values;
  if (!option.sweep_values.empty())
    return parse_sweep_axis(fmt::format("{}={}", option.key, option.sweep_values)).values;
  switch (option.kind) {
  case OptionKind::boolean:
    return {"off", "on"};
  case OptionKind::choice:
    for (const Choice& choice : option.choices)  // those that this machine has
      if (!choice.inactive || !choice.inactive(Settings{}, SceneTraits{})) values.emplace_back(choice.key);
    return values;
  case OptionKind::integer:
  case OptionKind::real:
    return spread(option);
  }
  return values;
}

SweepAxis parse_sweep_axis(std::string_view text) {
  const auto equals = text.find('=');
  const std::string_view key = text.substr(0, equals);
  SweepAxis axis;
  axis.option = find_option(key);
  if (!axis.option) {
    Settings unused;
    parse_assignment(fmt::format("{}=", key), unused);  // throws, naming the nearest key
  }
  if (equals == std::string_view::npos) {
    axis.values = standard_values(*axis.option);
    return axis;
  }
  std::string_view rest = text.substr(equals + 1);
  while (true) {
    const auto comma = rest.find(',');
    std::string value = canonical(*axis.option, rest.substr(0, comma));
    if (std::find(axis.values.begin(), axis.values.end(), value) != axis.values.end())
      throw InputError(fmt::format("sweep {}: the value {} is given twice", key, value));
    axis.values.push_back(std::move(value));
    if (comma == std::string_view::npos) return axis;
    rest = rest.substr(comma + 1);
  }
}

std::span<const NamedSweep> named_sweeps() {
  const std::string_view by_rays = renderer_kind(renderer_for(PictureWay::rays)).key,
                         by_fragments = renderer_kind(renderer_for(PictureWay::fragments)).key;
  const std::string fragments = fmt::format("renderer={}", by_fragments),
                    both = fmt::format("renderer={},{}", by_rays, by_fragments);
  static const std::vector<NamedSweep> sweeps{
      {renderer_sweep, "Renderers", {renderer_sweep_axis()}},
      {"accelerators", "Accelerators", {"accelerator"}},
      {"shading-models", "Shading models", {fragments, "shading", "highlight"}},
      {"texture-filters", "Texture filters", {both, "texture-filter"}},
      {"reflection-depths", "Reflection depth", {"reflection-depth=0,1,2,3,4,6,8"}},
      {"reflection-cutoffs",
       "Minimum contribution",
       {"reflection-depth=3,12", "reflection-cutoff=0,0.01,0.02,0.05,0.1,0.2"}},
      {"tessellation-levels", "Tessellation against exact spheres", {both, "tessellation=0.05,0.2,0.5,2,8,32"}},
      {"precision-and-tests", "Precision and tests", {"precision", "sphere-test", "self-hit"}},
      {"snapping", "Sub-pixel bits", {fragments, "subpixel-bits=0,2,4,6,8,10,12"}},
      {"samples", "Samples per pixel", {"samples-per-pixel=1,4,16,64"}},
      {"shadow-methods",
       "Shadow methods",
       {fragments, "shadows=none,map,stencil-depth-pass,stencil-depth-fail", "shadow-map-size=16,64,256,1024,4096",
        "shadow-filter"}},
      {"coverage-strategies", "Coverage strategies", {fragments, "coverage"}},
  };
  static const std::vector<NamedSweep> usable = [] {
    std::vector<NamedSweep> all;
    for (const NamedSweep& sweep : sweeps) {
      const bool known = std::all_of(sweep.axes.begin(), sweep.axes.end(), [](const std::string& axis) {
        return find_option(std::string_view(axis).substr(0, axis.find('='))) != nullptr;
      });
      if (known) all.push_back(sweep);
    }
    return all;
  }();
  return usable;
}

namespace {

/// The axes of all named sweeps, in their order.
const std::vector<std::vector<SweepAxis>>& named_axes() {
  static const std::vector<std::vector<SweepAxis>> all = [] {
    std::vector<std::vector<SweepAxis>> axes;
    for (const NamedSweep& sweep : named_sweeps()) {
      axes.emplace_back();
      for (const std::string& axis : sweep.axes) axes.back().push_back(parse_sweep_axis(axis));
      if (sweep.key == renderer_sweep) axes.back() = without_absent_renderers(axes.back());
    }
    return axes;
  }();
  return all;
}

}  // namespace

std::vector<SweepAxis> parse_sweep(std::string_view text) {
  for (std::size_t i = 0; i < named_sweeps().size(); ++i)
    if (named_sweeps()[i].key == text) return named_axes()[i];
  return {parse_sweep_axis(text)};
}

std::string sweep_text(std::span<const SweepAxis> axes) {
  const auto same = [](const SweepAxis& a, const SweepAxis& b) { return a.option == b.option && a.values == b.values; };
  for (std::size_t i = 0; i < named_sweeps().size(); ++i) {
    const std::vector<SweepAxis>& named = named_axes()[i];
    if (std::equal(named.begin(), named.end(), axes.begin(), axes.end(), same))
      return std::string(named_sweeps()[i].key);
  }
  std::vector<std::string> texts;
  for (const SweepAxis& axis : axes)
    texts.push_back(fmt::format("{}={}", axis.option->key, fmt::join(axis.values, ",")));
  return axes.empty() ? no_axes : fmt::format("{}", fmt::join(texts, ";"));
}

std::vector<SweepAxis> parse_sweep_text(std::string_view text) {
  if (text == no_axes || text == model_sweep_key) return {};
  if (text.find(';') == std::string_view::npos) return parse_sweep(text);
  std::vector<SweepAxis> axes;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t to = std::min(text.find(';', from), text.size());
    axes.push_back(parse_sweep_axis(text.substr(from, to - from)));
    from = to + 1;
  }
  return axes;
}

std::vector<SweepPoint> sweep_points(std::span<const SweepAxis> axes, const Settings& base, const Settings& scene_start,
                                     const SceneTraits& traits) {
  std::set<std::string_view> keys;
  for (const SweepAxis& axis : axes)
    if (!keys.insert(axis.option->key).second)
      throw InputError(fmt::format("sweep {}: the option is swept twice", axis.option->key));
  const std::vector<Settings> all = combinations(axes, base);
  std::vector<SweepAxis> acting;
  for (const SweepAxis& axis : axes)
    if (acts_somewhere(axis, all, traits)) acting.push_back(axis);
  std::vector<SweepPoint> points;
  std::map<std::string, int> uses;
  std::set<std::string> seen;
  for (const Settings& combination : all) {
    const Settings settings = axes.size() > 1 ? without_idle(acting, combination, base, traits) : combination;
    SweepPoint point{short_label(axes, settings, traits), short_name(axes, settings, traits),
                     all_assignments(axes, scene_start, settings), settings};
    if (!seen.insert(point.settings).second) continue;
    ++uses[point.label];
    points.push_back(std::move(point));
  }
  for (SweepPoint& point : points)
    if (uses[point.label] > 1) {
      point.label = assignments(axes, point.value);
      point.name = all_words(axes, point.value);
    }
  return points;
}

std::optional<std::string> idle_axis(const SweepAxis& axis, std::span<const SweepAxis> axes, const Settings& base,
                                     const SceneTraits& traits) {
  const std::vector<Settings> all = combinations(axes, base);
  if (acts_somewhere(axis, all, traits)) return {};
  return fmt::format("{} changes nothing here: {}.", axis.option->label,
                     inactive_reason(*axis.option, all.front(), traits)->text());
}

std::optional<std::string> idle_axes_all(std::span<const SweepAxis> own, std::span<const SweepAxis> axes,
                                         const Settings& base, const SceneTraits& traits) {
  std::optional<std::string> first;
  for (const SweepAxis& axis : own) {
    const auto idle = idle_axis(axis, axes, base, traits);
    if (!idle) return {};
    if (!first) first = idle;
  }
  return first;
}

std::vector<std::string> idle_axes(std::span<const SweepAxis> axes, const Settings& base, const SceneTraits& traits) {
  std::vector<std::string> sentences;
  for (const SweepAxis& axis : axes)
    if (auto sentence = idle_axis(axis, axes, base, traits)) sentences.push_back(std::move(*sentence));
  return sentences;
}

std::optional<std::string> idle_sweep(const NamedSweep& sweep, const Settings& base, const SceneTraits& traits) {
  const std::vector<SweepAxis> axes = parse_sweep(sweep.key);
  const std::vector<Settings> all = combinations(axes, base);
  const SweepAxis* idle = nullptr;
  for (const SweepAxis& axis : axes) {
    if (axes.size() > 1 && axis.option->key == "renderer") continue;
    if (acts_somewhere(axis, all, traits)) return {};
    if (!idle) idle = &axis;
  }
  if (!idle) return {};
  // The reason under the renderer of the last combination: the sweeps name the one last that needs the option.
  const auto reason = inactive_reason(*idle->option, all.back(), traits);
  return reason ? reason->text() : "";
}

SweepNames split_names(const std::vector<std::string>& names) {
  SweepNames split{"", names};
  if (names.empty()) return split;
  const std::size_t end = names.front().find(": ");
  if (end == std::string::npos) return split;
  const std::string start = names.front().substr(0, end + 2);
  if (!std::all_of(names.begin(), names.end(), [&](const std::string& name) { return name.starts_with(start); }))
    return split;
  split.common = start.substr(0, end);
  for (std::string& part : split.parts) part.erase(0, start.size());
  return split;
}

}  // namespace ps
