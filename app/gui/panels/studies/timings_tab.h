#pragma once
#include <array>
#include <memory>
#include <string>

#include "gui/panels/studies/study.h"
#include "study/pair_timing.h"

namespace ps::gui {

/// Times of both pictures, with what was timed.
struct FoundTiming {
  std::array<PictureRequest, 2> requests;
  PairTiming timing;
};

/// Stage times and counters of A and B side by side. Times of both by turns on a button, with their ratio; before,
/// those of the single runs.
struct TimingsTab : Study<FoundTiming> {
  explicit TimingsTab(const PanelHost& host);
  void measure(Session& session) override;
  bool measures_times() const override { return measuring(); }

 protected:
  void draw_result(Session& session) override;
  std::string about(const Session& session) const override { return why_not_b(session); }
  std::string measure_word() const override { return std::string(words_.measure); }
  std::string reason_against(Session& session) const override;
  /// Stops as well when the pictures have become others.
  void take_up(Session& session) override;
  void took(Session& session) override;
  void offer_found(Values& out) const override;
};

/// "B takes 4.6 times as long as A (4.4 to 4.9; 9 rounds).", or that there is no order within noise.
std::string ratio_sentence(const PairTiming& timing);

}  // namespace ps::gui
