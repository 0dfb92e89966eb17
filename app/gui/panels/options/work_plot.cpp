#include "gui/panels/options/work_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gui/panels/pictures/picture_text.h"
#include "gui/panels/pictures/picture_transform.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/widgets.h"

namespace ps::gui {
namespace {

constexpr double plot_height = 62;  // at scale 1, without its two lines of text

/// One number of a picture; nullopt where there is none.
using Measure = std::optional<double> (*)(const WorkOfStep::Picture&);

std::optional<double> time_of(const WorkOfStep::Picture& picture) { return picture.milliseconds; }
std::optional<double> work_of(const WorkOfStep::Picture& picture) {
  return picture.work ? std::optional(static_cast<double>(*picture.work)) : std::nullopt;
}

struct Plot {
  const char* name;
  const char *title, *brief;  ///< the latter where the plot is narrow
  Measure measure;
  std::string (*text)(double);
};

std::string milliseconds_text(double value) { return two_digits(value) + " ms"; }
std::string count_words(double value) { return count_text(static_cast<std::uint64_t>(value)); }

std::optional<double> value_of(const WorkOfStep& step, Side side, Measure measure) {
  const auto& picture = step.pictures[index_of(side)];
  return picture ? measure(*picture) : std::nullopt;
}

/// A is a disc, B a square: not colour alone.
void mark(ImDrawList& list, ImVec2 at, Side side, bool large) {
  const float size = px(large ? 5 : 3.5);
  const ImU32 colour = colour_u32(side == Side::a ? palette().a : palette().b);
  if (side == Side::a)
    list.AddCircleFilled(at, size, colour);
  else
    list.AddRectFilled({at.x - size, at.y - size}, {at.x + size, at.y + size}, colour);
}

std::optional<std::uint64_t> draw_plot(const Plot& plot, const WorkLog& log, std::uint64_t now, float width) {
  const NameScope scope(plot.name);
  const FontScope small(Face::small);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float line = ImGui::GetTextLineHeight();
  double largest = 0;
  for (const WorkOfStep& step : log.steps())
    for (const Side side : both_sides) largest = std::max(largest, value_of(step, side, plot.measure).value_or(0));
  draw_text(at, {at.x + width, at.y + line}, text_width(plot.title) <= width ? plot.title : plot.brief, palette().text,
            0);
  std::string range = largest > 0 ? fmt::format("0 to {}", plot.text(largest)) : "nothing counted";
  if (largest > 0 && text_width(range) > width) range = plot.text(largest);
  draw_text({at.x, at.y + line}, {at.x + width, at.y + 2 * line}, range, palette().text_quiet, 0);
  const Area area{{at.x, at.y + 2 * line + px(4)}, {at.x + width, at.y + 2 * line + px(4 + plot_height)}};
  list.AddRectFilled(area.min, area.max, colour_u32(palette().field), px(2));
  list.AddLine({area.min.x, area.max.y}, area.max, colour_u32(palette().line_strong), px(1));

  std::optional<std::uint64_t> clicked;
  const auto count = log.steps().size();
  const float margin = px(8), pitch = count > 1 ? (width - 2 * margin) / static_cast<float>(count - 1) : 0;
  const auto place = [&](std::size_t i, double value) {
    const double share = largest > 0 ? value / largest : 0;
    return ImVec2{area.min.x + margin + pitch * static_cast<float>(i),
                  area.max.y - px(5) - (area.height() - px(10)) * static_cast<float>(share)};
  };
  for (const Side side : both_sides) {
    std::optional<ImVec2> before;
    for (std::size_t i = 0; i < count; ++i) {
      const auto value = value_of(log.steps()[i], side, plot.measure);
      if (!value) {
        before.reset();
        continue;
      }
      const ImVec2 here = place(i, *value);
      if (before) list.AddLine(*before, here, colour_u32(side == Side::a ? palette().a : palette().b), px(1.5));
      before = here;
    }
  }
  const float half = std::clamp(pitch / 2, px(3), px(12));
  for (std::size_t i = 0; i < count; ++i) {
    const WorkOfStep& step = log.steps()[i];
    const float x = place(i, 0).x;
    std::string text;
    for (const Side side : both_sides) {
      const auto value = value_of(step, side, plot.measure);
      if (!value) continue;
      mark(list, place(i, *value), side, step.step == now);
      text += fmt::format("{}{} {}", text.empty() ? "" : "   ", letter_of(side), plot.text(*value));
    }
    ImGui::SetCursorScreenPos({x - half, area.min.y});
    const std::string name = fmt::format("point/{}", i);
    if (ImGui::InvisibleButton(full_name(name).c_str(), {2 * half, area.height()})) clicked = step.step;
    controls().record(name, text);
    tooltip(text + "\nA click goes to this step.");
  }
  ImGui::SetCursorScreenPos(at);
  ImGui::Dummy({width, area.max.y - at.y});
  return clicked;
}

}  // namespace

float work_plots_height() {
  const FontScope small(Face::small);
  return 2 * ImGui::GetTextLineHeight() + px(plot_height + 10);
}

std::optional<std::uint64_t> work_plots(const WorkLog& log, std::uint64_t now) {
  const float space = px(8), width = std::floor((ImGui::GetContentRegionAvail().x - space) / 2);
  const auto time = draw_plot({"time-of-steps", "Time, one run", "Time", time_of, milliseconds_text}, log, now, width);
  ImGui::SameLine(0, space);
  const auto work = draw_plot({"work-of-steps", "Counted work", "Work", work_of, count_words}, log, now, width);
  return time ? time : work;
}

}  // namespace ps::gui
