#include "gui/panels/studies/needs_tab.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>

#include "document/number_list.h"
#include "gui/panels/pictures/picture_text.h"
#include "gui/panels/studies/needs_known.h"
#include "gui/panels/studies/needs_view.h"
#include "gui/panels/studies/pause_and_stop.h"
#include "gui/widgets/widgets.h"
#include "options/option.h"
#include "options/scene_settings.h"
#include "study/needs_words.h"

namespace ps::gui {
namespace {

void measure(Session& session, NeedsTabState& state) {
  NeedsRequest request;
  request.scene = session.scene();
  request.view = session.view();
  request.base = session.settings(state.side);
  request.tolerance = state.tolerance;
  request.priority = WorkerPriority::background;
  state.measured_side = state.side;
  state.base = request.base;
  state.scene_name = session.document().scene_name;
  state.needs = nullptr;
  if (state.estimate.running()) {  // it would disturb the times
    state.estimate.cancel();
    state.estimated.clear();
  }
  state.study.start([request = std::move(request)](StudyControl& control, const NeedsStudy::Publish& publish) {
    const auto hand_over = [&](const Needs& needs, const StudyStatus& status) {
      publish(std::make_shared<const Needs>(needs), status);
    };
    StudyStatus last;
    const Needs needs = find_needs(request, control, [&](const Needs& now, const StudyStatus& status) {
      last = status;
      hand_over(now, status);
    });
    hand_over(needs, last);
  });
}

/// Begins to estimate what the search will take, if that is not known for these settings and this view.
void keep_estimate(const Session& session, NeedsTabState& state) {
  state.seen.now();
  const Document& document = session.document();
  const View view = session.view();
  std::string wanted =
      fmt::format("{} {}x{} {} {}", document.scene_name, view.width, view.height, camera_text(view.camera),
                  fmt::join(changed_options(session.settings(state.side)), ";"));
  for (const SceneEdit& edit : document.edits) wanted += fmt::format(" {}={}", edit.path, edit.value);
  if (state.estimated == wanted || state.study.running()) return;
  state.estimated = std::move(wanted);
  NeedsRequest request;
  request.scene = session.scene();
  request.view = view;
  request.base = session.settings(state.side);
  request.priority = WorkerPriority::background;
  state.estimate.start(
      [request = std::move(request)](StudyControl& control, const NeedsEstimateStudy::Publish& publish) {
        publish(std::make_shared<const NeedsEstimate>(estimate_needs(request, control)), {1, 1, 0});
      });
}

/// "Find out (at least about 12 s, 40 pictures)"
std::string measure_label(const NeedsTabState& state) {
  const char* word = state.needs ? "Find again" : "Find out";
  const auto estimate = state.estimate.found();
  if (!estimate)
    return fmt::format("{} ({})", word,
                       state.estimate.state() == StudyState::failed ? "time unknown" : "time not known yet");
  return fmt::format("{} (at least {})", word, estimate_text(estimate->least));
}

void run_buttons(Session& session, NeedsTabState& state, const std::string& label) {
  if (!state.study.running()) {
    const bool fits = button_width(label) <= ImGui::GetContentRegionAvail().x;
    if (button("measure", fits ? label : label.substr(0, label.find(" (")), Emphasis::primary,
               {.tooltip =
                    "Renders the scene without each feature, then searches for the cheapest settings. The time is "
                    "estimated from small pictures; each saving that is found adds a round."}))
      measure(session, state);
    return;
  }
  pause_and_stop(state.study, "What is found so far stays in the table.");
}

/// Answers whether to fill the window, or no longer.
bool toolbar(Session& session, NeedsTabState& state, bool filled) {
  static constexpr std::array sides{Choice{"a", "A", "Starts from the options of picture A."},
                                    Choice{"b", "B", "Starts from the options of picture B."}};
  int side = static_cast<int>(index_of(state.side));
  if (choice("side", sides, side, {.width = px(80)})) state.side = both_sides[static_cast<std::size_t>(side)];
  same_line_if_room(ImGui::CalcTextSize("Tolerance").x + px(116), px(12));
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Tolerance");
  tooltip("Maximum mean FLIP of any tile of about 16 x 16 pixels. 0.05 is hard to see, 0.3 is obvious.");
  ImGui::SameLine(0, px(6));
  number("tolerance", state.tolerance, {.minimum = 0, .maximum = 0.5},
         {.tooltip = "Drag it, or turn the wheel over it.", .width = px(110)});
  const std::string words = fmt::format("FLIP: {}", tolerance_words(state.tolerance));
  same_line_if_room(ImGui::CalcTextSize(words.c_str()).x, px(6));
  ImGui::AlignTextToFramePadding();
  value_text("tolerance-words", words);
  keep_estimate(session, state);
  const std::string label = measure_label(state);
  same_line_if_room(button_width(state.study.running() ? "Find again" : label), px(12));
  run_buttons(session, state, label);
  same_line_if_room(button_width("Fill"), px(8));
  return button_on_off("fill", "Fill", filled, {.tooltip = "Shows this table in the whole window (Esc)."});
}

std::string state_line(const NeedsTabState& state) {
  const StudyStatus status = state.study.status();
  const bool timing = state.needs && !state.needs->trail.empty() && state.needs->shares.size() == features().size();
  switch (state.study.state()) {
  case StudyState::none:
    return "";
  case StudyState::running:
    if (status.done == 0) return "Rendering the reference.";
    return fmt::format("{} pictures tried{}", status.done, timing ? "; searching for cheaper settings" : "");
  case StudyState::paused:
    return fmt::format("Paused after {} pictures.", status.done);
  case StudyState::cancelled:
    return fmt::format("Cancelled after {} pictures; the results so far are shown.", status.done);
  case StudyState::failed:
    return "Failed: " + state.study.message();
  case StudyState::done:
    return fmt::format("{}, options of {}: {} pictures tried.", state.scene_name, letter_of(state.measured_side),
                       status.done);
  }
  return "";
}

std::string steps_text(std::size_t count) { return fmt::format("{} step{}", count, count == 1 ? "" : "s"); }

void invitation(const NeedsTabState& state) {
  ImGui::Spacing();
  ImGui::PushStyleColor(ImGuiCol_Text, palette().text_quiet);
  ImGui::TextWrapped(
      "What does this scene need? Each feature is switched off once, to see how much of the picture and of the time "
      "depends on it. Then the cheapest settings are searched for whose worst tile differs by at most the tolerance.");
  if (const auto estimate = state.estimate.found())
    ImGui::TextWrapped("This takes at least %s. Each saving that is found adds a round (%s).",
                       estimate_text(estimate->least).c_str(), estimate_text(estimate->round).c_str());
  ImGui::PopStyleColor();
}

void wrapped(const char* name, const std::string& text) {
  ImGui::TextWrapped("%s", text.c_str());
  controls().record(name, text);
}

/// The needs of the scene in words: known as soon as every feature was tried.
void needs_in_words(const NeedsTabState& state) {
  const std::string text = needs_sentence(state.scene_name, *state.needs);
  if (text.empty()) return;
  const FontScope bold(Face::bold);
  wrapped("needs", text);
}

void advice(Session& session, NeedsTabState& state) {
  const Needs& needs = *state.needs;
  const NeedsAdvice words = needs_advice(needs, state.base);
  wrapped("verdict", words.verdict);
  if (words.changes.empty()) return;
  wrapped("words", fmt::format("Cheapest settings that stay within the tolerance: {}.", words.words));
  {
    const FontScope small(Face::small);
    ImGui::PushStyleColor(ImGuiCol_Text, palette().text_quiet);
    wrapped("changes", words.changes);
    wrapped("saving", words.saving);
    wrapped("time", words.time);
    ImGui::PopStyleColor();
  }
  const bool other_scene = session.document().scene_name != state.scene_name;
  const bool applied = session.settings(state.measured_side) == needs.advice;
  const std::string label = fmt::format("Apply to {}", letter_of(state.measured_side));
  if (button("apply", label, Emphasis::primary,
             {.tooltip = "Applies these settings. Undo restores the old ones.",
              .disabled = other_scene ? "Another scene is open."
                          : applied   ? "The picture has these settings."
                                      : ""}))
    session.set_settings(state.measured_side, needs.advice,
                         fmt::format("{}: what the scene needs", letter_of(state.measured_side)));
}

}  // namespace

void update_needs(NeedsTabState& state) {
  drop_unseen_estimate(state);
  if (const auto found = state.study.found()) state.needs = found;
}

bool needs_tab(Session& session, NeedsTabState& state, bool filled) {
  const NameScope scope("needs");
  if (!session.has_scene()) return false;
  const bool fill = toolbar(session, state, filled);
  {
    const FontScope small(Face::small);
    ImGui::PushStyleColor(ImGuiCol_Text, palette().text_quiet);
    value_text("status", state_line(state));
    ImGui::PopStyleColor();
  }
  ImGui::BeginChild("result");
  if (!state.needs) {
    needs_known(session.settings(state.side), session.traits(), letter_of(state.side));
    invitation(state);
  } else {
    needs_in_words(state);
    if (state.study.state() == StudyState::done) advice(session, state);
    needs_shares(*state.needs, state.study.state() == StudyState::done, state.thumbnails);
    if (!state.needs->trail.empty() &&
        section("trail", "The search", state.trail_open, steps_text(state.needs->trail.size())))
      needs_trail(*state.needs);
  }
  ImGui::EndChild();
  return fill;
}

namespace {

/// "shadows/used": what was found out about the feature of this name.
std::optional<std::string> feature_value(const NeedsTabState& state, std::string_view name) {
  if (!state.needs) return {};
  for (const FeatureShare& share : state.needs->shares) {
    const std::string feature = fmt::format("{}/", share.feature.name);
    if (!name.starts_with(feature)) continue;
    const std::string_view what = name.substr(feature.size());
    if (what == "used") return script_text(share.used);
    if (what == "error-without") return script_text(share.error_without);
    if (what == "work-share") return script_text(share.work_share);
  }
  return {};
}

std::optional<std::string> needs_value(const NeedsTabState& state, std::string_view name) {
  if (!state.needs) return {};
  const Needs& needs = *state.needs;
  if (name == "sentence") return needs_sentence(state.scene_name, needs);
  if (name == "error") return script_text(needs.error);
  if (name == "work") return script_text(needs.work);
  if (name == "default-work") return script_text(needs.default_work);
  if (name == "advice") return fmt::format("{}", fmt::join(settings_difference(state.base, needs.advice), ";"));
  return {};
}

}  // namespace

void offer_needs_values(Values& out, const NeedsTabState& state) {
  out.offer("needs/running", [&state] { return state.study.running(); });
  out.offer_below("needs/", [&state](std::string_view name) { return needs_value(state, name); });
  out.offer_below("needs/of/", [&state](std::string_view name) { return feature_value(state, name); });
}

}  // namespace ps::gui
