#include "gui/panels/options/work_log.h"

#include <algorithm>

#include "study/counted_work.h"

namespace ps::gui {

void WorkLog::note(const WorkOfStep& work) {
  const auto known =
      std::find_if(steps_.begin(), steps_.end(), [&](const WorkOfStep& step) { return step.step == work.step; });
  if (known != steps_.end()) {
    *known = work;
    return;
  }
  steps_.push_back(work);
  if (steps_.size() > most_steps) steps_.erase(steps_.begin());
}

void WorkLog::update(Session& session) {
  const History* history = session.history();
  if (!history || session.busy()) return;
  const std::array results{session.renderer(Side::a).result(),
                           session.picture_b() ? nullptr : session.renderer(Side::b).result()};
  const std::uint64_t step = history->entries()[history->place()].id;
  if (!results[0] || (results == noted_ && step == noted_step_)) return;
  noted_ = results;
  noted_step_ = step;
  WorkOfStep work{step, {}};
  for (std::size_t i = 0; i < results.size(); ++i)
    if (results[i]) work.pictures[i] = {results[i]->milliseconds, counted_work(results[i]->frame.counters)};
  note(work);
}

}  // namespace ps::gui
