#include "gui/panels/studies/why_tab.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "gui/widgets/widgets.h"

namespace ps::gui {
namespace {

void find_causes(Session& session, WhyTabState& state) {
  CauseRequest request;
  request.scene = session.scene();
  request.view = session.view();
  request.a = session.settings(Side::a);
  request.b = session.settings(Side::b);
  request.priority = WorkerPriority::background;
  state.compared = {request.a, request.b};
  state.difference = nullptr;
  state.causes.start([request = std::move(request)](StudyControl& control, const CausesStudy::Publish& publish) {
    auto found = difference_by_cause(request, control, [&](const StudyStatus& status) { publish(nullptr, status); });
    publish(std::make_shared<const DifferenceByCause>(std::move(found)), {1, 1, 0});
  });
}

void find_faults(Session& session, WhyTabState& state) {
  auto found = std::make_shared<PrecisionFound>();
  found->side = state.side;
  found->scene_name = session.document().scene_name;
  state.precision.start(
      [found, scene = session.scene(), view = session.view(),
       settings = session.settings(state.side)](StudyControl& control, const PrecisionStudy::Publish& publish) {
        Prepared prepared;
        found->map = precision_map(scene, view, settings, prepared, control.progress(), WorkerPriority::background);
        found->faults = fault_picture(found->map);
        found->gaps = gap_picture(found->map);
        publish(found, {1, 1, 0});
      });
}

void shown_choice(WhyTabState& state) {
  static constexpr std::array views{
      Choice{"causes", "Causes", "How much of the difference between A and B each option causes."},
      Choice{"precision", "Precision", "Which pixels differ from a rendering in double."}};
  int shown = static_cast<int>(state.shown);
  if (choice("shown", views, shown, {.width = px(180)})) state.shown = static_cast<WhyTabState::Shown>(shown);
}

void causes_buttons(Session& session, WhyTabState& state) {
  if (state.causes.running()) {
    if (button("cancel", "Stop", Emphasis::plain, {.width = px(82)})) state.causes.cancel();
    return;
  }
  if (session.settings(Side::a) == session.settings(Side::b)) {
    ImGui::AlignTextToFramePadding();
    return value_text("reason", "A and B have the same options.");
  }
  if (button("find", "Find out", Emphasis::primary,
             {.tooltip = "Renders A with options of B, in every order, and divides the difference among them."}))
    find_causes(session, state);
}

void precision_buttons(Session& session, WhyTabState& state) {
  static constexpr std::array sides{Choice{"a", "A", "Picture A."}, Choice{"b", "B", "Picture B."}};
  int side = static_cast<int>(index_of(state.side));
  if (choice("side", sides, side, {.width = px(76)})) state.side = both_sides[static_cast<std::size_t>(side)];
  same_line_if_room(px(82), px(4));
  if (state.precision.running()) {
    if (button("cancel", "Stop", Emphasis::plain, {.width = px(82)})) state.precision.cancel();
    return;
  }
  if (button("find", "Find out", Emphasis::primary,
             {.tooltip = "Renders the picture again in double and compares pixel by pixel.", .width = px(82)}))
    find_faults(session, state);
}

}  // namespace

bool why_tab(Session& session, WhyTabState& state, bool filled) {
  const NameScope scope("why");
  if (!session.has_scene()) return false;
  shown_choice(state);
  same_line_if_room(px(82), px(8));
  switch (state.shown) {
  case WhyTabState::Shown::causes:
    causes_buttons(session, state);
    break;
  case WhyTabState::Shown::precision:
    precision_buttons(session, state);
    break;
  }
  same_line_if_room(button_width("Fill"), px(6));
  const bool fill = button_on_off("fill", "Fill", filled, {.tooltip = "Shows this table in the whole window (Esc)."});
  ImGui::BeginChild("view");
  switch (state.shown) {
  case WhyTabState::Shown::causes:
    causes_view(session, state);
    break;
  case WhyTabState::Shown::precision:
    precision_view(session, state);
    break;
  }
  ImGui::EndChild();
  return fill;
}

std::string why_status(const WhyTabState& state) {
  if (state.causes.running()) return "Causes: rendering pictures between A and B";
  return state.precision.running() ? "Precision: rendering in double" : "";
}

std::string fault_key(PrecisionFault fault) {
  std::string key(precision_fault_label(fault));
  std::replace(key.begin(), key.end(), ' ', '-');
  return key;
}

void update_why(WhyTabState& state) {
  if (const auto found = state.causes.found()) state.difference = found;
  const auto map = state.precision.found();
  if (!map || map == state.map) return;
  state.map = map;
  state.textures[0].upload(map->faults);
  state.textures[1].upload(map->gaps);
  for (Texture& texture : state.textures) texture.set_shrunk(true);
}

namespace {

std::optional<std::string> share_value(const WhyTabState& state, std::string_view option) {
  if (!state.difference) return {};
  for (const CauseShare& cause : state.difference->causes)
    if (cause.option == option) return script_text(cause.share);
  return {};
}

std::optional<std::string> fault_value(const WhyTabState& state, std::string_view key) {
  if (!state.map) return {};
  for (std::size_t i = 1; i < precision_fault_count; ++i)
    if (fault_key(static_cast<PrecisionFault>(i)) == key) return script_text(state.map->map.counts[i]);
  return {};
}

}  // namespace

void offer_why_values(Values& out, const WhyTabState& state) {
  out.offer("why/running", [&state] { return state.running(); });
  out.offer_below("why/total", [&state](std::string_view rest) {
    return state.difference && rest.empty() ? std::optional(script_text(state.difference->total)) : std::nullopt;
  });
  out.offer_below("why/share/", [&state](std::string_view option) { return share_value(state, option); });
  out.offer_below("why/faults/", [&state](std::string_view key) { return fault_value(state, key); });
}

}  // namespace ps::gui
