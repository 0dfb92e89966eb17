#include "gui/panels/studies/film_strip_view.h"

#include <fmt/format.h>
#include <imgui_internal.h>  // whether a window is out of sight

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "gui/widgets/draw.h"
#include "gui/widgets/widgets.h"
#include "study/stability/figures.h"

namespace ps::gui {
namespace {

constexpr FilmStripOptions strip_options{.frame_height = 240, .gap = 4};
constexpr int methods = 3;             // rows: naive, robust, where they differ
constexpr double largest_frame = 240;  // height in pixels at scale 1
constexpr double between_frames = 8, lines_height = 26;

/// A number as axes write it: "10⁻⁵" for a power of ten that would be long, else four significant digits.
std::string axis_number(double value) { return power_text(value, short_number(value)); }

/// Where the frames lie in the window.
struct FrameLayout {
  ImVec2 corner{0, 0};
  float slot = 0;  ///< width of a column
  ImVec2 frame{0, 0};
  ImVec2 of(int column, int row) const {
    return {std::round(corner.x + slot * static_cast<float>(column) + (slot - frame.x) / 2),
            std::round(corner.y + static_cast<float>(row) * (frame.y + px(4)))};
  }
  float height() const { return methods * frame.y + (methods - 1) * px(4); }
};

/// As large as the columns are wide. Rows that are out of sight are scrolled to.
FrameLayout layout_of(float width, int frames, float shape) {
  FrameLayout layout;
  layout.slot = width / static_cast<float>(frames);
  layout.frame.x = std::min(layout.slot - px(between_frames), px(largest_frame) * shape);
  layout.frame.y = layout.frame.x / shape;
  return layout;
}

/// Which frame of the strip is in each column: from left to right as on the axis above.
std::vector<int> columns_of(const StabilityExperiment& experiment, const PlotFrame* above) {
  std::vector<int> frames(experiment.frames.size());
  std::iota(frames.begin(), frames.end(), 0);
  const auto knob = [&](int i) { return experiment.frames[static_cast<std::size_t>(i)]; };
  if (above) std::stable_sort(frames.begin(), frames.end(), [&](int a, int b) { return knob(a) < knob(b); });
  return frames;
}

/// From the places of the knobs on the axis above down to their frames.
void join_to_axis(ImDrawList& list, const FrameLayout& layout, const std::vector<double>& knobs, const PlotFrame& above,
                  float top, float bottom) {
  for (std::size_t i = 0; i < knobs.size(); ++i) {
    const auto from = static_cast<float>(above.at(knobs[i], 0).x);
    const float to = layout.of(static_cast<int>(i), 0).x + layout.frame.x / 2;
    list.AddLine({from, top}, {to, bottom}, colour_u32(palette().line_strong), px(1));
    const auto foot = static_cast<float>(above.inner.high.y);
    list.AddTriangleFilled({from - px(4), foot + px(1)}, {from + px(4), foot + px(1)}, {from, foot - px(6)},
                           colour_u32(palette().text_quiet));
  }
}

void make(FilmStripState& state, const StabilityExperiment& experiment) {
  if (state.wanted == experiment.key) return;
  state.wanted = experiment.key;
  state.study.start([&experiment](StudyControl& control, const BackgroundStudy<FilmStrip>::Publish& publish) {
    auto picture = film_strip(experiment, strip_options, control.progress());
    if (picture)
      publish(std::make_shared<const FilmStrip>(FilmStrip{std::string(experiment.key), std::move(*picture)}),
              {1, 1, 0});
  });
}

/// The choice of another experiment is none of this one.
void forget_other(FilmStripState& state, const StabilityExperiment& experiment) {
  if (state.chosen_of != experiment.key) state.chosen.reset();
  state.chosen_of = experiment.key;
}

}  // namespace

std::optional<double> film_strip_slider(FilmStripState& state, const StabilityExperiment& experiment) {
  if (!experiment.picture || experiment.frames.size() < 2) return {};
  if (ImGui::GetCurrentWindow()->SkipItems) return {};  // nothing of the panel is in sight
  forget_other(state, experiment);
  std::vector<double> knobs(experiment.frames.begin(), experiment.frames.end());
  std::sort(knobs.begin(), knobs.end());
  const auto marked = state.chosen ? std::find(knobs.begin(), knobs.end(), *state.chosen) : knobs.end();
  const auto column = marked - knobs.begin();
  double place = marked == knobs.end() ? 1 : static_cast<double>(column) + 1;
  const std::string shown =
      marked == knobs.end() ? "none" : fmt::format("{} of {}: {}", column + 1, knobs.size(), axis_number(*marked));
  ImGui::AlignTextToFramePadding();
  show_text("Frame");
  ImGui::SameLine(0, px(8));
  const Edit edit =
      number("scrub", place, {.minimum = 1, .maximum = static_cast<double>(knobs.size()), .integer = true},
             {.tooltip = "Moves the line in the plot, the frame, and the pictures A and B together.",
              .width = std::min(px(200), ImGui::GetContentRegionAvail().x),
              .shown = shown});
  if (!edit.changed) return {};
  state.chosen = knobs[static_cast<std::size_t>(place) - 1];
  return state.chosen;
}

std::optional<double> film_strip_view(FilmStripState& state, const StabilityExperiment& experiment,
                                      const PlotFrame* above) {
  if (!experiment.picture || experiment.frames.empty()) return {};
  make(state, experiment);
  const auto found = state.study.found();
  if (!found || found->key != experiment.key) {
    show_text(state.study.running() ? "Rendering the film strip." : "");
    return {};
  }
  if (found != state.shown) {
    state.shown = found;
    state.texture.upload(found->picture);
    state.texture.set_shrunk(true);
  }
  const int frames = static_cast<int>(experiment.frames.size());
  const auto width = static_cast<float>(state.texture.width()), height = static_cast<float>(state.texture.height());
  const float gap = strip_options.gap, frame_height = strip_options.frame_height;
  const float frame_width = (width - gap * static_cast<float>(frames - 1)) / static_cast<float>(frames);
  forget_other(state, experiment);
  const std::vector<int> columns = columns_of(experiment, above);
  std::vector<double> knobs;
  knobs.reserve(columns.size());
  for (const int frame : columns) knobs.push_back(experiment.frames[static_cast<std::size_t>(frame)]);
  const auto marked = state.chosen ? std::find(knobs.begin(), knobs.end(), *state.chosen) : knobs.end();
  const int chosen = marked == knobs.end() ? -1 : static_cast<int>(marked - knobs.begin());
  auto& list = *ImGui::GetWindowDrawList();
  const float line = theme().font(Face::small)->FontSize + px(3), lines = above ? px(lines_height) : px(4);
  const ImVec2 at = ImGui::GetCursorScreenPos(), room = ImGui::GetContentRegionAvail();
  FrameLayout layout = layout_of(room.x, frames, frame_width / frame_height);
  layout.corner = {at.x, at.y + lines + line};
  if (above) join_to_axis(list, layout, knobs, *above, at.y, at.y + lines);
  for (int i = 0; i < frames; ++i) {
    const std::string text = axis_number(knobs[static_cast<std::size_t>(i)]);
    const FontScope small(Face::small);
    const float middle = layout.of(i, 0).x + layout.frame.x / 2;
    draw_lines({std::round(middle - text_width(text) / 2), at.y + lines}, text, palette().text);
  }
  ImGui::Dummy({room.x, lines + line});
  ImGui::SetCursorScreenPos(layout.corner);
  ImGui::InvisibleButton("strip", {room.x, std::max(layout.height(), 1.f)});
  const bool held = ImGui::IsItemActive();
  controls().record("strip", std::string(experiment.key));
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const int under = ImGui::IsItemHovered() || held
                        ? std::clamp(static_cast<int>((mouse.x - layout.corner.x) / layout.slot), 0, frames - 1)
                        : -1;
  for (int i = 0; i < frames; ++i) {
    const float u = (frame_width + gap) * static_cast<float>(columns[static_cast<std::size_t>(i)]) / width;
    for (int row = 0; row < methods; ++row) {
      const ImVec2 low = layout.of(i, row), high{low.x + layout.frame.x, low.y + layout.frame.y};
      const float v = (frame_height + gap) * static_cast<float>(row) / height;
      list.AddImage(state.texture.id(), low, high, {u, v}, {u + frame_width / width, v + frame_height / height});
    }
    const ImVec2 low = layout.of(i, 0), last = layout.of(i, methods - 1);
    const ImVec2 high{last.x + layout.frame.x, last.y + layout.frame.y};
    if (i == chosen) list.AddRect(low, high, colour_u32(palette().text), 0, 0, px(3));
    if (i == under) {
      list.AddRect(low, high, colour_u32(palette().text), 0, 0, px(5));
      list.AddRect(low, high, colour_u32(palette().attention), 0, 0, px(3));
      ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    }
    controls().record(fmt::format("frame/{}", i), low, high, axis_number(knobs[static_cast<std::size_t>(i)]));
  }
  show_text(fmt::format("Columns: {}. Rows: naive, robust, where they differ. A click or a drag shows "
                        "the frame in A and B.",
                        knob_title(experiment, experiment.series.front())),
            {Face::small, true});
  if (!held || under < 0 || under == chosen) return {};
  state.chosen = knobs[static_cast<std::size_t>(under)];
  return state.chosen;
}

}  // namespace ps::gui
