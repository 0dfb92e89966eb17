#include "gui/panels/pictures/caption.h"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>

#include "gui/panels/pictures/picture_text.h"
#include "options/renderer_kind.h"

namespace ps::gui {

std::vector<CaptionWork> caption_work(const RenderResult& result) {
  std::vector<CaptionWork> work;
  // Work that this renderer does not count is not shown as 0.
  const auto sum = [&](std::initializer_list<Counter> counted) { return counted_sum(result.frame.counters, counted); };
  const auto add = [&](std::initializer_list<Counter> counted, const char* one) {
    if (const auto count = sum(counted)) work.push_back({*count, one});
  };
  if (const auto nan = sum({Counter::nan_pixels}).value_or(0); nan > 0) work.push_back({nan, "NaN pixel", true});
  switch (picture_way(result.request.settings.renderer)) {
  case PictureWay::rays:
    add({Counter::eye_rays, Counter::shadow_rays, Counter::reflection_rays, Counter::refraction_rays}, "ray");
    break;
  case PictureWay::fragments:
    if (sum({Counter::triangles_drawn}))
      add({Counter::triangles_drawn}, "triangle");
    else  // a graphics driver does not count what it draws
      add({Counter::triangles_in}, "submitted triangle");
    if (sum({Counter::lines_drawn}).value_or(0) > 0 && sum({Counter::fragments}).value_or(0) == 0)
      add({Counter::lines_drawn}, "line");
    else
      add({Counter::fragments}, "fragment");
    break;
  case PictureWay::listing:  // a listing does not count
    break;
  }
  return work;
}

std::string work_text(const CaptionWork& work, std::optional<std::uint64_t> before) {
  const std::string old = before ? count_text(*before) + " → " : "";
  return fmt::format("{}{} {}{}", old, count_text(work.count), work.one, work.count == 1 ? "" : "s");
}

std::string warm_time_text(const Quartiles& ms) {
  const double unit = ms.median >= 1000 ? 1000 : 1;
  return fmt::format("{} {} ({} to {})", three_digits(ms.median / unit), unit > 1 ? "s" : "ms",
                     three_digits(ms.q1 / unit), three_digits(ms.q3 / unit));
}

void CaptionChange::take(const std::shared_ptr<const RenderResult>& result, double now) {
  if (!result || result == newest_) return;
  const bool same_change = now - changed_ < one_change;
  if (!same_change) before_ = newest_ ? caption_work(*newest_) : std::vector<CaptionWork>();
  if (newest_ && newest_->request.scene.name != result->request.scene.name) before_.clear();
  newest_ = result;
  changed_ = now;
}

std::optional<std::uint64_t> CaptionChange::before(const CaptionWork& work, double now) const {
  if (left(now) <= 0) return {};
  const auto old =
      std::find_if(before_.begin(), before_.end(), [&](const CaptionWork& one) { return one.one == work.one; });
  // Two numbers that are shown alike would look like no change.
  if (old == before_.end() || count_text(old->count) == count_text(work.count)) return {};
  return old->count;
}

double CaptionChange::left(double now) const { return before_.empty() ? 0 : std::max(0.0, changed_ + shown_for - now); }

}  // namespace ps::gui
