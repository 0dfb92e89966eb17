#include "gui/panels/studies/film_strip_view.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "gui/panels/studies/plot_frame.h"
#include "gui/widgets/widgets.h"

namespace ps::gui {
namespace {

void make(FilmStripState& state, const StabilityExperiment& experiment) {
  if (state.wanted == experiment.key) return;
  state.wanted = experiment.key;
  state.study.start([&experiment](StudyControl& control, const BackgroundStudy<FilmStrip>::Publish& publish) {
    auto picture = film_strip(experiment, {}, control.progress());
    if (picture)
      publish(std::make_shared<const FilmStrip>(FilmStrip{std::string(experiment.key), std::move(*picture)}),
              {1, 1, 0});
  });
}

}  // namespace

std::optional<double> film_strip_view(FilmStripState& state, const StabilityExperiment& experiment) {
  if (!experiment.picture || experiment.frames.empty()) return {};
  make(state, experiment);
  const auto found = state.study.found();
  if (!found || found->key != experiment.key) {
    ImGui::TextUnformatted(state.study.running() ? "Rendering the film strip." : "");
    return {};
  }
  if (found != state.shown) {
    state.shown = found;
    state.texture.upload(found->picture);
    state.texture.set_shrunk(true);
  }
  const auto w = static_cast<float>(state.texture.width()), h = static_cast<float>(state.texture.height());
  const float room_below = std::max(ImGui::GetContentRegionAvail().y - px(66), px(160));  // all rows in sight at once
  const float shrink =
      std::min({1.f, ImGui::GetContentRegionAvail().x / std::max(w, 1.f), room_below / std::max(h, 1.f)});
  const ImVec2 at = ImGui::GetCursorScreenPos(), size{std::floor(w * shrink), std::floor(h * shrink)};
  const auto frames = static_cast<float>(experiment.frames.size());
  ImFont* font = theme().font(Face::small);
  auto& list = *ImGui::GetWindowDrawList();
  const float line = font->FontSize + px(3);
  const std::string above = "Rows: naive, robust, where they differ. A click opens the frame in A and B.";
  const std::string below_it = fmt::format("Columns: {}.", experiment.knob);
  ImGui::Dummy({size.x, 2 * line});
  list.AddText(font, font->FontSize, at, colour_u32(palette().text_quiet), above.c_str());
  list.AddText(font, font->FontSize, {at.x, at.y + line}, colour_u32(palette().text_quiet), below_it.c_str());
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const bool clicked = ImGui::InvisibleButton("strip", {std::max(size.x, 1.f), std::max(size.y, 1.f)});
  controls().record("strip", std::string(experiment.key));
  const bool over = ImGui::IsItemHovered();
  list.AddImage(state.texture.id(), corner, {corner.x + size.x, corner.y + size.y});
  const float step = size.x / frames;
  const int under = over ? std::clamp(static_cast<int>((ImGui::GetIO().MousePos.x - corner.x) / step), 0,
                                      static_cast<int>(frames) - 1)
                         : -1;
  const ImVec2 below{corner.x, corner.y + size.y};
  float written_to = below.x;
  for (int i = 0; i < static_cast<int>(experiment.frames.size()); ++i) {
    const float left = corner.x + step * static_cast<float>(i);
    const std::string text = axis_number(experiment.frames[static_cast<std::size_t>(i)]);
    if (left + px(2) >= written_to) {  // else it would run into the one before
      list.AddText(font, font->FontSize, {left + px(2), below.y + px(2)}, colour_u32(palette().text), text.c_str());
      written_to = left + px(8) + font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, text.c_str()).x;
    }
    if (i == under) {
      list.AddRect({left, corner.y}, {left + step, below.y}, colour_u32(palette().attention), 0, 0, px(3));
      ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    }
    controls().record(fmt::format("frame/{}", i), {left, corner.y}, {left + step, below.y}, text);
  }
  ImGui::Dummy({size.x, line});
  if (!clicked || under < 0) return {};
  return experiment.frames[static_cast<std::size_t>(under)];
}

}  // namespace ps::gui
