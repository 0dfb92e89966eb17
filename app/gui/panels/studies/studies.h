#pragma once
#include <filesystem>
#include <functional>
#include <string>

#include "gui/panels/studies/chart_tab.h"
#include "gui/panels/studies/needs_tab.h"
#include "gui/panels/studies/stability_tab.h"
#include "gui/panels/studies/study_folder.h"
#include "gui/panels/studies/unsafe_line.h"
#include "gui/panels/studies/why_tab.h"

namespace ps::gui {

/// The tabs of long studies.
class Studies {
 public:
  /// `wake` may be called from any thread; `remember`: results are kept from one start to the next.
  Studies(const std::function<void()>& wake, bool remember);

  /// Takes up what has been found; once per frame. The views' own renders come first.
  void update(Session& session);
  /// Draws one of the tabs, named as in Document::layout ("chart", "stability", "needs", "why"); other names draw
  /// nothing. Answers whether to fill the window, or no longer.
  bool tab(const std::string& name, Session& session, const ChartHost& host, bool filled);
  /// A study is running and not paused.
  bool busy() const;
  /// What is going on, for the line at the lower edge; empty if nothing is.
  std::string status() const;
  void publish() const;

  /// Lines over pictures whose settings fail. Answers whether an experiment was asked for, which is then the one that
  /// the tab "stability" shows.
  bool unsafe(Session& session, const PicturesState& pictures);
  ChartTabState& chart() { return chart_; }

 private:
  StudyFolder folder_;
  ChartTabState chart_;
  StabilityTabState stability_;
  NeedsTabState needs_;
  WhyTabState why_;
  UnsafeState unsafe_;
};

}  // namespace ps::gui
