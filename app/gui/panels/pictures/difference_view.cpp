#include "gui/panels/pictures/difference_view.h"

#include <algorithm>
#include <vector>

#include "gui/widgets/widgets.h"

namespace ps::gui {
namespace {

constexpr double metric_width = 120, number_room = 330;  // at scale 1

bool comparable(const PicturesState& state) {
  const auto &a = state.pictures[0].levels, &b = state.pictures[1].levels;
  return !a.empty() && a.width() == b.width() && a.height() == b.height();
}

void make_difference(Session& session, PicturesState& state) {
  if (!state.difference_stale || !comparable(state)) return;
  const auto &a = state.pictures[0].levels, &b = state.pictures[1].levels;
  state.identical = a == b;
  state.difference.levels = difference_picture(a, b, {session.document().difference_gain, state.difference_mode});
  state.difference.upload({{0, 0, a.width(), a.height()}});
  state.difference_stale = false;
  state.difference_fresh = true;
}

/// How the difference is shown.
void difference_tools(Session& session, PicturesState& state, const Area& row) {
  ImGui::SetCursorScreenPos({row.min.x, row.min.y + (row.height() - ImGui::GetFrameHeight()) / 2});
  ImGui::AlignTextToFramePadding();
  {
    const FontScope font(Face::bold);
    ImGui::TextUnformatted(state.difference_mode == DifferenceMode::absolute ? "|B − A|" : "B − A");
  }
  ImGui::SameLine();
  ImGui::TextUnformatted("amplify");
  ImGui::SameLine();
  double gain = session.document().difference_gain;
  const auto edit = number("gain", gain, {.minimum = 1, .maximum = 256, .scale = OptionScale::logarithmic, .unit = "x"},
                           {.tooltip = "Factor by which differences are multiplied before they are shown.",
                            .disabled = {},
                            .width = px(140)});
  if (edit.changed) {
    session.navigate([&](Document& document) { document.difference_gain = gain; });
    state.difference_stale = true;
  }
  ImGui::SameLine();
  bool sign = state.difference_mode == DifferenceMode::sign;
  if (toggle("sign", "signed", sign,
             {.tooltip = "Grey where equal, lighter where B is brighter, darker where A is."})) {
    state.difference_mode = sign ? DifferenceMode::sign : DifferenceMode::absolute;
    state.difference_stale = true;
  }
  if (sign) {
    ImGui::SameLine();
    const FontScope font(Face::small);
    for (const char* legend : {"grey: equal, lighter: B larger, darker: A larger", "lighter: B larger"}) {
      if (ImGui::GetCursorScreenPos().x + ImGui::CalcTextSize(legend).x > row.max.x) continue;
      ImGui::PushStyleColor(ImGuiCol_Text, palette().text_quiet);
      value_text("legend", legend);
      ImGui::PopStyleColor();
      break;
    }
  }
}

/// How large the difference is, as one number: the metric, and its value as soon as it is measured.
void difference_number(Session& session, PicturesState& state, const Area& row) {
  if (!session.busy() && comparable(state)) {
    const auto &a = state.pictures[0].levels, &b = state.pictures[1].levels;
    state.meter->request({state.meter->copies(a, b, state.versions), state.versions, session.region()});
  }
  ImGui::SetCursorScreenPos({row.min.x, row.min.y + (row.height() - ImGui::GetFrameHeight()) / 2});
  std::vector<Choice> choices;
  for (const ErrorMetricRow& metric : error_metrics())
    choices.push_back({metric.key, metric.label, metric_help(metric.metric)});
  int index = static_cast<int>(state.difference_metric);
  if (choice("metric", choices, index, {.tooltip = metric_help(state.difference_metric), .width = px(metric_width)}))
    state.difference_metric = static_cast<ErrorMetric>(index);
  ImGui::SameLine(0, px(8));
  ImGui::AlignTextToFramePadding();
  const auto measured = state.meter->result();
  const bool known = measured && same_difference(measured->request, {{}, state.versions, session.region()});
  std::string text =
      known ? difference_text(state.difference_metric, error_of(measured->comparison, state.difference_metric))
            : "measuring ...";
  if (known && measured->request.region) text += ", in the rectangle";
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::PushClipRect(at, {row.max.x, row.max.y}, true);
  {
    const FontScope font(Face::bold);
    value_text("error", text);
  }
  ImGui::PopClipRect();
  tooltip(metric_help(state.difference_metric));
}

}  // namespace

void difference_view(Session& session, PicturesState& state, const Area& title, const Area& area) {
  const NameScope scope("difference");
  make_difference(session, state);
  // Where the pictures are narrow there are two lines for titles, here for the number above the tools.
  const float line = px(34);
  const bool two_lines = title.max.y - title.min.y >= px(60);
  const float number_left = two_lines ? title.min.x : title.max.x - px(number_room);
  difference_tools(session, state,
                   {{title.min.x, title.max.y - line}, {two_lines ? title.max.x : number_left, title.max.y}});
  difference_number(session, state,
                    {{number_left, two_lines ? title.min.y : title.max.y - line},
                     {title.max.x, two_lines ? title.min.y + line - px(2) : title.max.y}});
  auto& list = *ImGui::GetWindowDrawList();
  ImGui::SetCursorScreenPos(area.min);
  ImGui::InvisibleButton("picture-difference", {std::max(area.width(), 1.f), std::max(area.height(), 1.f)},
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                             ImGuiButtonFlags_MouseButtonMiddle);
  controls().record("picture", state.identical ? "identical" : "different");
  const bool hovered = ImGui::IsItemHovered() || ImGui::IsItemActive();
  picture_input(session, state, Side::a, area, {});
  state.areas[0] = area;
  PictureStyle style;
  style.grid = state.grid;
  style.marked = session.pixel();
  style.region = session.region();
  draw_picture(list, state.flip ? state.pictures[1] : state.difference, state.transform, area, style);
  picture_handles(session, state, Side::a, area, area, "picture", hovered);
  if (!state.identical || session.busy()) return;
  const bool same = session.settings(Side::a) == session.settings(Side::b);
  const std::string text = same ? "A and B have the same options: there is no difference."
                                : "A and B are identical to the last level, although their options differ.";
  controls().record("notice", area.min, area.max, text);
  draw_notice(list, area, text);
}

}  // namespace ps::gui
