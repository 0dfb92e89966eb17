#include <fmt/format.h>

#include <cmath>

#include "gui/work/background_study.h"

namespace ps::gui {

std::string status_text(const StudyStatus& status, std::string_view unit) {
  std::string text = fmt::format("{} of {} {}", status.done, status.total, unit);
  if (status.seconds_left < 0 || status.done >= status.total) return text;
  const double left = status.seconds_left;
  if (left < 90) return text + fmt::format(", {:.0f} s left", std::ceil(left));
  return text + fmt::format(", {:.0f} min left", std::ceil(left / 60));
}

}  // namespace ps::gui
