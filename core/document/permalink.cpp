#include "document/permalink.h"

#include <fmt/format.h>

#include <array>
#include <optional>
#include <utility>

#include "base/check.h"
#include "base/enumerators.h"
#include "base/resources.h"
#include "document/number_list.h"
#include "document/permalink_field.h"
#include "options/option.h"
#include "options/scene_settings.h"

namespace ps {

namespace detail {

double parse_in_range(std::string_view text, double low, double high, std::string_view what) {
  const double value = parse_number_list(text, 1, what).front();
  if (value < low || value > high)
    throw InputError(fmt::format("{}: found {}, expected a number from {} to {}", what, text, low, high));
  return value;
}

int parse_whole(std::string_view text, int low, int high, std::string_view what) {
  const double value = parse_in_range(text, low, high, what);
  if (value != static_cast<int>(value))
    throw InputError(fmt::format("{}: found {}, expected a whole number", what, text));
  return static_cast<int>(value);
}

std::optional<std::string> number_unless(double value, double standard) {
  return value == standard ? std::nullopt : std::optional(fmt::format("{}", value));
}

std::optional<std::string> text_unless(const std::string& value, const std::string& standard) {
  return value == standard ? std::nullopt : std::optional(value);
}

}  // namespace detail

namespace {

using detail::number_unless;
using detail::parse_in_range;
using detail::parse_whole;
using detail::text_unless;
using Field = detail::PermalinkField;
using Text = std::optional<std::string>;

/// Whether a part of the window is open, as its field says it.
bool parse_open(std::string_view text, std::string_view what) {
  if (text != "open" && text != "folded")
    throw InputError(fmt::format("{}: found '{}', expected open or folded", what, text));
  return text == "open";
}

Text show_text(ShownChannel show) {
  return show == ShownChannel{} ? Text{} : Text{std::string(shown_channel(show).key)};
}

Text slow_text(const SideState& side) { return side.slow_motion ? Text{slow_motion_text(*side.slow_motion)} : Text{}; }

Text event_text(int event) { return event < 0 ? Text{} : Text{fmt::format("{}", event)}; }
int parse_event(std::string_view text) { return parse_whole(text, 0, 10'000'000, "event"); }

/// "event" is that of the picked side, in whichever order the two parts come.
void pick_side(Document& document, Side side) {
  if (side != document.picked) std::swap(document.events[0], document.events[1]);
  document.picked = side;
}

Text heat_range_text(const std::optional<HeatRange>& range) {
  if (!range) return {};
  const std::array<double, 2> ends{range->values.low, range->values.high};
  return fmt::format("{},{}", shown_channel(range->channel).key, number_list_text(ends));
}

HeatRange parse_heat_range(std::string_view text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string_view::npos)
    throw InputError(
        fmt::format("range: found '{}', expected a channel and two numbers, with commas between them", text));
  const ShownChannel channel = parse_shown_channel(text.substr(0, comma));
  const auto ends = parse_number_list(text.substr(comma + 1), 2, "range");
  if (!shown_channel(channel).heat.value || !(ends[0] < ends[1]))
    throw InputError(fmt::format("range: found '{}', expected a channel with a false-colour scale, and two numbers of "
                                 "which the second is larger",
                                 text));
  return {channel, {ends[0], ends[1]}};
}

const std::vector<Field>& document_fields() {
  static const std::vector<Field> fields{
      {"scene", [](const Document& d) { return text_unless(portable_name(d.scene_name), ""); },
       [](Document& d, std::string_view t) { d.scene_name = local_name(t); }},
      {"size",
       [](const Document& d) {
         return d.view.width == 0 ? Text{} : Text{fmt::format("{}x{}", d.view.width, d.view.height)};
       },
       [](Document& d, std::string_view t) {
         const Vec2i size = parse_size_text(t);
         d.view.width = size.x;
         d.view.height = size.y;
       }},
      {"camera", [](const Document& d) { return d.view.camera ? Text{camera_text(*d.view.camera)} : Text{}; },
       [](Document& d, std::string_view t) { d.view.camera = parse_camera_text(t); }},
      {"zoom", [](const Document& d) { return number_unless(d.view.zoom, 0); },
       [](Document& d, std::string_view t) { d.view.zoom = parse_in_range(t, 0, 4096, "zoom"); }},
      {"middle",
       [](const Document& d) {
         const std::array<double, 2> place{d.view.middle.x, d.view.middle.y};
         return d.view.middle == PictureView{}.middle ? Text{} : Text{number_list_text(place)};
       },
       [](Document& d, std::string_view t) {
         const auto place = parse_number_list(t, 2, "middle");
         d.view.middle = {place[0], place[1]};
       }},
      {"region", [](const Document& d) { return d.view.region ? Text{region_text(*d.view.region)} : Text{}; },
       [](Document& d, std::string_view t) { d.view.region = parse_region_text(t); }},
      {"picture-b", [](const Document& d) { return text_unless(d.picture_b, ""); },
       [](Document& d, std::string_view t) { d.picture_b = t; }},
      {"pixel",
       [](const Document& d) { return d.pixel.x < 0 ? Text{} : Text{fmt::format("{},{}", d.pixel.x, d.pixel.y)}; },
       [](Document& d, std::string_view t) { d.pixel = parse_pixel_text(t); }},
      {"picked", [](const Document& d) { return d.picked == Side::a ? Text{} : Text{"b"}; },
       [](Document& d, std::string_view t) {
         if (t != "a" && t != "b") throw InputError(fmt::format("picked: found '{}', expected a or b", t));
         pick_side(d, t == "a" ? Side::a : Side::b);
       }},
      {"event", [](const Document& d) { return event_text(event_of(d, d.picked)); },
       [](Document& d, std::string_view t) { event_of(d, d.picked) = parse_event(t); }},
      {"other-event", [](const Document& d) { return event_text(event_of(d, other_side(d.picked))); },
       [](Document& d, std::string_view t) { event_of(d, other_side(d.picked)) = parse_event(t); }},
      {"show-a", [](const Document& d) { return show_text(d.a.show); },
       [](Document& d, std::string_view t) { d.a.show = parse_shown_channel(t); }},
      {"field", [](const Document& d) { return d.field ? Text{field_query_text(d.field->query)} : Text{}; },
       [](Document& d, std::string_view t) {
         d.field = ShownField{parse_field_query(t), {}};
       }},
      {"mark",
       [](const Document& d) {
         return d.field && d.field->condition ? Text{field_condition_text(*d.field->condition)} : Text{};
       },
       [](Document& d, std::string_view t) {
         if (!d.field) throw InputError("mark: needs a field");
         d.field->condition = parse_field_condition(t);
       }},
      {"show-b", [](const Document& d) { return show_text(d.b.show); },
       [](Document& d, std::string_view t) { d.b.show = parse_shown_channel(t); }},
      {"slow-motion-a", [](const Document& d) { return slow_text(d.a); },
       [](Document& d, std::string_view t) { d.a.slow_motion = parse_slow_motion(t); }},
      {"slow-motion-b", [](const Document& d) { return slow_text(d.b); },
       [](Document& d, std::string_view t) { d.b.slow_motion = parse_slow_motion(t); }},
      {"compare",
       [](const Document& d) {
         return text_unless(std::string(enumerator_key(d.compare)),
                            std::string(enumerator_key(CompareMode::side_by_side)));
       },
       [](Document& d, std::string_view t) { d.compare = parse_enumerator<CompareMode>("compare", t); }},
      {"split", [](const Document& d) { return number_unless(d.split, 0.5); },
       [](Document& d, std::string_view t) { d.split = parse_in_range(t, 0, 1, "split"); }},
      {"range", [](const Document& d) { return heat_range_text(d.heat_range); },
       [](Document& d, std::string_view t) { d.heat_range = parse_heat_range(t); }},
      {"gain", [](const Document& d) { return number_unless(d.difference_gain, 0); },
       [](Document& d, std::string_view t) { d.difference_gain = parse_in_range(t, 0, 1e6, "gain"); }},
      {"left", [](const Document& d) { return number_unless(d.layout.left, Layout{}.left); },
       [](Document& d, std::string_view t) { d.layout.left = parse_in_range(t, 0, 1, "left"); }},
      {"right", [](const Document& d) { return number_unless(d.layout.right, Layout{}.right); },
       [](Document& d, std::string_view t) { d.layout.right = parse_in_range(t, 0, 1, "right"); }},
      {"bottom", [](const Document& d) { return number_unless(d.layout.bottom, Layout{}.bottom); },
       [](Document& d, std::string_view t) { d.layout.bottom = parse_in_range(t, 0, 1, "bottom"); }},
      {"panels", [](const Document& d) { return d.layout.panels ? Text{} : Text{"off"}; },
       [](Document& d, std::string_view t) {
         if (t != "on" && t != "off") throw InputError(fmt::format("panels: found '{}', expected on or off", t));
         d.layout.panels = t == "on";
       }},
      {"right-tab", [](const Document& d) { return text_unless(d.layout.right_tab, Layout{}.right_tab); },
       [](Document& d, std::string_view t) { d.layout.right_tab = t; }},
      {"bottom-tab", [](const Document& d) { return text_unless(d.layout.bottom_tab, Layout{}.bottom_tab); },
       [](Document& d, std::string_view t) { d.layout.bottom_tab = t; }},
      {"pixel-panel", [](const Document& d) { return d.layout.story_open ? Text{} : Text{"folded"}; },
       [](Document& d, std::string_view t) { d.layout.story_open = parse_open(t, "pixel-panel"); }},
      {"options", [](const Document& d) { return d.layout.options_open ? Text{"open"} : Text{}; },
       [](Document& d, std::string_view t) { d.layout.options_open = parse_open(t, "options"); }},
      {"stage", [](const Document& d) { return text_unless(d.layout.stage, ""); },
       [](Document& d, std::string_view t) { d.layout.stage = t; }},
      {"sweep", [](const Document& d) { return text_unless(d.layout.sweep, ""); },
       [](Document& d, std::string_view t) { d.layout.sweep = t; }},
      {"experiment", [](const Document& d) { return text_unless(d.layout.experiment, ""); },
       [](Document& d, std::string_view t) { d.layout.experiment = t; }},
      {"filled", [](const Document& d) { return text_unless(d.layout.filled, ""); },
       [](Document& d, std::string_view t) {
         if (t != "left" && t != "lesson" && t != "right" && t != "bottom")
           throw InputError(fmt::format("filled: found '{}', expected left, lesson, right or bottom", t));
         d.layout.filled = t;
       }},
      {"lesson", [](const Document& d) { return text_unless(d.lesson, ""); },
       [](Document& d, std::string_view t) {
         d.lesson = t;
         d.mode = ScreenMode::lesson;  // unless the next part says otherwise
       }},
      {"mode",
       [](const Document& d) {
         const ScreenMode usual = d.lesson.empty() ? ScreenMode::explore : ScreenMode::lesson;
         return d.mode == usual ? Text{} : Text{std::string(enumerator_key(d.mode))};
       },
       [](Document& d, std::string_view t) { d.mode = parse_enumerator<ScreenMode>("mode", t); }},
      {"step", [](const Document& d) { return d.step == 0 ? Text{} : Text{fmt::format("{}", d.step)}; },
       [](Document& d, std::string_view t) { d.step = parse_whole(t, 0, 1000, "step"); }},
  };
  return fields;
}

/// The part of a key after `prefix`, if it begins so.
std::optional<std::string_view> after(std::string_view key, std::string_view prefix) {
  return key.starts_with(prefix) ? std::optional(key.substr(prefix.size())) : std::nullopt;
}

const Field* find_field(std::string_view key) {
  for (const Field& field : document_fields())
    if (field.key == key) return &field;
  for (const Field& field : detail::story_fields())
    if (field.key == key) return &field;
  return nullptr;
}

}  // namespace

void detail::add_options(std::string_view prefix, const Settings& settings, const AddPart& add) {
  for (const std::string& assignment : changed_options(settings)) {
    const auto equals = assignment.find('=');
    add(fmt::format("{}{}", prefix, assignment.substr(0, equals)), assignment.substr(equals + 1));
  }
}

std::string permalink(const Document& document) {
  std::string link;
  const auto add = [&](std::string_view key, std::string_view value) {
    link += fmt::format("{}{}={}", link.empty() ? "" : "&", percent_escape(key), percent_escape(value));
  };
  for (const Field& field : document_fields())
    if (const auto text = field.text(document)) add(field.key, *text);
  for (const Field& field : detail::story_fields())
    if (const auto text = field.text(document)) add(field.key, *text);
  if (document.pin) detail::add_pin(*document.pin, add);
  for (const SceneEdit& edit : document.edits) add("edit." + edit.path, edit.value);
  detail::add_options("a.", document.a.settings, add);
  detail::add_options("b.", document.b.settings, add);
  return link;
}

bool set_permalink_part(Document& document, std::string_view key, std::string_view value) {
  if (const auto option = after(key, "a.")) {
    parse_assignment(fmt::format("{}={}", *option, value), document.a.settings);
  } else if (const auto option_b = after(key, "b.")) {
    parse_assignment(fmt::format("{}={}", *option_b, value), document.b.settings);
  } else if (const auto path = after(key, "edit.")) {
    document.edits.push_back({std::string(*path), std::string(value)});
  } else if (key == "pin") {
    detail::parse_pin({}, value, document.pin);
  } else if (const auto part = after(key, "pin.")) {
    detail::parse_pin(*part, value, document.pin);
  } else if (const Field* field = find_field(key)) {
    field->parse(document, value);
  } else {
    return false;
  }
  return true;
}

Document parse_permalink(std::string_view text) {
  Document document;
  while (!text.empty()) {
    const auto end = text.find('&');
    const std::string_view part = text.substr(0, end);
    const auto equals = part.find('=');
    if (equals == std::string_view::npos)
      throw InputError(fmt::format("permalink: found '{}', expected KEY=VALUE", part));
    const std::string key = percent_unescape(part.substr(0, equals));
    if (!set_permalink_part(document, key, percent_unescape(part.substr(equals + 1))))
      throw InputError(fmt::format("permalink: unknown part '{}'", key));
    text = end == std::string_view::npos ? std::string_view{} : text.substr(end + 1);
  }
  return document;
}

}  // namespace ps
