#include "gui/panels/pictures/difference_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "gui/base/values.h"
#include "gui/panels/pictures/difference_scale.h"
#include "gui/panels/pictures/orbit_ball.h"
#include "gui/widgets/widgets.h"

namespace ps::gui {
namespace {

constexpr double metric_width = 120, number_room = 330;  // at scale 1
constexpr double tools_room = 460;                       // of all four tools

bool comparable(const PicturesState& state) {
  const auto &a = state.pictures[0].levels, &b = state.pictures[1].levels;
  return !a.empty() && a.width() == b.width() && a.height() == b.height();
}

/// What was measured of the pictures as they are now; nullptr while that is still to come.
std::shared_ptr<const MeasuredDifference> measured_now(const Session& session, const PicturesState& state) {
  auto measured = state.difference.meter->result();
  const bool known = measured && same_difference(measured->request, {{}, state.versions, session.region()});
  return known ? measured : nullptr;
}

/// Makes the map of the difference again where something has changed. FLIP comes from the background; until then the
/// map stays as it was.
void make_difference(Session& session, PicturesState& state) {
  const double asked = session.document().difference_gain;
  const bool due =
      state.difference.stale || asked != state.difference.asked || (!state.difference.settled && !session.busy());
  if (!due || !comparable(state)) return;
  const auto &a = state.pictures[0].levels, &b = state.pictures[1].levels;
  if (state.difference.mode == DifferenceMode::flip) {
    const auto measured = measured_now(session, state);
    if (!measured || measured->flip_map.empty()) return;
    state.difference.values = measured->flip_map;
  } else {
    state.difference.values = difference_values(a, b, state.difference.mode);
  }
  state.difference.identical = a == b;
  state.difference.numbers = difference_numbers(state.difference.values, session.region());
  // While tiles arrive the gain stays: the whole map would flicker.
  if (asked > 0 || !session.busy() || state.difference.picture.levels.empty())
    state.difference.gain = asked > 0 ? asked : gain_that_shows(state.difference.numbers, state.difference.mode);
  const DifferenceOptions options{state.difference.gain, state.difference.mode};
  state.difference.picture.levels = state.difference.mode == DifferenceMode::absolute
                                        ? difference_picture(a, b, options)
                                        : difference_picture(state.difference.values, options);
  state.difference.picture.upload({{0, 0, a.width(), a.height()}});
  state.difference.stale = false;
  state.difference.asked = asked;
  state.difference.settled = asked > 0 || !session.busy();
  state.difference.fresh = true;
}

const std::vector<Choice>& mode_choices() {
  static const std::vector<Choice> choices{
      {"absolute", "|B − A|", "The difference of each channel, in levels."},
      {"sign", "B − A", "Blue where A is brighter, orange where B is, in levels."},
      {"relative", "relative", "The difference as a share of A: what differs in the dark shows."},
      {"flip", "FLIP", "The difference as seen when the pictures are flipped in place, measured in the background."}};
  return choices;
}

void set_gain(Session& session, double gain) {
  session.navigate([&](Document& document) { document.difference_gain = gain; });
}

/// How the difference is shown, and a way to where it is largest.
void difference_tools(Session& session, PicturesState& state, const Area& row) {
  const float wide = px(tools_room);
  const float share = std::min(row.width() / wide, 1.f);
  ImGui::SetCursorScreenPos({row.min.x, row.min.y + std::max((row.height() - ImGui::GetFrameHeight()) / 2, 0.f)});
  int mode = static_cast<int>(state.difference.mode);
  if (choice("mode", mode_choices(), mode,
             {.tooltip = "What is shown of the difference.",
              .disabled = {},
              .width = std::max(px(104) * share, px(84))})) {
    state.difference.mode = static_cast<DifferenceMode>(mode);
    state.difference.stale = true;
  }
  ImGui::SameLine(0, px(6));
  double gain = state.difference.gain;
  const auto edit = number("gain", gain, {.minimum = 1, .maximum = 256, .scale = OptionScale::logarithmic, .unit = "x"},
                           {.tooltip = "Factor by which differences are multiplied before they are shown.",
                            .disabled = {},
                            .width = px(120) * share});
  if (edit.changed) set_gain(session, gain);
  ImGui::SameLine(0, px(6));
  const bool automatic = session.document().difference_gain == 0;
  if (button_on_off("auto", "auto", automatic,
                    {.tooltip = "The gain with which the brightest 0.1 % of the pixels are white."}))
    set_gain(session, automatic ? state.difference.gain : 0);
  const Vec2i at = state.difference.numbers.at;
  values().publish("difference/largest-at", at.x < 0 ? "none" : fmt::format("{},{}", at.x, at.y));
  if (ImGui::GetItemRectMax().x + px(6) + button_width("Largest") > row.max.x) return;
  ImGui::SameLine(0, px(6));
  if (button("largest", "Largest", Emphasis::plain,
             {.tooltip = "Picks the pixel with the largest difference, which has a ring.",
              .disabled = at.x < 0 ? "no display level differs" : ""}))
    session.set_pixel(at);
}

/// The values behind the picture of a side; nullptr where it does not show them, or not all of them.
std::shared_ptr<const Image<Vec3f>> values_of(Session& session, Side side) {
  if (const auto file = session.file_of(side)) return {file, &file->stored.colour};
  const auto result = session.renderer(side).result();
  if (!result || result->slow || session.shown(side) != ShownChannel::colour) return nullptr;
  return {result, &result->frame.colour};
}

std::string in_pixels(std::int64_t count) { return fmt::format("in {} pixel{}", count, count == 1 ? "" : "s"); }

/// Equal display levels may hide values that differ: colours beyond white, negative ones, steps below a level, NaN.
std::string identical_text(Session& session, PicturesState& state) {
  const auto file = session.picture_b();
  if (!file && session.settings(Side::a) == session.settings(Side::b))
    return "A and B have the same options: there is no difference.";
  const std::string although = file ? "" : ", although their options differ";
  const auto a = values_of(session, Side::a), b = values_of(session, Side::b);
  if (!a || !b || a->width() != b->width() || a->height() != b->height())
    return fmt::format("A and B are identical in display levels{}.", although);
  if (state.difference.compared[0].lock() != a || state.difference.compared[1].lock() != b) {
    state.difference.compared = {a, b};
    state.difference.of_values = compare_channels(*a, *b);
    state.difference.of_alpha = file ? compare_alpha({}, file->stored.alpha) : AlphaDifference{};
  }
  const Comparison& values = state.difference.of_values;
  const AlphaDifference& opacity = state.difference.of_alpha;
  const std::string alpha = opacity.differing > 0 ? fmt::format(" The alpha of B differs from 1 by at most {:.3g} {}.",
                                                                opacity.max, in_pixels(opacity.differing))
                                                  : "";
  if (values.identical)
    return fmt::format("A and B are identical{}{}.{}", alpha.empty() ? "" : " in colour", although, alpha);
  const std::string by = values.max > 0 ? fmt::format(" by at most {:.3g}", values.max) : "";
  const std::string not_finite =
      values.not_finite > 0 ? fmt::format(" {} pixels are not finite.", values.not_finite) : "";
  return fmt::format("A and B are identical in display levels{}. Their values differ{} {}.{}{}", although, by,
                     in_pixels(values.differing), not_finite, alpha);
}

/// A ring around the pixel with the largest difference.
void largest_ring(ImDrawList& list, const PicturesState& state, const Area& area) {
  const Vec2i at = state.difference.numbers.at;
  if (at.x < 0) return;
  const ImVec2 middle = state.drawn.transform.to_window(Vec2d(at) + Vec2d(0.5), area);
  const float radius = std::max(px(9), static_cast<float>(state.drawn.transform.zoom));
  list.PushClipRect(area.min, area.max, true);
  list.AddCircle(middle, radius, colour_u32(palette().panel), 0, px(4));
  list.AddCircle(middle, radius, colour_u32(palette().attention), 0, px(2));
  list.PopClipRect();
}

/// How large the difference is, as one number: the metric, and its value as soon as it is measured.
void difference_number(Session& session, PicturesState& state, const Area& row) {
  if (!session.busy() && comparable(state)) {
    const auto &a = state.pictures[0].levels, &b = state.pictures[1].levels;
    state.difference.meter->request({state.difference.meter->copies(a, b, state.versions), state.versions,
                                     session.region(), state.difference.mode == DifferenceMode::flip});
  }
  ImGui::SetCursorScreenPos({row.min.x, row.min.y + std::max((row.height() - ImGui::GetFrameHeight()) / 2, 0.f)});
  std::vector<Choice> choices;
  for (const ErrorMetricRow& metric : error_metrics())
    choices.push_back({metric.key, metric.label, metric_help(metric.metric)});
  int index = static_cast<int>(state.difference.metric);
  if (choice("metric", choices, index, {.tooltip = metric_help(state.difference.metric), .width = px(metric_width)}))
    state.difference.metric = static_cast<ErrorMetric>(index);
  ImGui::SameLine(0, px(8));
  ImGui::AlignTextToFramePadding();
  const auto measured = measured_now(session, state);
  std::string text =
      measured ? difference_text(state.difference.metric, error_of(measured->comparison, state.difference.metric))
               : "measuring ...";
  if (measured && measured->request.region) text += ", in the rectangle";
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::PushClipRect(at, {row.max.x, row.max.y}, true);
  value_text("error", text, {Face::bold});
  ImGui::PopClipRect();
  tooltip(metric_help(state.difference.metric));
}

}  // namespace

void difference_view(Session& session, PicturesState& state, const Area& title, const DifferencePlaces& places) {
  const Area& area = places.picture;
  const NameScope scope("difference");
  make_difference(session, state);
  // Where the pictures are narrow there are two lines for titles, here for the number above the tools.
  const float line = std::min(px(34), title.max.y - title.min.y);
  const bool two_lines = title.max.y - title.min.y >= px(60);
  const bool has_number = two_lines || title.width() >= px(number_room) + px(tools_room);
  const float number_left = two_lines ? title.min.x : title.max.x - (has_number ? px(number_room) : 0);
  difference_tools(session, state,
                   {{title.min.x, title.max.y - line}, {two_lines ? title.max.x : number_left, title.max.y}});
  if (has_number)
    difference_number(session, state,
                      {{number_left, two_lines ? title.min.y : title.max.y - line},
                       {title.max.x, two_lines ? title.min.y + line - px(2) : title.max.y}});
  auto& list = *ImGui::GetWindowDrawList();
  ImGui::SetCursorScreenPos(area.min);
  ImGui::InvisibleButton("picture-difference", {std::max(area.width(), 1.f), std::max(area.height(), 1.f)},
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                             ImGuiButtonFlags_MouseButtonMiddle);
  controls().record("picture", state.difference.identical ? "identical" : "different");
  controls().record("map", "");  // the same, as what may not lie over the tools (fit.h)
  const bool hovered = ImGui::IsItemHovered() || ImGui::IsItemActive();
  picture_input(session, state, Side::a, area, {});
  state.drawn.areas[0] = area;
  PictureStyle style;
  style.grid = state.grid;
  style.marked = session.pixel();
  style.region = session.region();
  draw_picture(list, state.keys.flip ? state.pictures[1] : state.difference.picture, state.drawn.transform, area,
               style);
  if (!state.keys.flip) {
    largest_ring(list, state, area);
    if (places.scale)
      draw_difference_scale(list, {state.difference.gain, state.difference.mode}, state.difference.numbers,
                            *places.scale);
  }
  picture_handles(session, state, Side::a, area, area, "picture", hovered);
  draw_orbit_ball(session, state, area, "picture/orbit", hovered);
  if (state.difference.stale && state.difference.mode == DifferenceMode::flip && state.difference.meter->busy())
    return draw_notice(list, area, "measuring FLIP ...");
  if (!state.difference.identical || session.busy()) return;
  const std::string text = identical_text(session, state);
  controls().record("notice", area.min, area.max, text);
  draw_notice(list, area, text);
}

}  // namespace ps::gui
