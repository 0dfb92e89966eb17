#include "gui/panels/microscope/microscope_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "gui/panels/microscope/surroundings_view.h"
#include "gui/session/select_event.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/screen_painter.h"
#include "inspect/microscope/event_of_triangle.h"
#include "inspect/microscope/micro_svg.h"
#include "options/renderer_kind.h"
#include "record/value_text.h"

namespace ps::gui {
namespace {

constexpr double number_width = 86, name_width = 134;  // of the table's columns
constexpr std::size_t most_rows = 40;

bool same_pixel(const MicroRequest& a, const MicroRequest& b) {
  return a.scene.revision() == b.scene.revision() && a.view == b.view && a.settings == b.settings && a.pixel == b.pixel;
}

/// Keeps what it gathered for a pixel while only the sample point moves.
class MicroMaker {
 public:
  MicroResult operator()(const MicroRequest& request, Progress& progress) {
    const bool fine_enough = made_ && (request.detail == MicroDetail::first || made_->detail() == MicroDetail::whole);
    if (!fine_enough || !same_pixel(*for_, request)) {
      made_ = std::make_shared<const Microscope>(request.scene, request.view, request.settings, request.pixel,
                                                 *prepared_, progress, request.detail);
      for_ = request;
    }
    return {request, made_, made_->read(request.point, *prepared_, progress)};
  }

 private:
  std::shared_ptr<Prepared> prepared_ = std::make_shared<Prepared>();
  std::shared_ptr<const Microscope> made_;
  std::optional<MicroRequest> for_;
};

/// Brings the drawings up to date with what has come.
void take_result(MicroscopePanelState& state) {
  state.worker.take_news();
  const auto result = state.worker.result();
  if (!result || (result == state.shown && state.chosen == state.shown_chosen)) return;
  const bool new_pixel = !state.shown || state.shown->microscope != result->microscope;
  state.shown = result;
  state.shown_chosen = state.chosen;
  state.drawing = pixel_drawing(*result->microscope, result->reading, state.chosen);
  if (new_pixel) state.backdrop.upload(state.drawing.backdrop);
  state.texels.clear();
  if (!result->reading.texture) return;
  for (const MicroTexels& level : result->reading.texture->levels) {
    if (state.texels.size() == state.texel_backdrops.size()) break;
    state.texels.push_back(texel_drawing(level));
    state.texel_backdrops[state.texels.size() - 1].upload(level.texels);
  }
}

/// Chooses the triangle whose numbers are shown; -1 = those of the triangle that the story's selected event is about.
void click_triangle(Session& session, int index) {
  session.navigate([&](Document& document) { document.story.micro_triangle = index; });
}

/// Where the sample point is; empty = at the pixel's first sample.
void move_point(Session& session, const std::optional<Vec2d>& point) {
  session.navigate([&](Document& document) {
    document.story.sample = point;
    document.story.micro_triangle = -1;
  });
}

/// The triangle that is shown follows the story's selected event, until another one is clicked.
void follow_story(Session& session, MicroscopePanelState& state, const PixelStory* story) {
  const int clicked = session.document().story.micro_triangle;
  const int selected = session.selected_event(inspected_side(session));
  state.chosen = clicked;
  if (!state.shown || !story || story->pixel != state.shown->request.pixel) return;
  const MicroReading& reading = state.shown->reading;
  if (clicked >= 0 && static_cast<std::size_t>(clicked) < reading.triangles.size()) {
    const int event = event_of_triangle(*story, reading.triangles[static_cast<std::size_t>(clicked)]);
    if (event < 0 || event == selected) return;
    click_triangle(session, -1);
  }
  state.chosen = triangle_of_event(*story, reading, selected);
}

void show_drawing(const MicroDrawing& drawing, const PaintArea& area, const Texture& backdrop) {
  const std::array pictures{ScreenPicture{&drawing.backdrop, backdrop.id()}};
  ScreenPainter painter(*ImGui::GetWindowDrawList(), pictures);
  draw_micro(painter, drawing, area);
}

/// The pixel itself; a drag moves the sample point.
void pixel_view(Session& session, MicroscopePanelState& state, float size) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const Vec2d corner(std::floor(at.x), std::floor(at.y));
  const PaintArea area{corner, corner + Vec2d(size)};
  ImGui::InvisibleButton("pixel", {size, size});
  const Vec2d point = state.shown->reading.point;
  controls().record("pixel", fmt::format("{:.4g},{:.4g}", point.x, point.y));
  if (ImGui::IsItemActive()) {
    const Vec2d to = micro_point(state.drawing, area, paint_place(ImGui::GetIO().MousePos));
    move_point(session, Vec2d(std::clamp(to.x, -micro_margin, 1 + micro_margin),
                              std::clamp(to.y, -micro_margin, 1 + micro_margin)));
  }
  show_drawing(state.drawing, area, state.backdrop);
}

/// The panel's drawing as an SVG file; empty before the first pixel.
std::string microscope_drawing(const MicroscopePanelState& state) {
  return state.shown ? micro_svg(*state.shown->microscope, state.shown->reading, state.chosen) : std::string();
}

bool toolbar(Session& session, MicroscopePanelState& state, const PanelHost& host, bool filled) {
  const Side side = inspected_side(session);
  ImGui::AlignTextToFramePadding();
  side_letter(side);
  ImGui::SameLine(0, px(8));
  const Vec2d point = state.shown ? state.shown->reading.point : Vec2d(0.5);
  value_text("point", fmt::format("({:.3f}, {:.3f})", point.x, point.y), {Face::mono});
  tooltip("The sample point, in pixels from the pixel's top left corner. Drag it in the drawing.");
  same_line_if_room(button_width("To the sample"));
  if (button("reset", "To the sample", Emphasis::plain,
             {.tooltip = "Moves the point back to the pixel's sample.",
              .disabled = session.document().story.sample ? "" : "The point is at the sample."}))
    move_point(session, {});
  svg_button([&] {
    host.send(SaveDrawing{"Save the microscope's view", "pixel.svg", [&state] { return microscope_drawing(state); }});
  });
  return fill_button(filled, "Shows this view in the whole window (Esc).");
}

/// How many samples see which object: a summary for pixels with many samples.
void samples_text(const Microscope& microscope) {
  std::map<std::string, int> seen;
  for (const MicroSample& sample : microscope.samples()) ++seen[sample.seen];
  const std::size_t all = microscope.samples().size();
  int index = 0;
  for (const auto& [what, count] : seen) {
    const std::string text =
        all == 1 ? "The sample sees " + what + "." : fmt::format("{} of {} samples see {}.", count, all, what);
    value_paragraph(fmt::format("samples/{}", index++), text);
  }
}

void triangle_list(Session& session, const MicroscopePanelState& state, const MicroReading& reading,
                   const PixelStory* story) {
  const int chosen = shown_triangle(reading, state.chosen);
  for (std::size_t i = 0; i < reading.triangles.size(); ++i) {
    if (i == most_rows) {
      quiet_text(fmt::format("and {} more", reading.triangles.size() - i));
      break;
    }
    const MicroTriangle& triangle = reading.triangles[i];
    const int index = static_cast<int>(i);
    const std::string_view fate = index == reading.front ? "in front"
                                  : !triangle.covered    ? "does not cover"
                                  : triangle.cut_out     ? "cut out by an opacity map"
                                                         : "covers";
    std::string text = fmt::format("{}  {}: {}", i + 1, triangle.name, fate);
    if (triangle.is_drawn() && !triangle.on_canvas) text += ", z " + ps::number_text(triangle.z);
    if (triangle.is_drawn() && triangle.depth) text += ", depth " + ps::number_text(*triangle.depth);
    if (!tree_row(fmt::format("triangle/{}", i), text, TreeKind::leaf, index == chosen).clicked) continue;
    click_triangle(session, index);
    const int event = story ? event_of_triangle(*story, triangle) : -1;
    if (event >= 0) select_event(session, inspected_side(session), event);
  }
}

/// Where there is no room for columns the numbers are below their name.
void numbers_list(const MicroTable& table) {
  std::string columns;
  for (const std::string& column : table.columns) columns += (columns.empty() ? "" : ", ") + column;
  quiet_text(columns);
  for (const MicroRow& row : table.rows) {
    show_text(row.name);
    std::string line, exact;
    for (std::size_t i = 0; i < row.values.size(); ++i) {
      line += "  " + row.values[i];
      exact += (i == 0 ? "" : "\n") + row.exact[i];
    }
    show_paragraph(line, {Face::mono});
    tooltip(exact);
  }
}

void numbers_table(const MicroTable& table) {
  const float width = px(number_width);
  if (ImGui::GetContentRegionAvail().x < px(name_width) + 3 * (width + px(8))) return numbers_list(table);
  if (!begin_numbers(table.columns.front().c_str(), static_cast<int>(table.columns.size()),
                     {.text = px(name_width), .numbers = width}))
    return;
  {
    const TextScope quiet({.quiet = true});
    numbers_row("");
    for (const std::string& column : table.columns) number_cell(column, column);
  }
  for (const MicroRow& row : table.rows) {
    numbers_row(row.name);
    for (std::size_t i = 0; i < row.values.size(); ++i) number_cell(row.values[i], row.exact[i]);
  }
  ImGui::EndTable();
}

/// Names and line of the face in the model's file, and a warning where its normals are turned.
void face_text(const FaceData& face) {
  if (const std::string words = face_words(face); !words.empty()) value_paragraph("face", words);
}

void ray_text(const PixelStory& story) {
  const bool ray = sends_rays(story.renderer);
  value_paragraph("ray", (ray ? "A ray through the point: " : "A small pixel around the point: ") + story.verdict);
  if (story.not_reported.empty()) return;
  value_paragraph("not-reported", story.not_reported + " So no edges and no samples of triangles are drawn here.",
                  {.quiet = true});
}

void texel_views(MicroscopePanelState& state, const MicroTexture& texture, float size) {
  ImGui::Spacing();
  const bool footprint = !texture.levels.empty() && !texture.levels.front().footprint.empty();
  value_paragraph("texture", fmt::format("Texture at u, v = {}{}. Marked texels were read, with their weights.",
                                         vector_text(texture.lookup.uv),
                                         footprint ? ", computed mip level " + ps::number_text(texture.lookup.level) +
                                                         "; yellow: the pixel's footprint"
                                                   : ""));
  for (std::size_t i = 0; i < state.texels.size(); ++i) {
    if (i > 0) same_line_if_room(size, px(12));
    ImGui::BeginGroup();
    quiet_text(fmt::format("level {}", texture.levels[i].level));
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const PaintArea area = paint_area(at, {at.x + size, at.y + size});
    ImGui::Dummy({size, size});
    controls().record(fmt::format("texels/{}", texture.levels[i].level),
                      fmt::format("{}", texture.levels[i].taps.size()));
    show_drawing(state.texels[i], area, state.texel_backdrops[i]);
    ImGui::EndGroup();
  }
}

void readings(Session& session, MicroscopePanelState& state, const PixelStory* story) {
  const MicroReading& reading = state.shown->reading;
  value_paragraph("seen", "At the point: " + reading.seen, {Face::heading});
  if (state.shown->microscope->detail() == MicroDetail::first)
    quiet_text("Coarse picture; the fine one is being rendered.");
  samples_text(*state.shown->microscope);
  if (const auto& around = state.shown->microscope->surroundings())
    surroundings_view(session, *around, state.shown->request.pixel);
  if (reading.ray) ray_text(*reading.ray);
  if (reading.face) {
    face_text(reading.face->face);
    for (const MicroTable& table : face_tables(*reading.face)) numbers_table(table);
  }
  ImGui::Spacing();
  triangle_list(session, state, reading, story);
  if (const int chosen = shown_triangle(reading, state.chosen); chosen >= 0) {
    const MicroTriangle& triangle = reading.triangles[static_cast<std::size_t>(chosen)];
    if (triangle.face) face_text(*triangle.face);
    for (const MicroTable& table : triangle_tables(triangle)) numbers_table(table);
  }
  if (reading.texture) texel_views(state, *reading.texture, px(170));
  if (!reading.triangles.empty()) {
    ImGui::Spacing();
    quiet_text("Solid edges with ticks own the samples on them (fill rule); dashed edges do not. Filled dots: "
               "covered samples. Rings: samples that are not covered. Cross: the sample point.");
  }
}

}  // namespace

MicroscopePanelState::MicroscopePanelState(std::function<void()> wake)
    : worker([maker = std::make_shared<MicroMaker>()](const MicroRequest& request,
                                                      Progress& progress) { return (*maker)(request, progress); },
             [](const MicroRequest& a, const MicroRequest& b) {
               return same_pixel(a, b) && a.point == b.point && a.detail == b.detail;
             },
             std::move(wake),
             // A picture that is only to become finer does not keep another pixel waiting.
             [](const MicroRequest& made, const MicroRequest& wanted) {
               return made.detail == MicroDetail::whole && !same_pixel(made, wanted);
             }) {}

MicroscopePanel::MicroscopePanel(const PanelHost& host)
    : Panel(host, {.name = "microscope",
                   .answers = Answers::yes,
                   .heading = "Microscope",
                   .brief = "Micro",
                   .command = "Microscope: the pixel at panel size",
                   .help = "The picked pixel at panel size: edges with their fill rule, samples, texels."}),
      state_(host.wake) {}

bool MicroscopePanel::draw(const Context& context) {
  Session& session = session_;
  MicroscopePanelState& state = state_;
  const NameScope scope("microscope");
  const auto pixel = session.pixel();
  if (!session.has_scene() || !pixel) {
    state.worker.rest();
    show_paragraph("Click a pixel in either picture to see it here, enlarged.");
    return false;
  }
  const Side side = inspected_side(session);
  MicroRequest request{session.scene(), session.view(), session.settings(side), *pixel, {0.5, 0.5}};
  if (const auto& point = session.document().story.sample)
    request.point = *point;
  else if (request.settings.sample_position == SamplePosition::corner)
    request.point = {0, 1};
  const auto story = session.story(side);
  follow_story(session, state, story.get());
  take_result(state);
  // Where only a coarse picture of the pixel has come, the fine one is asked for.
  if (state.shown && same_pixel(state.shown->request, request))
    request.detail =
        state.shown->microscope->detail() == MicroDetail::first ? MicroDetail::whole : state.shown->request.detail;
  state.worker.request(request);
  const bool fill = toolbar(session, state, host_, context.filled);
  begin_tool_content();
  if (!state.shown) return fill;
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const bool beside = room.x > room.y * 1.2f;
  const float size =
      std::floor(std::max(px(120), beside ? std::min(room.y, room.x * 0.55f) : std::min(room.x, room.y * 0.6f)));
  pixel_view(session, state, size);
  if (beside) ImGui::SameLine(0, px(16));
  ImGui::BeginChild("readings");
  readings(session, state, story.get());
  ImGui::EndChild();
  return fill;
}

}  // namespace ps::gui
