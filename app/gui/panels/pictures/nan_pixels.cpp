#include "gui/panels/pictures/nan_pixels.h"

#include <algorithm>
#include <cmath>

#include "gui/theme/theme.h"
#include "math/has_nan.h"

namespace ps::gui {
namespace {

constexpr std::size_t most_runs = 20'000;  // more would not be seen as such
constexpr double least_size = 5;           // window pixels at scale 1
constexpr double lowest_slanted = 3;       // the same: lower runs have no room for slanting lines
const ImU32 magenta = IM_COL32(255, 0, 255, 255);
const ImU32 hatch_black = IM_COL32(0, 0, 0, 255);

/// The part of the hatch in a run that is about a window pixel high: a dash wherever a line of the hatch crosses it.
void dashes(ImDrawList& list, ImVec2 low, ImVec2 high) {
  const float step = std::round(px(10)), thick = std::round(px(3)), y = std::floor(low.y);
  const float bottom = std::max(high.y, y + 1);
  for (float sum = std::floor((low.x + y) / step) * step; sum - y < high.x; sum += step) {
    const float from = std::max(sum - y, low.x), to = std::min(sum - y + thick, high.x);
    if (to > from) list.AddRectFilled({from, y}, {to, bottom}, hatch_black);
  }
}

/// Magenta with slanting hatch_black lines that go on from one run to the next.
void hatch(ImDrawList& list, ImVec2 low, ImVec2 high) {
  list.AddRectFilled(low, high, magenta);
  const float step = px(7), height = high.y - low.y;
  if (height < px(lowest_slanted)) return dashes(list, low, high);
  list.PushClipRect(low, high, true);
  for (float sum = std::floor((low.x + low.y) / step) * step; sum < high.x + high.y; sum += step) {
    const float x = sum - low.y;
    list.AddLine({x, low.y}, {x - height, high.y}, hatch_black, px(2));
  }
  list.PopClipRect();
}

}  // namespace

void NanPixels::find(const std::shared_ptr<const RenderResult>& result) {
  found_in_ = result;
  runs_.clear();
  if (!result || result->frame.counters.get(Counter::nan_pixels) == 0u) return;
  const auto& colour = result->frame.colour;
  for (int y = 0; y < colour.height() && runs_.size() < most_runs; ++y)
    for (int x = 0; x < colour.width(); ++x) {
      if (!has_nan(colour.at(x, y))) continue;
      const int first = x;
      while (x < colour.width() && has_nan(colour.at(x, y))) ++x;
      runs_.push_back({first, y, x, y + 1});
    }
}

void NanPixels::draw(ImDrawList& list, const std::shared_ptr<const RenderResult>& result,
                     const PictureTransform& transform, const Area& area) {
  if (found_in_ != result) find(result);
  list.PushClipRect(area.min, area.max, true);
  for (const TileRect& run : runs_) {
    ImVec2 low = transform.to_window({run.x0, run.y0}, area), high = transform.to_window({run.x1, run.y1}, area);
    if (high.y < area.min.y || low.y > area.max.y) continue;
    const float grow_x = std::max(0.f, (px(least_size) - (high.x - low.x)) / 2);
    const bool alone = runs_.size() < 200;  // a few must not be overlooked; many must not cover their neighbours
    const float grow_y = alone ? std::max(0.f, (px(least_size) - (high.y - low.y)) / 2) : 0;
    low = {low.x - (alone ? grow_x : 0), low.y - grow_y};
    high = {high.x + (alone ? grow_x : 0), high.y + grow_y};
    hatch(list, low, high);
  }
  list.PopClipRect();
}

}  // namespace ps::gui
