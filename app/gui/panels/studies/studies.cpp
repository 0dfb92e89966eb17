#include "gui/panels/studies/studies.h"

#include <fmt/format.h>

namespace ps::gui {
namespace {

bool rendering(Session& session) {
  for (const Side side : both_sides) {
    const auto state = session.renderer(side).status().state;
    if (state == RenderState::coarse || state == RenderState::full) return true;
  }
  return false;
}

}  // namespace

Studies::Studies(const std::function<void()>& wake, bool remember)
    : folder_(remember), chart_(wake), stability_(wake), needs_(wake), why_(wake), unsafe_(wake) {
  stability_.folder = folder_.of("stability");
}

void Studies::update(Session& session) {
  const bool held = rendering(session);
  chart_.study.set_held(held);
  chart_.estimate.set_held(held);
  needs_.study.set_held(held);
  needs_.estimate.set_held(held);
  stability_.study.set_held(held);
  why_.causes.set_held(held);
  update_chart(session, chart_);
  update_stability(session, stability_, folder_.scenes());
  update_needs(needs_);
  update_why(why_);
  update_unsafe(session, unsafe_);
}

bool Studies::tab(const std::string& name, Session& session, const ChartHost& host, bool filled) {
  if (name == "chart") return chart_tab(session, chart_, folder_, host, filled);
  if (name == "stability") return stability_tab(session, stability_, filled);
  if (name == "needs") return needs_tab(session, needs_, filled);
  if (name == "why") return why_tab(session, why_, filled);
  return false;
}

bool Studies::busy() const {
  return chart_.study.state() == StudyState::running || chart_.estimate.running() ||
         needs_.study.state() == StudyState::running || needs_.estimate.running() || stability_busy(stability_) ||
         why_.causes.running() || why_.precision.running() || unsafe_.sides[0].study.running() ||
         unsafe_.sides[1].study.running();
}

bool Studies::unsafe(Session& session, const PicturesState& pictures) {
  const auto wanted = unsafe_lines(session, unsafe_, pictures);
  if (wanted) show_experiment(stability_, *wanted);
  return wanted.has_value();
}

std::string Studies::status() const {
  if (chart_.study.state() == StudyState::running) {
    const StudyStatus status = chart_.study.status();
    return status.total > 0 ? "Chart: " + status_text(status, "runs") : "Chart: rendering the reference";
  }
  if (needs_.study.state() == StudyState::running)
    return fmt::format("Needs: {} pictures tried", needs_.study.status().done);
  if (stability_.study.state() == StudyState::running)
    return "Stability: " + status_text(stability_.study.status(), "experiments");
  if (stability_.opening.running()) return "Stability: opening a point";
  if (why_.causes.running()) return "Causes: rendering pictures between A and B";
  if (why_.precision.running()) return "Precision: rendering in double";
  return {};
}

void Studies::publish() const {
  publish_chart(chart_);
  publish_stability(stability_);
  publish_needs(needs_);
  publish_why(why_);
  publish_unsafe(unsafe_);
}

}  // namespace ps::gui
