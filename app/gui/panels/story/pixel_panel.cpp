#include "gui/panels/story/pixel_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "document/document_provenance.h"
#include "engine/screen_names.h"
#include "frame/display_frame.h"
#include "gui/base/region_names.h"
#include "gui/panels/pictures/picture_text.h"
#include "gui/panels/story/ledger_view.h"
#include "gui/session/pixel_words.h"
#include "gui/session/select_event.h"
#include "gui/widgets/draw.h"
#include "inspect/missing_term.h"
#include "inspect/story_json.h"
#include "math/conventions.h"

namespace ps::gui {
namespace {

std::string prefix(Side side) { return side == Side::a ? "a" : "b"; }

/// The pixel's column and row; the tooltip shows its place on the book's canvas.
void place(Session& session, Vec2i pixel) {
  const View view = session.view();
  const Vec2i book = book_pixel(pixel.x, pixel.y, view.width, view.height);
  value_paragraph("pixel", pixel_words(session, pixel), {Face::mono});
  tooltip(
      fmt::format("Column and row from the top left, the first is 0.\nIn the book's canvas ({}, {}): x to the right "
                  "and y upwards from the centre.",
                  book.x, book.y));
}

void verdict(const PixelStory& story, Side side) {
  {
    const FontScope font(Face::bold);
    side_letter(side);
  }
  ImGui::SameLine(0, px(8));
  swatch(story.display);
  {
    const FontScope font(Face::mono);
    const std::string levels = fmt::format("{} {} {}", story.display[0], story.display[1], story.display[2]);
    same_line_if_room(text_width(levels), px(8));
    value_text(prefix(side) + "/colour", levels);
  }
  tooltip("Red, green and blue as displayed, 0 to 255.");
  headline(prefix(side) + "/verdict", story.verdict, story.verdict.ends_with(')') ? " (" : "; ");
}

void work(const PixelStory& story, const std::string& name) {
  if (!begin_numbers(name.c_str(), 1, {.numbers = px(90)})) return;
  const auto row = [](std::string_view label, std::uint64_t count) {
    numbers_row(label);
    number_cell(count_text(count), std::to_string(count));
  };
  for (std::size_t i = 0; i < counter_count; ++i) {
    const auto counter = static_cast<Counter>(i);
    if (const auto count = story.counters.get(counter); count.value_or(0) > 0) row(counter_label(counter), *count);
  }
  if (story.triangles_elsewhere > 0) row("triangles elsewhere", story.triangles_elsewhere);
  ImGui::EndTable();
}

/// The steps that the renderer cannot report.
void not_reported(const PixelStory& story, const std::string& name) {
  if (story.not_reported.empty()) return;
  value_paragraph(name + "/not-reported", story.not_reported, {.quiet = true});
}

std::string event_count(const PixelStory& story) {
  return fmt::format("{} event{}", story.events.size(), story.events.size() == 1 ? "" : "s");
}

void full_story(Session& session, PixelPanelState& state, Side side, const PixelStory& story,
                const std::function<void(const std::string&)>& copy) {
  StoryTreeState& tree = state.trees[index_of(side)];
  const std::string name = prefix(side);
  verdict(story, side);
  ImGui::Spacing();
  const PinnedStory* pinned = pinned_story(session, state.pin, side, session.story(side));
  pin_view(session, state.pin, side, session.story(side));
  if (tree.reveal) state.events_open = true;
  if (section("events", "What happened", state.events_open, event_count(story)))
    if (const auto clicked = story_tree_view(name, story, session.scene(), tree, pinned))
      select_event(session, side, *clicked);
  if (const auto asked = std::exchange(tree.asked, {})) show_field(session, *asked);
  if (state.events_open) not_reported(story, name);
  if (section("sum", "The colour as a sum", state.sum_open))
    if (const int clicked = ledger_view(name, story, tree.selected, pinned); clicked >= 0)
      select_event(session, side, clicked);
  if (has_canvas_rows(session) && section("rows", "Rows of the canvas shapes", state.rows_open))
    canvas_rows_view(session, side, state.rows, name);
  if (section("work", "Work for this pixel", state.work_open)) work(story, name + "/work");
  ImGui::Spacing();
  if (button("copy-text", "Copy as text", Emphasis::quiet)) copy(story_text(story, session.scene()));
  same_line_if_room(button_width("Copy as JSON"));
  if (button("copy-json", "Copy as JSON", Emphasis::quiet))
    copy(story_json(story, session.scene(), session.view(), document_provenance(session.document(), side)));
}

/// The colour of a picture file in B's place here, beside A.
void file_pixel(Session& session, Vec2i pixel, const std::shared_ptr<const PixelStory>& ours) {
  const PictureFile& file = *session.picture_b();
  const Rgb8 level = file.levels.at(pixel.x, pixel.y);
  swatch({level.r, level.g, level.b});
  ImGui::SameLine(0, px(8));
  value_text("b/colour", fmt::format("{} {} {}", level.r, level.g, level.b), {Face::mono});
  value_paragraph("b/verdict", fmt::format("B is the picture {}; a file has no story.", file.path));
  if (ours) {
    const auto& own = ours->display;
    value_paragraph("b/difference",
                    fmt::format("B − A: {:+} red, {:+} green, {:+} blue (of 255). The story below is that of A.",
                                level.r - own[0], level.g - own[1], level.b - own[2]));
    const auto display = display_transform(session.settings(Side::a));
    value_paragraph("b/missing", find_missing_term(*ours, display, level).sentence, {Face::bold});
  }
}

/// The selected event is shown in space and in the microscope, so it must belong to the story that these show.
void pick_side(Session& session, Side side) {
  if (session.document().picked != side) session.navigate([&](Document& document) { document.picked = side; });
}

/// One of the two stories when both are shown: the sum first, because it is what users compare.
void short_story(Session& session, PixelPanelState& state, Side side, const PixelStory& story) {
  const std::size_t index = index_of(side);
  const std::string name = prefix(side);
  ImGui::PushID(name.c_str());
  verdict(story, side);
  ImGui::Spacing();
  StoryTreeState& tree = state.trees[index];
  const auto select = [&](int event) {
    select_event(session, side, event);
    pick_side(session, side);
  };
  if (section(name + "/sum", "The colour as a sum", state.both_sum_open[index]))
    if (const int clicked = ledger_view(name, story, tree.selected); clicked >= 0) {
      select(clicked);
      state.both_events_open[index] = true;
    }
  if (section(name + "/events", "What happened", state.both_events_open[index], event_count(story)))
    if (const auto clicked = story_tree_view(name, story, session.scene(), tree)) select(*clicked);
  if (const auto asked = std::exchange(tree.asked, {})) show_field(session, *asked);
  if (state.both_events_open[index]) not_reported(story, name);
  ImGui::PopID();
}

void both(Session& session, PixelPanelState& state, const std::array<std::shared_ptr<const PixelStory>, 2>& stories) {
  if (stories[0] && stories[1]) {
    std::array<int, 3> apart{};
    for (std::size_t i = 0; i < 3; ++i) apart[i] = stories[1]->display[i] - stories[0]->display[i];
    const bool same = apart == std::array<int, 3>{};
    value_paragraph("both/difference", same ? "Both pictures have the same display levels here."
                                            : fmt::format("B − A: {:+} red, {:+} green, {:+} blue (of 255)", apart[0],
                                                          apart[1], apart[2]));
    ImGui::Spacing();
  }
  const float room = ImGui::GetContentRegionAvail().x;
  const bool beside = room >= px(620);
  for (const Side side : both_sides) {
    const auto& story = stories[index_of(side)];
    if (!story) continue;
    if (!beside) {
      if (side == Side::b) ImGui::Separator();
      short_story(session, state, side, *story);
      continue;
    }
    if (side == Side::b) ImGui::SameLine(0, px(16));
    ImGui::BeginChild(side == Side::a ? "story-a" : "story-b", {std::floor((room - px(16)) / 2), 0});
    short_story(session, state, side, *story);
    ImGui::EndChild();
  }
}

void nothing_picked(Session& session) {
  quiet_text(session.has_scene() ? "Click any pixel, in either picture: how it got its colour "
                                   "is shown here.\n\nThe arrow keys then go from pixel to pixel."
                                 : "Nothing is open.");
}

/// The part of the pixel's stories that is shown: that of the picked side, both, or the place where they part.
enum class Shown { one, both, parting };
constexpr std::array shown_names{story_names::one, std::string_view("both"), story_names::parting};

/// A key that this version does not know shows one story.
Shown shown_now(const Document& document) {
  const auto found = std::find(shown_names.begin(), shown_names.end(), document.layout.right_tab);
  return found == shown_names.end() ? Shown::one : static_cast<Shown>(found - shown_names.begin());
}

/// A, B, both or where they part. Answers what is shown.
Shown choose_shown(Session& session) {
  static constexpr std::array tabs{
      Choice{"a", "A", "The pixel in picture A."}, Choice{"b", "B", "The pixel in picture B."},
      Choice{"both", "Both", "The stories of A and B together."},
      Choice{story_names::parting, "Parting", "The first step at which the two stories differ, and why."}};
  const Shown before = shown_now(session.document());
  int tab = before == Shown::parting ? 3 : before == Shown::both ? 2 : session.document().picked == Side::a ? 0 : 1;
  if (!tab_row("side", tabs, tab)) return before;
  const Shown shown = tab == 3 ? Shown::parting : tab == 2 ? Shown::both : Shown::one;
  session.navigate([&](Document& document) {
    document.layout.right_tab = shown_names[static_cast<std::size_t>(shown)];
    if (shown == Shown::one) document.picked = tab == 0 ? Side::a : Side::b;
  });
  return shown;
}

}  // namespace

PixelPanel::PixelPanel(const PanelHost& host, LessonQuestions& questions)
    : Panel(host, {.name = region_names::right,
                   .place = PanelPlace::right,
                   .heading = "Story",
                   .brief = "Story",
                   .command = "Story: how the pixel got its colour",
                   .help = "The story of the picked pixel."}),
      predict(questions), state_(host.wake) {}

void PixelPanel::add_actions(Actions& actions) {
  const auto turn = [this] {
    if (predict.on)
      predict.on = false;
    else
      ask_about_pixels(session_, predict);
  };
  ActionGroup(actions, "Pixel").add_toggle("predict", "Predict: ask before the story is shown", "Q", turn, [this] {
    return predict.on;
  });
}

void PixelPanel::offer(Values& out) {
  out.offer("predict/points", [this] { return predict.points; });
  out.offer("predict/asked", [this] { return predict.asked; });
  out.offer("predict/open", [this] { return asks(); });
}

void PixelPanel::update() {
  update_pin(session_, state_.pin);
  asks();
}

PictureCovers PixelPanel::covers() {
  PictureCovers covers;
  if (asks() && session_.pixel() && asks_about_pixel(session_, predict))
    covers.asked = Hover{inspected_side(session_), *session_.pixel()};
  if (predict.lesson->holds_back()) covers.hidden = predict.lesson->question()->hidden;
  return covers;
}

bool PixelPanel::stop_asking() {
  if (!predict.on || !asks() || !asks_about_pixel(session_, predict)) return false;
  predict.on = false;
  return true;
}

bool PixelPanel::draw(const Context&) {
  if (asks()) {
    const ScreenMode mode = session_.document().mode;
    const bool in_caption = mode == ScreenMode::presenter && predict.lesson->question();
    if (mode == ScreenMode::lesson || in_caption || predict.lesson->asked_beside_text(session_))
      show_paragraph(story_after_answer);  // the question is beside the text
    else
      predict_panel(session_, predict);
    return false;
  }
  prediction_verdict(session_, predict);
  if (side_of(session_.document(), inspected_side(session_)).slow_motion) {
    value_paragraph("pixel/slow-motion", "Slow motion: the story is that of the finished picture.");
  }
  story();
  return false;
}

void PixelPanel::story() {
  Session& session = session_;
  PixelPanelState& state = state_;
  const auto copy = [this](const std::string& text) { host_.copy(text, "Copied to the clipboard."); };
  const NameScope scope("pixel");
  const auto picked = session.pixel();
  shown_field_bar(session, session.document().picked, state.field);
  if (!picked) {
    nothing_picked(session);
    return;
  }
  place(session, *picked);
  same_line_if_room(button_width("Pinned"));
  pin_button(session);
  const Shown shown = choose_shown(session);
  const std::array stories{session.story(Side::a), session.story(Side::b)};
  for (const Side side : both_sides)
    state.trees[index_of(side)].follow(stories[index_of(side)], session.selected_event(side));

  begin_tool_content();
  ImGui::BeginChild("story");
  if (std::exchange(state.scrolled, *picked) != *picked) ImGui::SetScrollY(0);
  values().publish("pixel/scrolled", fmt::format("{:.0f}", ImGui::GetScrollY()));
  switch (shown) {
  case Shown::both:
    both(session, state, stories);
    break;
  case Shown::parting:
    parting_view(session, state.parting, stories);
    break;
  case Shown::one: {
    const Side side = session.document().picked;
    if (session.file_of(side)) {
      file_pixel(session, *picked, stories[0]);
      ImGui::Separator();
      if (stories[0]) full_story(session, state, Side::a, *stories[0], copy);
      break;
    }
    if (const auto message = session.work().inspector(side).message(); !message.empty()) show_paragraph(message);
    if (const auto& story = stories[index_of(side)]) full_story(session, state, side, *story, copy);
    break;
  }
  }
  ImGui::EndChild();
}

}  // namespace ps::gui
