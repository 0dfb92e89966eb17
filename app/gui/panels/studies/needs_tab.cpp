#include "gui/panels/studies/needs_tab.h"

#include <fmt/format.h>
#include <imgui.h>

#include "gui/panels/pictures/picture_text.h"
#include "gui/panels/studies/needs_known.h"
#include "gui/widgets/widgets.h"
#include "options/option.h"
#include "options/scene_settings.h"
#include "study/needs_words.h"

namespace ps::gui {
namespace {

constexpr StudyWords needs_words{
    .name = "needs",
    .title = "Needs",
    .measure = "Find out",
    .again = "Find again",
    .help = "Renders the scene without each feature, then searches for the cheapest settings. The time is estimated "
            "from small pictures; each saving that is found adds a round.",
    .preparing = "rendering the reference",
    .unit = "pictures tried",
    .kept = "the results so far are shown"};

NeedsRequest request_for(const Session& session, Side side) {
  NeedsRequest request;
  request.scene = session.scene();
  request.view = session.view();
  request.base = session.settings(side);
  request.priority = WorkerPriority::background;
  return request;
}

std::string steps_text(std::size_t count) { return fmt::format("{} step{}", count, count == 1 ? "" : "s"); }

}  // namespace

OptionNeeds::OptionNeeds(const PanelHost& host) : EstimatedStudy(host, {}, needs_words) {}

NeedsTab::NeedsTab(const PanelHost& host, const StudyFolder& results)
    : StudyParts(host,
                 {.name = "needs",
                  .group = ToolGroup::measure,
                  .heading = "Needs",
                  .brief = "Needs",
                  .command = "Needs: what the scene can do without",
                  .help = "What the picture needs of options and model, and the least that stays within a tolerance."}),
      options_(host), model_(host, results) {
  add({{{"options", "Options", "The cheapest settings that stay within the tolerance."}, options_},
       {{"model", "Model", "Objects, triangles, texels, lights and bounces that no pixel would miss."}, model_}});
}

void OptionNeeds::measure(Session& session) {
  NeedsRequest request = request_for(session, side_);
  request.tolerance = tolerance_;
  measured_side_ = side_;
  base_ = request.base;
  scene_name_ = session.document().scene_name;
  start([request = std::move(request)](StudyControl& control, const Report& report) {
    const auto shared = [](const Needs& needs) { return std::make_shared<const Needs>(needs); };
    return shared(find_needs(request, control,
                             [&](const Needs& now, const StudyStatus& status) { report(status, shared(now)); }));
  });
}

void OptionNeeds::keep_estimate(Session& session) {
  if (estimate_lacks(picture_key(session, side_))) begin_estimate(estimate_needs, request_for(session, side_));
}

std::string OptionNeeds::expected() const {
  const auto known = estimate.found();
  return known ? fmt::format("{}, {} pictures", at_least(known->least.seconds), known->least.pictures) : unknown_time();
}

void OptionNeeds::choices(Session& session) {
  side_choice(session, side_, "Starts from the options of picture A.", "Starts from the options of picture B.");
  tolerance_control(tolerance_);
}

std::string OptionNeeds::about(const Session& session) const {
  if (!found) return why_not_b(session);
  return fmt::format("{}, options of {}: {} pictures tried.", scene_name_, letter_of(measured_side_),
                     work.status().done);
}

void OptionNeeds::invitation() const {
  ImGui::Spacing();
  quiet_text(
      "What does this scene need? Each feature is switched off once, to see how much of the picture and of the time "
      "depends on it. Then the cheapest settings are searched for whose worst tile differs by at most the tolerance.");
  if (const auto known = estimate.found())
    quiet_text(fmt::format("This takes {}. Each saving that is found adds a round ({}).",
                           at_least(known->least.seconds), estimate_text(known->round)));
}

void OptionNeeds::advice(Session& session) const {
  const NeedsAdvice words = needs_advice(*found, base_);
  value_paragraph("verdict", words.verdict);
  if (words.changes.empty()) return;
  value_paragraph("words", fmt::format("Cheapest settings that stay within the tolerance: {}.", words.words));
  for (const auto& [name, text] :
       {std::pair{"changes", words.changes}, std::pair{"saving", words.saving}, std::pair{"time", words.time}})
    value_paragraph(name, text, {Face::small, true});
  const char letter = letter_of(measured_side_);
  const bool other_scene = session.document().scene_name != scene_name_;
  const bool applied = session.settings(measured_side_) == found->advice;
  if (button("apply", fmt::format("Apply to {}", letter), Emphasis::primary,
             {.tooltip = "Applies these settings. Undo restores the old ones.",
              .disabled = other_scene ? "Another scene is open."
                          : applied   ? "The picture has these settings."
                                      : ""}))
    session.set_settings(measured_side_, found->advice, fmt::format("{}: what the scene needs", letter));
}

void OptionNeeds::draw_result(Session& session) {
  if (!found) {
    needs_known(session.settings(side_), session.traits(), letter_of(side_));
    return invitation();
  }
  const bool done = work.state() == StudyState::done;
  if (const std::string needs = needs_sentence(scene_name_, *found); !needs.empty())  // every feature was tried
    value_paragraph("needs", needs, {Face::bold});
  if (done) advice(session);
  needs_shares(*found, done, thumbnails_);
  if (!found->trail.empty() && section("trail", "The search", trail_open_, steps_text(found->trail.size())))
    needs_trail(*found);
}

namespace {

/// "shadows/used": what was found out about the feature of this name.
std::optional<std::string> feature_value(const Needs& needs, std::string_view name) {
  for (const FeatureShare& share : needs.shares) {
    const std::string feature = fmt::format("{}/", share.feature.name);
    if (!name.starts_with(feature)) continue;
    const std::string_view what = name.substr(feature.size());
    if (what == "used") return script_text(share.used);
    if (what == "error-without") return script_text(share.error_without);
    if (what == "work-share") return script_text(share.work_share);
  }
  return {};
}

}  // namespace

std::optional<std::string> OptionNeeds::value(std::string_view name) const {
  if (!found) return {};
  if (name == "sentence") return needs_sentence(scene_name_, *found);
  if (name == "error") return script_text(found->error);
  if (name == "work") return script_text(found->work);
  if (name == "default-work") return script_text(found->default_work);
  if (name == "advice") return fmt::format("{}", fmt::join(settings_difference(base_, found->advice), ";"));
  return {};
}

void OptionNeeds::offer_found(Values& out) const {
  out.offer_below("needs/", [this](std::string_view name) { return value(name); });
  out.offer_below("needs/of/",
                  [this](std::string_view name) { return found ? feature_value(*found, name) : std::nullopt; });
}

}  // namespace ps::gui
