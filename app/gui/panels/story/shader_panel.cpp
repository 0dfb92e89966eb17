#include "gui/panels/story/shader_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "gui/panels/story/listing_code.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/widgets.h"
#include "render/renderer_table.h"
#include "render/story/names.h"

namespace ps::gui {
namespace {

constexpr double stage_width = 180, draw_width = 220, file_width = 170;

ShadersFound find_shaders(const ShaderRequest& request, Progress& progress, Prepared& prepared) {
  try {
    const PictureRequest& picture = request.picture;
    return {renderer_row(picture.settings.renderer)
                .shaders(picture.scene, picture.view, picture.settings, request.pixel, prepared, progress),
            {}};
  } catch (const InputError& error) {
    return {nullptr, error.what()};
  }
}

bool same_shaders(const ShaderRequest& a, const ShaderRequest& b) {
  return same_render(a.picture, b.picture) && a.pixel == b.pixel && a.reloads == b.reloads;
}

/// The draw call that is shown; nullptr if there is none.
const ShaderDraw* shown_draw(const ShaderPanelState& state) {
  if (!state.shown || !state.shown->listing || state.shown->listing->draws.empty()) return nullptr;
  const auto& draws = state.shown->listing->draws;
  return &draws[std::min(static_cast<std::size_t>(state.draw), draws.size() - 1)];
}

void choose_draw(ShaderPanelState& state) {
  const auto& draws = state.shown->listing->draws;
  if (draws.size() < 2) return;
  std::vector<Choice> choices;
  choices.reserve(draws.size());
  for (const ShaderDraw& draw : draws) choices.push_back({draw.pass, draw.pass, ""});
  int index = std::min(state.draw, static_cast<int>(draws.size()) - 1);
  same_line_if_room(px(draw_width));
  if (drop_down("pass", choices, index, px(draw_width),
                {.tooltip = "The programs that draw this pixel, in drawing order."}))
    state.draw = index;
}

void choose_stage(ShaderPanelState& state) {
  static constexpr std::array stages{
      Choice{"vertex", "Vertex", "The shader that places each vertex of the triangle."},
      Choice{"fragment", "Fragment", "The shader that gives each pixel of the triangle its colour."}};
  same_line_if_room(px(stage_width));
  choice_of("part", stages, state.stage, {.tooltip = "The shader.", .width = px(stage_width)});
}

void look_at(ShaderPanelState& state, int row) {
  state.marks.first = row;
  state.reveal = true;
}

void go_to_file(ShaderPanelState& state) {
  std::vector<Choice> choices{{"go-to", "Go to ...", ""}, {"definitions", "Definitions", ""}};
  for (const ShaderFilePlace& file : state.files) choices.push_back({file.name, file.name, ""});
  int index = 0;
  same_line_if_room(px(file_width));
  if (!drop_down("file", choices, index, px(file_width),
                 {.tooltip = "The definitions, the file with main(), and those that it includes."}))
    return;
  look_at(state, index == 1 ? 1 : state.files[static_cast<std::size_t>(index - 2)].row);
}

/// A text of another file is shown from where that begins, or from the line that a message is about.
void keep_rows(ShaderPanelState& state, const ShaderDraw& draw) {
  const ShaderText& text = text_of(draw.shaders, state.stage);
  std::string of = fmt::format("{} {}", state.draw, static_cast<int>(state.stage));
  if (of == state.rows_of) return;
  const std::vector<ShaderFilePlace> before = std::exchange(state.files, file_places(text));
  state.rows_of = std::move(of);
  state.rows = shader_rows(text);
  state.marks.faults = shader_faults(text, state.error);
  if (before.empty() || before.front().name != state.files.front().name)
    look_at(state, state.marks.faults.empty() ? state.files.front().row : 0);
}

/// A new message turns to the shader that it is about.
void take_outcome(Session& session, ShaderPanelState& state, const std::string& message) {
  state.error = message;
  state.rows_of.clear();
  if (message.empty()) {
    ++state.reloads;
    session.draw_again();
    return;
  }
  const ShaderDraw* draw = shown_draw(state);
  if (!draw) return;
  for (const ShaderStage stage : {state.stage, ShaderStage::fragment, ShaderStage::vertex})
    if (!shader_faults(text_of(draw->shaders, stage), message).empty()) {
      state.stage = stage;
      look_at(state, 0);
      return;
    }
}

}  // namespace

void ShaderReload::start(std::string (*reload)()) {
  job_.start([this, reload](Progress&) {
    std::string message = reload();
    {
      const std::lock_guard lock(mutex_);
      outcome_ = std::move(message);
    }
    if (wake_) wake_();
  });
}

std::optional<std::string> ShaderReload::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(outcome_, std::nullopt);
}

ShaderPanelState::ShaderPanelState(const std::function<void()>& wake)
    : worker(
          [prepared = std::make_shared<Prepared>(), reloads = 0](const ShaderRequest& request,
                                                                 Progress& progress) mutable {
            if (std::exchange(reloads, request.reloads) != request.reloads) prepared->clear();
            return find_shaders(request, progress, *prepared);
          },
          same_shaders, wake),
      watch(wake), reload(wake) {}

bool has_shaders(const Settings& settings) { return renderer_row(settings.renderer).shaders != nullptr; }

void update_shaders(Session& session, ShaderPanelState& state) {
  state.worker.take_news();
  if (const auto found = state.worker.result(); found && found != state.shown) {
    state.shown = found;
    state.rows_of.clear();
    if (found->listing) state.watch.watch(found->listing->watched);
  }
  if (!state.watch.take_changed().empty() && session.has_scene())
    for (const RendererRow& row : renderer_table())
      if (row.reload_shaders) state.reload.start(row.reload_shaders);
  if (const auto outcome = state.reload.take()) take_outcome(session, state, *outcome);
}

bool shaders_busy(const ShaderPanelState& state) {
  return state.worker.busy() || state.worker.has_news() || state.reload.busy();
}

void shader_panel(Session& session, ShaderPanelState& state, Side side, Vec2i pixel) {
  ShaderRequest request;
  request.picture.scene = session.scene();
  request.picture.view = session.view();
  request.picture.settings = session.settings(side);
  request.pixel = pixel;
  request.reloads = state.reloads;
  state.worker.request(request);
  const ShaderDraw* draw = shown_draw(state);
  if (draw) {
    choose_stage(state);
    choose_draw(state);
    draw = shown_draw(state);
    keep_rows(state, *draw);
    go_to_file(state);
    same_line_if_room(px(160), px(16));
    ImGui::AlignTextToFramePadding();
    value_text("triangle", draw->id.object < 0 ? "shades the whole picture at once"
                                               : "drew " + primitive_name(session.scene(), draw->id));
  }
  if (!state.error.empty())
    quiet_text(fmt::format("{}. The shaders before are still in use, and their text is shown.", state.error));
  if (state.shown && !state.shown->message.empty()) quiet_text(state.shown->message);
  if (!draw) {
    if (state.shown && state.shown->listing) quiet_text("No triangle is seen at this pixel: no shader drew it.");
    return;
  }
  ImGui::Spacing();
  listing_code(state.rows, std::exchange(state.reveal, false), state.marks);
}

void offer_shader_values(Values& out, const ShaderPanelState& state) {
  out.offer("listing/shader/draws", [&state] {
    return state.shown && state.shown->listing ? static_cast<int>(state.shown->listing->draws.size()) : 0;
  });
  out.offer("listing/shader/text", [&state] {
    const ShaderDraw* draw = shown_draw(state);
    return draw ? text_of(draw->shaders, state.stage).text : "";
  });
  out.offer("listing/shader/error", [&state] { return state.error; });
  out.offer("listing/shader/reloads", [&state] { return state.reloads; });
}

}  // namespace ps::gui
