#include "gui/frame/panel_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/check.h"
#include "gui/frame/file_questions.h"
#include "gui/frame/measure_panels.h"
#include "gui/frame/show_panel.h"
#include "gui/panels/lesson/lesson_actions.h"
#include "gui/panels/options/light_actions.h"
#include "gui/panels/pictures/picture_actions.h"
#include "gui/panels/pictures/picture_values.h"
#include "gui/panels/space/story_actions.h"
#include "gui/panels/story/own_listing_view.h"
#include "gui/widgets/flash.h"
#include "gui/widgets/widgets.h"
#include "scene/load.h"

namespace ps::gui {
namespace {

template <class Worker>
bool works(const Worker& worker) {
  return worker.busy() || worker.has_news();
}

/// While a question about the pixel is open, `draw` is not shown.
bool unless_asked(Session& session, PredictState& predict, const std::function<bool()>& draw) {
  if (!prediction_pending(session, predict)) return draw();
  ImGui::TextWrapped("The story is shown after your answer.");
  return false;
}

/// Measurements for a lesson wait for the pictures' own renders, and for studies, which may measure times.
bool lesson_measurements_wait(const Session& session, const PanelStates& my) {
  return session.work().rendering() || my.chart.measuring() || my.needs.measuring() || my.timings.measuring();
}

// --- left ---

Panel lesson(Session& session, PanelStates& my) {
  return {.name = region_names::lesson,
          .place = PanelPlace::left,
          .heading = "LESSON",
          .brief = "Lesson",
          .command = "Lesson",
          .help = "The text of a lesson's step.",
          .draw =
              [&](const Context&) {
                lesson_panel(session, my.lessons);
                return false;
              },
          .actions = [&](Actions& actions) { add_lesson_actions(actions, session, my.lessons); },
          .publish =
              [&](Values& out) {
                out.offer("lesson/pages", [&] { return my.lessons.text.pages; });
                out.offer("lesson/page", [&] { return my.lessons.text.page + 1; });
                out.offer("lesson/column", [&] {
                  const LessonColumn& column = my.lessons.column;
                  return !column.shared ? "both" : column.shows == ColumnShows::text ? "text" : "tool";
                });
                out.offer("lesson/line-length", [&] { return my.lessons.text.line_length; });
                out.offer_below("flash/", [](std::string_view name) { return script_text(flashes(name)); });
              },
          .update =
              [&] {
                my.lessons.update(session);
                my.lessons.claims.hold(lesson_measurements_wait(session, my));
              }};
}

/// Hands the chart the sweep that an option's row asks for.
void take_sweep(Session& session, PanelStates& my) {
  const Option* swept = std::exchange(my.options.sweep, nullptr);
  if (!swept) return;
  my.chart.sweep_option(*swept, session.document().picked);
  make_room_for_study(session);
  show_panel(session, tool_names::chart);
}

Panel options(Session& session, PanelStates& my) {
  return {.name = region_names::left,
          .place = PanelPlace::left,
          .heading = "OPTIONS",
          .brief = "Options",
          .command = "Options",
          .help = "All options of A and of B.",
          .draw =
              [&](const Context&) {
                if (session.has_scene()) options_panel(session, my.options, {my.pictures.picked, my.pictures.gizmo});
                take_sweep(session, my);
                return false;
              },
          .actions = [&](Actions& actions) { add_light_actions(actions, session, my.options); }};
}

Panel history(Session& session, PanelStates& my) {
  return {.name = history_panel_name,
          .place = PanelPlace::left,
          .heading = "HISTORY",
          .brief = "History",
          .command = "History: every step with its pictures",
          .help = "Every step with its pictures; a click goes there.",
          .draw =
              [&](const Context&) {
                history_panel(session, my.history);
                return false;
              },
          .actions =
              [&](Actions& actions) {
                actions.add({.name = "history",
                             .label = "History: every step with its pictures",
                             .group = "Edit",
                             .keys = "Y",
                             .run =
                                 [&] {
                                   my.history.open = !my.history.open;
                                   if (my.history.open) set_mode(session, ScreenMode::explore);
                                 },
                             .checked = [&] { return my.history.open; }});
              },
          .publish = [&](Values& out) { out.offer("history/open", [&] { return my.history.open; }); },
          .update = [&] { my.history.log.update(session); },
          .busy = [&] { return my.history.thumbnails.busy(); }};
}

// --- right ---

/// The question hides the story, and the surroundings of the pixel.
void update_question(Session& session, PanelStates& my) {
  my.pictures.asked.reset();
  my.pictures.hidden = {};
  const bool pending = prediction_pending(session, my.predict);
  LessonQuestions& questions = *my.predict.lesson;
  if (std::exchange(my.lessons.ask_again, false)) {
    go_to_step(session, session.document().lesson, session.document().step);
    questions.ask_again();
  }
  my.lessons.verdict = shown_verdict(questions);
  const bool asks_bug = questions.asked_beside_text(session) && questions.question()->kind == AskKind::bug;
  // Also where it is not asked: a projector is not to show what the audience is asked afterwards.
  my.lessons.holds_back = questions.open() && questions.question()->kind != AskKind::bug;
  auto wrong_line = questions.bug_verdict(session);
  my.listing.reveal |= wrong_line && !my.listing.marks.marked;
  my.listing.marks = {asks_bug && questions.bug_shown(session) ? &questions.answer.line : nullptr,
                      std::move(wrong_line)};
  my.listing.own.task = {};
  if (const Lesson* lesson = my.lessons.open(session)) {
    const auto step = static_cast<std::size_t>(session.document().step);
    if (step < lesson->steps.size()) my.listing.own.task = {lesson->name, lesson->steps[step].write};
  }
  if (my.lessons.holds_back) my.pictures.hidden = questions.question()->hidden;
  if (pending && session.pixel() && asks_about_pixel(session, my.predict))
    my.pictures.asked = Hover{inspected_side(session), *session.pixel()};
}

bool draw_pixel(Session& session, PanelStates& my, const PanelHost& host) {
  if (prediction_pending(session, my.predict)) {
    if (session.document().mode == ScreenMode::lesson || my.predict.lesson->asked_beside_text(session))
      ImGui::TextWrapped("The story is shown after your answer.");  // the question is beside the text
    else
      predict_panel(session, my.predict);
    return false;
  }
  prediction_verdict(session, my.predict);
  if (side_of(session.document(), inspected_side(session)).slow_motion) {
    constexpr std::string_view note = "Slow motion: the story is that of the finished picture.";
    ImGui::PushTextWrapPos(0);
    value_text("pixel/slow-motion", note);
    ImGui::PopTextWrapPos();
  }
  pixel_panel(session, my.pixel, [&](const std::string& text) { host.copy(text, "Copied to the clipboard."); });
  return false;
}

Panel pixel(Session& session, PanelStates& my, const PanelHost& host) {
  return {.name = region_names::right,
          .place = PanelPlace::right,
          .heading = "STORY",
          .brief = "Story",
          .command = "Story: how the pixel got its colour",
          .help = "The story of the picked pixel.",
          .draw = [&](const Context&) { return draw_pixel(session, my, host); },
          .actions =
              [&](Actions& actions) {
                actions.add({.name = "predict",
                             .label = "Predict: ask before the story is shown",
                             .group = "Pixel",
                             .keys = "Q",
                             .run =
                                 [&] {
                                   if (my.predict.on)
                                     my.predict.on = false;
                                   else
                                     ask_about_pixels(session, my.predict);
                                 },
                             .checked = [&] { return my.predict.on; }});
              },
          .publish =
              [&](Values& out) {
                out.offer("predict/points", [&] { return my.predict.points; });
                out.offer("predict/asked", [&] { return my.predict.asked; });
                out.offer("predict/open", [&] { return prediction_pending(session, my.predict); });
                out.offer("question/open", [&] { return my.predict.lesson->open(); });
                out.offer("question/given", [&] { return my.predict.lesson->given(); });
                out.offer("question/verdict", [&] {
                  const auto verdict = shown_verdict(*my.predict.lesson);
                  return verdict ? verdict->sentence : "";
                });
                out.offer("question/points", [&] {
                  const Judgement* verdict = my.predict.lesson->verdict();
                  return verdict ? verdict->points : 0;
                });
              },
          .update =
              [&] {
                update_pin(session, my.pixel.pin);
                update_question(session, my);
                my.predict.lesson->hold(lesson_measurements_wait(session, my));
              },
          .busy = [&] { return pin_busy(my.pixel.pin) || my.predict.lesson->measuring(); }};
}

// --- below the pictures ---

void offer_space_values(Values& out, Session& session, SpacePanelState& space) {
  out.offer("space/items", [&] { return space.items; });
  out.offer("space/rays", [&] { return space.rays; });
  out.offer("space/shadow-rays", [&] { return space.shadow_rays; });
  out.offer("space/boxes", [&] { return space.boxes; });
  out.offer("space/tree-nodes", [&] { return space.tree ? static_cast<int>(space.tree->nodes) : 0; });
  out.offer("space/steps", [&] { return static_cast<int>(space.model.steps.size()); });
  out.offer("space/playing", [&] { return space.play.running; });
  out.offer("space/up-to", [&] { return drawn_until(session, space); });
  out.offer("space/orbit", [&] {
    const auto& orbit = session.document().story.outside.orbit;
    return orbit ? fmt::format("{:.6g} {:.6g} {:.6g}", orbit->yaw, orbit->pitch, orbit->distance) : "none";
  });
}

/// A view that is not drawn, or has no room, asks for no work in this frame and keeps no worker busy.
template <class Worker>
void wait_unless_drawn(Worker& worker) {
  worker.rest();
  worker.take_news();
}

Panel space(Session& session, PanelStates& my, const PanelHost& host) {
  my.space.save = [&] {
    host.ask_file(save_drawing_question(session, "Save the view from outside", "space.svg",
                                        [&] { return space_drawing(session, my.space); }));
  };
  return {.name = tool_names::space,
          .heading = "SPACE",
          .brief = "Space",
          .command = "Space: the scene from outside",
          .help = "The scene from outside, with the rays or triangles of the picked pixel.",
          .draw =
              [&](const Context& context) {
                return unless_asked(session, my.predict,
                                    [&] { return space_panel(session, my.space, my.pictures, context.filled); });
              },
          .actions = [&](Actions& actions) { add_story_actions(actions, session, my.space); },
          .publish = [&](Values& out) { offer_space_values(out, session, my.space); },
          .update =
              [&] {
                wait_unless_drawn(my.space.worker);
                const bool kept = session.has_scene() && session.document().story.vertex;
                update_space(session, my.space, kept ? followed_chain(session, my.vertex) : nullptr);
              },
          .busy = [&] { return works(my.space.worker) || works(my.space.tree_worker); }};
}

Panel microscope(Session& session, PanelStates& my, const PanelHost& host) {
  my.microscope.save = [&] {
    host.ask_file(save_drawing_question(session, "Save the microscope's view", "pixel.svg",
                                        [&] { return microscope_drawing(my.microscope); }));
  };
  return {.name = tool_names::microscope,
          .heading = "MICROSCOPE",
          .brief = "Micro",
          .command = "Microscope: the pixel at panel size",
          .help = "The picked pixel at panel size: edges with their fill rule, samples, texels.",
          .draw =
              [&](const Context& context) {
                return unless_asked(session, my.predict,
                                    [&] { return microscope_panel(session, my.microscope, context.filled); });
              },
          .update = [&] { wait_unless_drawn(my.microscope.worker); },
          .busy = [&] { return works(my.microscope.worker); }};
}

Panel pixels(Session& session, PanelStates& my) {
  return {.name = tool_names::pixels,
          .use = PanelUse::study,
          .group = ToolGroup::pixels,
          .height = PanelHeight::tall,
          .heading = "PIXELS",
          .brief = "Pixels",
          .command = "Pixels: the worst ones",
          .help = "The worst pixels, watched pixels, and the levels of a rectangle.",
          .draw = [&](const Context& context) { return pixels_panel(session, my.pixels, my.pictures, context.filled); },
          .update = [&] { update_pixels(session, my.pixels, my.pictures); },
          .busy = [&] { return works(my.pixels.cost); }};
}

void offer_listing_values(Values& out, const ListingPanelState& listing) {
  const auto values_of = [&listing] {
    return listing.shown_story && listing.shown_story->listing ? &*listing.shown_story->listing : nullptr;
  };
  out.offer("listing/focus", [&listing] { return listing.view ? listing.view->focus() : -1; });
  out.offer("listing/folder", [=] { return values_of() ? values_of()->listing.folder : ""; });
  out.offer("listing/values", [=] { return values_of() ? static_cast<int>(values_of()->watches.size()) : 0; });
}

bool head_of_listing(Session& session, PanelStates& my, const PanelHost& host) {
  return !prediction_pending(session, my.predict) && listing_head(session, my.listing, host);
}

Panel listing(Session& session, PanelStates& my, const PanelHost& host) {
  return {.name = tool_names::listing,
          .height = PanelHeight::tall,
          .heading = "LISTING",
          .brief = "Listing",
          .command = "Listing: a routine with its values",
          .help = "A lesson's routine, or the shaders, with their values at the picked pixel.",
          .draw =
              [&session, &my, host](const Context& context) {
                return unless_asked(session, my.predict,
                                    [&] { return listing_panel(session, my.listing, context, host); });
              },
          .head = [&session, &my, host] { return head_of_listing(session, my, host); },
          .publish =
              [&](Values& out) {
                offer_listing_values(out, my.listing);
                offer_shader_values(out, my.listing.shaders);
                offer_own_values(out, my.listing.own);
              },
          .update = [&] { update_listing(session, my.listing); },
          .busy =
              [&] {
                return works(my.listing.worker) || shaders_busy(my.listing.shaders) || own_listing_busy(my.listing.own);
              }};
}

Panel vertex(Session& session, PanelStates& my) {
  return {.name = tool_names::vertex,
          .height = PanelHeight::tall,
          .heading = "VERTEX",
          .brief = "Vertex",
          .command = "Vertex: from the model to the canvas",
          .help = "The transforms of a vertex from its model to the canvas, with matrices and numbers.",
          .draw = [&](const Context& context) { return vertex_panel(session, my.vertex, context.filled); },
          .publish =
              [&](Values& out) {
                out.offer("vertex", [&] {
                  const auto vertex = followed_vertex(session, my.vertex);
                  return vertex ? fmt::format("{},{}", vertex->object, vertex->vertex) : "none";
                });
              }};
}

/// Each name that a document may have has its row, and each row below the pictures such a name.
bool rows_match_names(const std::vector<Panel>& panels) {
  const auto below =
      std::count_if(panels.begin(), panels.end(), [](const Panel& panel) { return panel.place == PanelPlace::below; });
  return below == std::ssize(tool_names::all) &&
         std::all_of(tool_names::all.begin(), tool_names::all.end(), [&](std::string_view name) {
           return std::any_of(panels.begin(), panels.end(), [&](const Panel& panel) { return panel.name == name; });
         });
}

}  // namespace

PanelStates::PanelStates(const std::function<void()>& wake, bool remember)
    : scenes(wake), lessons(wake), picker(wake), history(wake), pixel(wake), space(wake), microscope(wake),
      pixels(wake), listing(wake), folder(remember), chart(wake, folder),
      stability(wake, folder.of("stability"), folder.scenes()), needs(wake), why(wake), timings(wake), unsafe(wake) {
  predict.lesson = std::make_unique<LessonQuestions>(wake, remember, lessons);
  pictures.meter = std::make_unique<DifferenceMeter>(wake);
}

std::vector<Panel> panel_table(Session& session, PanelStates& my, const PanelHost& host) {
  std::vector<Panel> panels{lesson(session, my),      options(session, my),       history(session, my),
                            pixel(session, my, host), space(session, my, host),   microscope(session, my, host),
                            pixels(session, my),      listing(session, my, host), vertex(session, my)};
  for (Panel& panel : measure_panels(session, my, host)) panels.push_back(std::move(panel));
  PS_ASSERT(rows_match_names(panels), "a row for each name that a document may have");
  return panels;
}

const Panel& find_panel(const std::vector<Panel>& panels, std::string_view name) {
  const auto named = std::find_if(panels.begin(), panels.end(), [&](const Panel& panel) { return panel.name == name; });
  if (named != panels.end()) return *named;
  return *std::find_if(panels.begin(), panels.end(),
                       [](const Panel& panel) { return panel.place == PanelPlace::below; });
}

}  // namespace ps::gui
