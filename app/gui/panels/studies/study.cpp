#include "gui/panels/studies/study.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "base/sentence.h"
#include "document/number_list.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/widgets.h"
#include "options/option.h"
#include "options/scene_settings.h"
#include "study/needs_words.h"

namespace ps::gui {
namespace {

constexpr double between_controls = 8, enough_height = 320, least_result = 110;  // pixels at scale 1
constexpr const char* long_estimate = "at least 100 min, 1000 pictures";         // hardly any is longer

/// As many whole sentences from the beginning as fit into one line.
std::string sentences_that_fit(const std::string& text, float width) {
  std::string fitting = text;
  while (text_width(fitting, Face::small) > width) {
    const auto end = fitting.rfind(". ");
    if (end == std::string::npos) break;
    fitting.resize(end + 1);
  }
  return fitting;
}

/// Without the time that is left.
std::string count_of(const StudyStatus& status, std::string_view unit) {
  return status_text({status.done, status.total, -1}, unit);
}

/// "rendering the reference, 12 %", or how much is done.
std::string progress_text(const BackgroundWork& work, const StudyWords& words) {
  std::string counted = status_text(work.status(), words.unit);
  if (!counted.empty()) return counted;
  return fmt::format("{}, {:.0f} %", words.preparing, 100 * work.fraction_of_render());
}

/// Share of all that is done; of the first picture before its units can be counted.
double fraction_of(const BackgroundWork& work) {
  const StudyStatus status = work.status();
  if (status.total > 0) return static_cast<double>(status.done) / status.total;
  return status.done > 0 ? 0 : work.fraction_of_render();
}

float pause_width() { return std::max(button_width("Go on"), button_width("Pause")); }

/// The buttons `pause` and `cancel` of a study that runs.
void pause_and_stop(BackgroundWork& work, const StudyWords& words) {
  if (!words.unit.empty()) {
    const bool paused = work.state() == StudyState::paused;
    if (button("pause", paused ? "Go on" : "Pause", Emphasis::plain, {.width = pause_width()}))
      work.set_paused(!paused);
    ImGui::SameLine(0, px(3));
  }
  const std::string help = words.kept.empty() ? "" : begun_large(std::string(words.kept)) + ".";
  if (button("cancel", "Stop", Emphasis::plain, {.tooltip = help, .width = 0})) work.cancel();
}

float pause_and_stop_width(const StudyWords& words) {
  return (words.unit.empty() ? 0 : pause_width() + px(3)) + button_width("Stop");
}

}  // namespace

std::string status_text(const StudyStatus& status, std::string_view unit) {
  if (status.total == 0) return status.done > 0 ? fmt::format("{} {}", status.done, unit) : "";
  std::string text = fmt::format("{} of {} {}", status.done, status.total, unit);
  if (status.seconds_left < 0 || status.done >= status.total) return text;
  const double left = status.seconds_left;
  if (left < 90) return text + fmt::format(", {:.0f} s left", std::ceil(left));
  return text + fmt::format(", {:.0f} min left", std::ceil(left / 60));
}

std::string why_not_b(const Session& session) {
  const auto file = session.picture_b();
  if (!file) return {};
  return fmt::format("B is the picture file {}: it has no options, and is not rendered.",
                     std::filesystem::path(file->path).filename().string());
}

void side_choice(const Session& session, Side& side, std::string_view help_a, std::string_view help_b) {
  const std::array sides{Choice{"a", "A", help_a}, Choice{"b", "B", help_b}};
  const std::string only_a = why_not_b(session);
  if (!only_a.empty()) side = Side::a;
  choice_of("side", sides, side, {.disabled = only_a, .width = px(80)});
}

bool StudyFrame::busy() const { return measuring() || (estimate_ && estimate_->running()); }

std::string StudyFrame::status() const {
  return measuring() ? fmt::format("{}: {}", words_.title, progress_text(work_, words_)) : "";
}

void StudyFrame::offer(Values& out) {
  const std::string name(words_.name);
  out.offer(name + "/running", [this] { return work_.running(); });
  out.offer(name + "/paused", [this] { return work_.state() == StudyState::paused; });
  if (estimate_) out.offer(name + "/estimating", [this] { return estimate_->running(); });
  offer_found(out);
}

void StudyFrame::update() {
  work_.set_held(session_.work().rendering());
  if (estimate_) estimate_->set_held(session_.work().rendering());
  if (!seen_.lately()) drop_estimate();
  take_up(session_);
}

bool StudyFrame::estimate_lacks(const std::string& key) {
  if (estimated_ == key || work_.running()) return false;
  estimated_ = key;
  return true;
}

const char* StudyFrame::unknown_time() const {
  return estimate_ && estimate_->state() == StudyState::failed ? "time unknown" : "time not known yet";
}

void StudyFrame::drop_estimate() {
  if (!estimate_ || !estimate_->running()) return;
  estimate_->cancel();
  estimated_.clear();
}

void StudyFrame::run_buttons(Session& session, const std::string& word, const std::string& label) {
  if (work_.running()) return pause_and_stop(work_, words_);
  const bool fits = button_width(label) <= ImGui::GetContentRegionAvail().x;
  if (button("measure", fits ? label : word, Emphasis::primary,
             {.tooltip = words_.help, .disabled = reason_against(session)}))
    measure(session);
}

bool StudyFrame::toolbar(Session& session, bool filled) {
  const ImVec2 start = ImGui::GetCursorPos();
  choices(session);
  keep_estimate(session);
  const std::string word = measure_word(), known = expected();
  const std::string label = known.empty() ? word : fmt::format("{} ({})", word, known);
  // The buttons stay in their line when the estimate comes: the pointer may be on its way to them.
  const float widest = known.empty() ? button_width(word) : button_width(fmt::format("{} ({})", word, long_estimate));
  if (ImGui::GetCursorPosY() > start.y)
    same_line_if_room(std::max(widest, pause_and_stop_width(words_)), px(between_controls));
  const float end = ImGui::GetCursorScreenPos().x + pause_and_stop_width(words_);
  run_buttons(session, word, label);
  if (const float rest = end - ImGui::GetItemRectMax().x; rest > 0) {  // no button comes to lie under the pointer
    ImGui::SameLine(0, 0);
    ImGui::Dummy({rest, ImGui::GetFrameHeight()});
  }
  more_controls(session);
  return fill_button(filled, "Shows this panel in the whole window (Esc).");
}

std::string StudyFrame::state_line(const Session& session) const {
  const std::string counted = count_of(work_.status(), words_.unit);
  switch (work_.state()) {
  case StudyState::running:
    return begun_large(progress_text(work_, words_));
  case StudyState::paused:
    return counted.empty() ? "Paused." : fmt::format("Paused after {}.", counted);
  case StudyState::failed:
    return "Failed: " + work_.message();
  case StudyState::cancelled:
    if (!says_stopped()) break;
    if (counted.empty()) return "Stopped.";
    return fmt::format("Stopped after {}{}{}.", counted, words_.kept.empty() ? "" : "; ", words_.kept);
  case StudyState::done:
  case StudyState::none:
    break;
  }
  return about(session);
}

/// Wrapped where the result has height to spare, else one line; with a bar under it while it runs.
void StudyFrame::status_line(const Session& session) const {
  const ImVec2 at = ImGui::GetCursorScreenPos(), room = ImGui::GetContentRegionAvail();
  const std::string text = state_line(session);
  const std::string shown = room.y >= px(enough_height) && !work_.running() ? text : sentences_that_fit(text, room.x);
  show_paragraph(shown, {Face::small, true});
  if (shown != text) tooltip(text);
  controls().record("status", text);
  if (!work_.running()) return;
  auto& list = *ImGui::GetWindowDrawList();
  const float y = ImGui::GetItemRectMax().y, end = at.x + room.x * static_cast<float>(fraction_of(work_));
  list.AddRectFilled({at.x, y}, {at.x + room.x, y + px(2)}, colour_u32(palette().line));
  list.AddRectFilled({at.x, y}, {end, y + px(2)}, colour_u32(palette().text_quiet));
}

PanelFacts study_facts(PanelFacts of) {
  of.use = PanelUse::study;
  of.height = PanelHeight::tall;
  return of;
}

bool StudyParts::draw(const Context& context) {
  const NameScope scope(facts.name);
  if (!session_.has_scene()) return false;
  std::vector<Choice> choices;
  std::vector<StudyFrame*> studies;
  int index = 0;
  float width = 0;
  for (const Part& part : parts_) {
    if (part.applies && !part.applies()) continue;
    if (part.choice.key == shown_) index = static_cast<int>(choices.size());
    width += button_width(part.choice.label);
    choices.push_back(part.choice);
    studies.push_back(&part.study);
  }
  if (choice("shown", choices, index, {.width = width})) shown_ = choices[static_cast<std::size_t>(index)].key;
  same_line_if_room(button_width("Find again"), px(between_controls));
  return studies[static_cast<std::size_t>(index)]->draw_part(context.filled);
}

void StudyParts::offer(Values& out) {
  for (const Part& part : parts_) part.study.offer(out);
}

void StudyParts::update() {
  for (const Part& part : parts_) part.study.update();
}

bool StudyParts::busy() const {
  return std::any_of(parts_.begin(), parts_.end(), [](const Part& part) { return part.study.busy(); });
}

bool StudyParts::measures_times() const {
  return std::any_of(parts_.begin(), parts_.end(), [](const Part& part) { return part.study.measures_times(); });
}

std::string StudyParts::status() const {
  for (const Part& part : parts_)
    if (std::string text = part.study.status(); !text.empty()) return text;
  return {};
}

std::string scene_key(const Session& session) {
  const Document& document = session.document();
  std::string text = document.scene_name;
  std::error_code error;
  const auto time = std::filesystem::last_write_time(document.scene_name, error);
  if (!error) text += fmt::format(" {}", time.time_since_epoch().count());
  for (const SceneEdit& edit : document.edits) text += fmt::format(" {}={}", edit.path, edit.value);
  return text + " " + camera_text(session.view().camera);
}

std::string picture_key(const Session& session, Side side) {
  const View view = session.view();
  return fmt::format("{} {}x{} {}", scene_key(session), view.width, view.height,
                     fmt::join(changed_options(session.settings(side)), ";"));
}

void tolerance_control(double& tolerance) {
  same_line_if_room(text_width("Tolerance") + px(116), px(12));
  ImGui::AlignTextToFramePadding();
  show_text("Tolerance");
  tooltip("Maximum mean FLIP of any tile of about 16 x 16 pixels. 0.05 is hard to see, 0.3 is obvious.");
  ImGui::SameLine(0, px(6));
  number("tolerance", tolerance, {.minimum = 0, .maximum = 0.5},
         {.tooltip = "Drag it, or turn the wheel over it.", .width = px(110)});
  const std::string words = fmt::format("FLIP: {}", tolerance_words(tolerance));
  same_line_if_room(text_width(words), px(6));
  ImGui::AlignTextToFramePadding();
  value_text("tolerance-words", words);
}

bool StudyFrame::draw(const Context& context) {
  const NameScope scope(facts.name);
  return draw_part(context.filled);
}

bool StudyFrame::draw_part(bool filled) {
  if (!has_subject(session_)) return false;
  seen_.now();
  follow(session_);
  const bool fill = toolbar(session_, filled);
  begin_tool_content();
  status_line(session_);
  // Where the lines above leave too little, the panel is scrolled.
  ImGui::BeginChild("result", {0, std::max(ImGui::GetContentRegionAvail().y, px(least_result))});
  draw_result(session_);
  ImGui::EndChild();
  return fill;
}

}  // namespace ps::gui
