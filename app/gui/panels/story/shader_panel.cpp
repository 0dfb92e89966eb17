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

constexpr double part_width = 180, draw_width = 220, file_width = 170;

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

const std::vector<ShaderFile>& files_of(const ShaderDraw& draw, ShaderPart part) {
  return draw.files[static_cast<std::size_t>(part)];
}

const ShaderFile& shown_file(const ShaderPanelState& state, const ShaderDraw& draw) {
  const auto& files = files_of(draw, state.part);
  return files[std::min(static_cast<std::size_t>(state.file), files.size() - 1)];
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
                {.tooltip = "The draw calls of this pixel, in drawing order.", .disabled = {}}))
    state.draw = index;
}

void choose_part(ShaderPanelState& state) {
  static constexpr std::array parts{
      Choice{"vertex", "Vertex", "The shader that places each vertex of the triangle."},
      Choice{"fragment", "Fragment", "The shader that gives each pixel of the triangle its colour."}};
  int index = static_cast<int>(state.part);
  same_line_if_room(px(part_width));
  if (!choice("part", parts, index, {.tooltip = "The shader.", .width = px(part_width)})) return;
  state.part = static_cast<ShaderPart>(index);
  state.file = 0;
}

void choose_file(ShaderPanelState& state, const ShaderDraw& draw) {
  const auto& files = files_of(draw, state.part);
  std::vector<Choice> choices;
  choices.reserve(files.size());
  for (const ShaderFile& file : files) choices.push_back({file.name, file.name, ""});
  int index = std::min(state.file, static_cast<int>(files.size()) - 1);
  same_line_if_room(px(file_width));
  if (drop_down("file", choices, index, px(file_width),
                {.tooltip = "The file with main(), and those that it includes.", .disabled = {}}))
    state.file = index;
}

void choose_lines(ShaderPanelState& state) {
  bool whole = state.lines == ShaderLinesShown::whole;
  same_line_if_room(px(130), px(10));
  if (toggle("whole", "Whole file", whole,
             {.tooltip = "Shows the lines as well that the definitions leave out of this program."}))
    state.lines = whole ? ShaderLinesShown::whole : ShaderLinesShown::compiled;
}

void keep_rows(ShaderPanelState& state, const ShaderDraw& draw) {
  const ShaderFile& file = shown_file(state, draw);
  std::string of = fmt::format("{} {} {} {} {} {}", fmt::ptr(state.shown.get()), state.draw,
                               static_cast<int>(state.part), static_cast<int>(state.lines), file.name, state.error);
  if (of == state.rows_of) return;
  state.reveal = state.reveal || state.opened != file.name;
  state.opened = file.name;
  state.rows_of = std::move(of);
  state.rows = shader_rows(file, state.lines, state.error);
}

/// A new message opens the file that it is about.
void take_outcome(Session& session, ShaderPanelState& state, const std::string& message) {
  state.error = message;
  if (message.empty()) {
    ++state.reloads;
    session.draw_again();
    return;
  }
  const ShaderDraw* draw = shown_draw(state);
  if (!draw) return;
  for (const ShaderPart part : {state.part, ShaderPart::fragment, ShaderPart::vertex})
    if (const int file = file_of_message(files_of(*draw, part), message); file >= 0) {
      state.part = part;
      state.file = file;
      return;
    }
}

std::optional<std::string> uniform_of(const ShaderPanelState& state, std::string_view name) {
  const ShaderDraw* draw = shown_draw(state);
  if (!draw) return {};
  for (const ShaderFile& file : files_of(*draw, state.part))
    for (const ShaderLine& line : file.lines)
      for (const ShaderValue& value : line.values)
        if (value.name == name) return value.value;
  return {};
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
    if (found->listing) state.watch.watch(found->listing->watched);
  }
  if (state.watch.take_changed() && session.has_scene())
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
    choose_part(state);
    choose_file(state, *draw);
    choose_draw(state);
    choose_lines(state);
    draw = shown_draw(state);
    keep_rows(state, *draw);
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
  listing_code(state.rows, std::exchange(state.reveal, false));
}

void offer_shader_values(Values& out, const ShaderPanelState& state) {
  out.offer("listing/shader/draws", [&state] {
    return state.shown && state.shown->listing ? static_cast<int>(state.shown->listing->draws.size()) : 0;
  });
  out.offer("listing/shader/file", [&state] {
    const ShaderDraw* draw = shown_draw(state);
    return draw ? shown_file(state, *draw).name : "";
  });
  out.offer("listing/shader/error", [&state] { return state.error; });
  out.offer("listing/shader/reloads", [&state] { return state.reloads; });
  out.offer_below("listing/shader/value/", [&state](std::string_view name) { return uniform_of(state, name); });
}

}  // namespace ps::gui
