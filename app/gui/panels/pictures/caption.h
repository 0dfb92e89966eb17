#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/statistics.h"
#include "gui/work/render_worker.h"

namespace ps::gui {

/// Work below a picture: "37 triangles". Counted, so exact and the same on every machine.
struct CaptionWork {
  std::uint64_t count = 0;
  std::string one;         ///< "triangle"
  bool attention = false;  ///< worth more attention than all the others
};
/// Work of a finished picture, the most important first.
std::vector<CaptionWork> caption_work(const RenderResult& result);
/// "37 triangles", or "19 → 37 triangles" where it was another number before.
std::string work_text(const CaptionWork& work, std::optional<std::uint64_t> before = {});

/// "23.5 ms (22.9 to 24.4)": the median and the quartiles of warm runs.
std::string warm_time_text(const Quartiles& milliseconds);

/// Counts of a picture before its last change, for some seconds. Changes in quick succession, as in a drag,
/// count as one.
class CaptionChange {
 public:
  static constexpr double shown_for = 6;   ///< seconds
  static constexpr double one_change = 1;  ///< seconds between two pictures of the same change

  /// The newest finished picture; once per frame. `now` in seconds on the window's clock.
  void take(const std::shared_ptr<const RenderResult>& result, double now);
  /// The count of the same work before; nullopt if its text has not changed, or long ago.
  std::optional<std::uint64_t> before(const CaptionWork& work, double now) const;
  /// Seconds until before() returns nullopt; 0 if it does already.
  double left(double now) const;

 private:
  std::shared_ptr<const RenderResult> newest_;
  std::vector<CaptionWork> before_;
  double changed_ = -1e9;  // when newest_ came
};

}  // namespace ps::gui
