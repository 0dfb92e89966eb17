#include "gui/frame/regions.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/screen_names.h"
#include "gui/frame/drawer.h"
#include "gui/frame/region.h"
#include "gui/frame/show_panel.h"
#include "gui/input/key_hint.h"
#include "gui/panels/lesson/caption_strip.h"
#include "gui/panels/lesson/first_look.h"
#include "gui/panels/lesson/lesson_list.h"
#include "gui/panels/pictures/picture_frame.h"
#include "gui/panels/pictures/slow_strip.h"
#include "gui/panels/techniques/technique_bar.h"
#include "gui/theme/projected_type.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/shorten.h"
#include "gui/widgets/tab_row.h"
#include "gui/widgets/widgets.h"

namespace ps::gui {
namespace {

/// One line: the title that opens it.
float folded_height() { return ImGui::GetFrameHeight() + px(4); }

// Below it the list of options would have no line of its own.
constexpr double least_options_height = 280;

// Between a lesson's text and the pictures, besides the margins that both have: 12 at their sides, together. A narrow
// column has 16 in all, others 24.
constexpr double text_margin = 12, least_margin = 4, narrow_column = 356;

// With less width a tool's controls have a line of their own below the list of tools.
constexpr double least_line = 560;

// The presenter's: of the height, and of the width.
constexpr float most_of_caption = 0.6f, presented_tool = 0.46f;

/// The width at which a text in the body's type has 62 characters to the line, with the column's margins.
float reading_width() {
  constexpr std::string_view measure = "The light of a point is the sum of all that reaches it, and on";  // 62
  return text_width(measure) + px(text_margin + 2 * region_padding);
}

bool divider(const char* name, SplitterAxis axis, ImVec2 at, float length, float& position, float low, float high) {
  ImGui::SetCursorScreenPos(at);
  return splitter(name, axis, length, position, low, high).changed;
}

}  // namespace

void Regions::draw(const Area& area, bool offers_first_look) {
  offers_first_look_ = offers_first_look;
  answered_ = asks_in_line_ = false;
  lessons_.column.shared = false;
  if (!session_.document().layout.filled.empty()) return filled(area);
  switch (session_.document().mode) {
  case ScreenMode::lesson:
    return lesson(area);
  case ScreenMode::presenter:
    return presenter(area);
  case ScreenMode::explore:
    return explore(area);
  case ScreenMode::study:
    return study(area);
  }
}

void Regions::filled(const Area& area) {
  const std::string& region = session_.document().layout.filled;
  if (region == region_names::right)
    right(area, true);
  else if (region == region_names::bottom)
    drawer(area);
  else if (session_.document().mode == ScreenMode::lesson)
    lesson_text(area);
  else
    left(area, true);
  my_.pictures.drawn.areas = {};
  my_.pictures.drawn.notes = {};
}

PlanInput Regions::plan_input(const Area& area, PictureCaptions captions) const {
  const View view = session_.has_scene() ? session_.view() : View{};
  PlanInput input;
  input.area = area;
  input.window = ImGui::GetIO().DisplaySize;
  if (view.width > 0 && view.height > 0) input.picture = {view.width, view.height};
  input.one_picture = session_.document().compare != CompareMode::side_by_side;
  input.scale = px(1);
  const PictureMargins lines = picture_margins(px(600), captions);  // of a picture that is not narrow
  input.captions = lines.title + lines.footer + slow_strip_height(session_);
  input.text_width = reading_width();
  input.headline = folded_height();
  return input;
}

void Regions::pictures(const Area& area, double least_share, PictureCaptions captions, TwoPictures two) {
  const float margin = px(picture_margin);
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  const float strip = slow_strip_height(session_), bottom = area.max.y - strip;
  pictures_panel(session_, my_.pictures, {{area.min.x + margin, area.min.y}, {area.max.x - margin, bottom}},
                 {.captions = captions,
                  .least_pixels = least_share * window.x * window.y,
                  .two = two,
                  .covers = my_.pixel.covers()});
  note_area("pictures", area);
  for (const Side side : both_sides)
    if (const auto& own = my_.pictures.drawn.areas[index_of(side)]) note_area(side == Side::a ? "a" : "b", *own);
  if (strip <= 0) return;
  begin_region(session_, "slow-motion", {{area.min.x, bottom}, area.max}, {}, RegionPadding::tight);
  slow_strip(session_, my_.pictures.slow);
  ImGui::EndChild();
}

StagePlace Regions::stage_place() const {
  const std::string& stage = session_.document().layout.stage;
  if (stage == pictures_stage) return StagePlace::none;
  if (stage.empty()) return StagePlace::line;
  return staged().facts.height == PanelHeight::tall ? StagePlace::beside : StagePlace::below;
}

Panel& Regions::staged() const {
  const std::string& stage = session_.document().layout.stage;
  const bool story = stage.empty() || stage == pictures_stage || stage == story_names::one;
  return panel(story ? region_names::right : stage);
}

/// Sets the question that the lesson's text asks: its step's, or that of Predict.
void Regions::ask_in_text() {
  const bool asks = my_.pixel.asks(), by_lesson = lessons_.questions.asked_beside_text(session_);
  // Exploring, a question that no lesson asks is in the place of the pixel's story.
  const bool pending = asks && (by_lesson || session_.document().mode != ScreenMode::explore);
  lessons_.ask = nullptr;
  if (pending || by_lesson) lessons_.ask = [this, pending] { question(pending); };
}

void Regions::question(bool pending) {
  LessonQuestions& asked = lessons_.questions;
  const bool in_words = asked.asked_beside_text(session_) &&
                        (pending ? asked.question()->kind != AskKind::pixel : asked.bug_shown(session_));
  if (in_words) {
    const AskPlace place = lessons_.column.shared ? AskPlace::below_text : AskPlace::beside_tool;
    if (ask_lesson_question(session_, asked, place)) turn_column(lessons_.column);
  } else if (pending) {
    predict_panel(session_, my_.pixel.predict);
  } else {
    way_back_to_question(session_, asked);
  }
}

void Regions::lesson_text(const Area& area) {
  const Lesson* lesson = lessons_.shelf.open();
  if (!lesson) {
    begin_region(session_, region_names::lesson, area, "Lessons");
    if (lesson_list(session_, lessons_.read)) my_.picker.show();
    ImGui::EndChild();
    return;
  }
  titled_text(area, lesson->title);
}

/// The text of the open lesson, whose title may be shown elsewhere.
void Regions::titled_text(const Area& area, const std::string& title) {
  const float width = std::min(area.width(), reading_width());
  const float margin = px(width < px(narrow_column) ? least_margin : text_margin);
  const Area text{area.min, {area.min.x + width - margin, area.max.y}};
  ask_in_text();
  begin_region(session_, region_names::lesson, text, title);
  panel(region_names::lesson).draw({.filled = session_.document().layout.filled == region_names::lesson});
  ImGui::EndChild();
}

/// The tabs of text and tool, and what belongs to the one that is shown. Answers whether the tool asks for the whole
/// window.
bool Regions::column_head() {
  LessonColumn& column = lessons_.column;
  const std::string text_help = with_key("What the step says.", "text-or-tool"),
                    tool_help = with_key("The tool that the step is about.", "text-or-tool");
  const std::array tabs{Choice{"text", "Text", text_help}, Choice{"tool", staged().facts.heading, tool_help}};
  int index = column.shows == ColumnShows::text ? 0 : 1;
  if (tab_row("column", tabs, index)) column.shows = index == 0 ? ColumnShows::text : ColumnShows::tool;
  ImGui::SameLine(0, 0);
  ImGui::SetCursorPosY(ImGui::GetCursorPosY() + px(2));  // tabs are higher than buttons
  choose_stage(px(36), " ");
  ImGui::SameLine(0, px(12));
  if (column.shows == ColumnShows::tool)
    return (staged().facts.answers == Answers::no || !my_.pixel.asks()) && staged().head();
  const Lesson* lesson = lessons_.shelf.open();
  if (!lesson) return false;
  const FontScope font(Face::bold);
  const std::string title = whole_words(lesson->title, ImGui::GetContentRegionAvail().x);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos({at.x, at.y + ImGui::GetStyle().FramePadding.y});
  region_heading(session_, region_names::lesson, title);
  return false;
}

std::optional<std::string> Regions::question_in_line() {
  if (!asks_in_line_) return std::nullopt;
  LessonQuestions& asked = lessons_.questions;
  if (!asked.bug_shown(session_)) {
    way_back_button(session_);
    return std::string(why_question_waits);
  }
  std::string sentence = asked.question()->text;
  if (ask_lesson_question(session_, asked, AskPlace::in_line)) turn_column(lessons_.column);
  return sentence;
}

/// The place that text and tool share, with tabs that choose.
void Regions::column(const Area& area) {
  LessonColumn& column = lessons_.column;
  const std::string_view wanted = controls().revealing();  // by a script
  if (wanted.starts_with(std::string(staged().facts.name) + "/")) column.shows = ColumnShows::tool;
  if (wanted.starts_with("lesson/") || wanted.starts_with("predict/")) column.shows = ColumnShows::text;
  const float head = ImGui::GetFrameHeight() + px(4 + 1);
  begin_region(session_, "column", {area.min, {area.max.x, area.min.y + head}}, {}, RegionPadding::tight);
  bool fill = column_head();
  ImGui::EndChild();
  const Area below{{area.min.x, area.min.y + head}, area.max};
  if (column.shows == ColumnShows::text) return titled_text(below, {});
  // A question for a line of the listing is answered there, in the window's last line, so that the code keeps its own.
  const LessonQuestions& asked = lessons_.questions;
  asks_in_line_ = asked.asked_beside_text(session_) && asked.question()->kind == AskKind::bug;
  begin_region(session_, "stage", below, {}, RegionPadding::tight);
  fill = tool(staged(), {.filled = false, .headed = true}) || fill;
  ImGui::EndChild();
  if (fill) fill_with_stage();
}

void Regions::lesson(const Area& area) {
  // The lines around the pictures are what gives way to a tool, and where type is large beside the window.
  const StagePlace wanted = stage_place();
  const bool one = session_.document().compare != CompareMode::side_by_side;
  const bool small = area.width() < px(1200) || area.height() < px(one ? 850 : 600);
  const bool staged = wanted == StagePlace::below || wanted == StagePlace::beside;
  const PictureCaptions captions = small || staged ? PictureCaptions::brief : PictureCaptions::full;
  const LessonPlan plan = plan_lesson(plan_input(area, captions), wanted);
  follow_column(session_, lessons_);
  lessons_.column.shared = plan.shared && session_.document().layout.panels && lessons_.shelf.open();
  if (lessons_.column.shared)
    column(plan.text);
  else
    lesson_text(plan.text);
  if (!session_.document().layout.panels) {
    pictures({plan.pictures.min, area.max}, lesson_share, captions);
    return;
  }
  if (plan.place == StagePlace::line) verdict_line(plan.stage);
  if (staged && !lessons_.column.shared) stage(plan.stage);
  pictures(plan.pictures, staged ? beside_share : lesson_share, captions);
}

/// What has less height than it needs can be scrolled. Answers whether the tool asks for the whole window, or no
/// longer.
bool Regions::tool(Panel& panel, const Context& context) {
  ImGui::BeginChild("tool");
  begin_tool_content();  // what has no toolbar, or is covered, has all of it
  const bool in_line = context.in_line && ImGui::GetContentRegionAvail().x >= px(least_line);
  if (context.in_line) choose_stage(px(150), {});
  if (in_line) ImGui::SameLine(0, px(12));
  bool asks = false;
  if (panel.facts.answers == Answers::yes && my_.pixel.asks())
    show_paragraph(story_after_answer);
  else
    asks = panel.draw({.filled = context.filled, .headed = context.headed, .in_line = in_line});
  ImGui::EndChild();
  return asks;
}

void Regions::fill_with_stage() {
  session_.navigate([&](Document& document) {
    document.layout.filled = region_names::bottom;
    document.layout.bottom_tab = staged().facts.name;
  });
}

/// The tool of the stage, from a list. `shown`: not empty: is written in place of its name.
void Regions::choose_stage(float width, std::string_view shown) {
  std::vector<Choice> tools{{"verdict", "Verdict", "What the story of the picked pixel ends with, in one line."},
                            {story_names::one, "Story", "The story of the picked pixel."}};
  const std::string& stage = session_.document().layout.stage;
  for (const Panel& each : panels_)
    if (each.facts.place == PanelPlace::below) tools.push_back({each.facts.name, each.facts.heading, each.facts.help});
  const auto found = std::find_if(tools.begin(), tools.end(), [&](const Choice& each) { return each.key == stage; });
  int index = stage.empty() ? 0 : found == tools.end() ? 1 : static_cast<int>(found - tools.begin());
  const std::string_view help = shown.empty() ? "What is shown with the pictures." : "Another tool for this step.";
  if (drop_down("stage", tools, index, width, {.tooltip = help, .shown = shown}))
    session_.navigate([&](Document& document) {
      document.layout.stage = index == 0 ? "" : std::string(tools[static_cast<std::size_t>(index)].key);
    });
}

/// The tool that the step is about; another one can be chosen.
void Regions::stage(const Area& area) {
  const bool tall = area.height() > area.width();  // from the menu to the status line
  begin_region(session_, "stage", area, {}, tall ? RegionPadding::tight : RegionPadding::normal);
  if (tool(staged(), {.in_line = true})) fill_with_stage();
  ImGui::EndChild();
}

/// The story of a step that is not about it, folded to its verdict; a click opens it.
void Regions::verdict_line(const Area& area) {
  begin_region(session_, "stage", area, {}, RegionPadding::tight);
  const auto story = session_.story(inspected_side(session_));
  const bool shown = story && !my_.pixel.asks();
  const float room = ImGui::GetContentRegionAvail().x - 2 * ImGui::GetStyle().FramePadding.x;
  const std::string line = shown ? "› " + story->verdict : "› Story of the picked pixel";
  const bool wanted = controls().revealing().starts_with("pixel/");  // by a script
  if (button("stage/open", whole_words(line, room), Emphasis::quiet, {.tooltip = "Opens the story of the pixel."}) ||
      wanted)
    session_.navigate([](Document& document) { document.layout.stage = story_names::one; });
  ImGui::EndChild();
}

void Regions::explore(const Area& whole) {
  if (!session_.document().layout.panels) return pictures(whole, explore_share, PictureCaptions::full);
  // A script that looks for a control of the options opens them, as their button does.
  if (controls().revealing().starts_with("options/") && !session_.document().layout.options_open)
    session_.navigate([](Document& document) { document.layout.options_open = true; });
  const float bar = technique_bar_height(whole.width());
  begin_region(session_, "techniques", {whole.min, {whole.max.x, whole.min.y + bar}}, {}, RegionPadding::tight);
  technique_bar(session_, {whole.min, {whole.max.x, whole.min.y + bar}});
  ImGui::EndChild();

  const Area area{{whole.min.x, whole.min.y + bar}, whole.max};
  const Layout shares = session_.document().layout;
  const bool has_left = shares.options_open || my_.history.open() || lessons_.shelf.open() != nullptr;
  const PictureCaptions captions = area.height() < px(600) ? PictureCaptions::brief : PictureCaptions::full;
  const ExplorePlan plan =
      plan_explore(plan_input(area, captions), {shares.left, shares.right, shares.bottom, has_left, shares.story_open});
  const float width = area.width(), height = area.height(), grip = px(6), folded = folded_height();
  const float least_left = std::min(px(180), width * 0.3f), least_right = std::min(px(180), width * 0.24f);
  float left_end = plan.left, right_begin = width - plan.right, bottom = height - grip - plan.bottom;
  const ImVec2 at = area.min;
  const float middle = has_left ? left_end + grip : 0;  // where the pictures begin
  if (has_left) left({at, {at.x + left_end, area.max.y}}, shares.options_open || my_.history.open());
  right({{at.x + right_begin + grip, at.y}, area.max}, shares.story_open);
  drawer({{at.x + middle, at.y + bottom + grip}, {at.x + right_begin, area.max.y}});
  pictures({{at.x + middle, at.y}, {at.x + right_begin, at.y + bottom}}, explore_share, captions, TwoPictures::stay);

  // Only what was dragged becomes a share of its own; the rest stays with what suits the window.
  if (has_left && divider("split/left", SplitterAxis::left_right, {at.x + left_end, at.y}, height, left_end, least_left,
                          width * 0.5f))
    session_.navigate([&](Document& document) { document.layout.left = left_end / width; });
  if (shares.story_open && divider("split/right", SplitterAxis::left_right, {at.x + right_begin, at.y}, height,
                                   right_begin, width * 0.5f, width - least_right))
    session_.navigate([&](Document& document) { document.layout.right = 1 - right_begin / width; });
  const float most_bottom = std::max(height - grip - folded, height * 0.3f);
  const float corner = px(3);  // belongs to the vertical dividers
  if (divider("split/bottom", SplitterAxis::up_down, {at.x + middle + corner, at.y + bottom},
              right_begin - middle - 2 * corner, bottom, height * 0.3f, most_bottom)) {
    const bool shut = bottom >= most_bottom - 1;
    session_.navigate([&](Document& document) { document.layout.bottom = shut ? 0 : 1 - (bottom + grip) / height; });
  }
}

void Regions::presenter(const Area& area) {
  if (lessons_.blank) {
    ImGui::GetWindowDrawList()->AddRectFilled(area.min, area.max, IM_COL32(0, 0, 0, 255));
    my_.pictures.drawn.areas = {};
    my_.pictures.drawn.notes = {};
    return;
  }
  CaptionStrip strip(session_, lessons_, area.width() - 2 * px(region_padding));
  const float caption = area.max.y - std::min(strip.height(), area.height() * most_of_caption);
  Area shown{area.min, {area.max.x, caption}};
  // A figure of the text, or else the step's tool, has the place of the second picture.
  const Figure* figure = strip.figure();
  const StagePlace place = lessons_.shelf.open() ? stage_place() : StagePlace::none;
  const bool beside = figure || place == StagePlace::below || place == StagePlace::beside;
  if (beside) {
    const float begin = std::round(area.max.x - area.width() * presented_tool);
    begin_region(session_, "stage", {{begin, area.min.y}, shown.max});
    if (figure) {
      draw_projected_figure(*figure);
    } else {
      const ProjectedType type;
      tool(staged(), {});
    }
    ImGui::EndChild();
    shown.max.x = begin;
  }
  pictures(shown, beside ? beside_share : lesson_share, PictureCaptions::projected);
  if (strip.height() <= 0) return;
  begin_region(session_, "caption", {{area.min.x, caption}, area.max});
  strip.draw(session_);
  ImGui::EndChild();
}

void Regions::study(const Area& area) {
  const bool reads = lessons_.shelf.open() && session_.document().layout.panels;
  const float text = reads ? std::round(std::min(area.width() * 0.3f, reading_width())) : 0;
  if (reads) lesson_text({area.min, {area.min.x + text, area.max.y}});
  const float share = reads ? 0.2f : 0.26f;  // of the pictures
  const float width = std::round(std::clamp(area.width() * share, px(200), px(460))), grip = px(6);
  const Area tools{{area.min.x + text, area.min.y}, {area.max.x - width - grip, area.max.y}};
  begin_region(session_, "study", tools);
  std::vector<Choice> tabs;
  std::vector<std::string_view> brief;
  int tab = -1;
  for (const Panel& each : panels_) {
    if (each.facts.place != PanelPlace::below || each.facts.use != PanelUse::study) continue;
    if (each.facts.name == session_.document().layout.bottom_tab) tab = static_cast<int>(tabs.size());
    tabs.push_back({each.facts.name, each.facts.heading, each.facts.help});
    brief.push_back(each.facts.brief);
  }
  if (tab < 0) {  // a tool that looks at one pixel was open
    tab = 1;
    show_panel(session_, tabs[static_cast<std::size_t>(tab)].key);
  }
  if (tab_row(region_names::bottom, tabs, brief, tab)) show_panel(session_, tabs[static_cast<std::size_t>(tab)].key);
  if (tool(panel(session_.document().layout.bottom_tab), {})) fill_window(session_, region_names::bottom);
  ImGui::EndChild();
  pictures({{area.max.x - width, area.min.y}, area.max}, 0, PictureCaptions::full);
}

/// At the first start, until it is answered, at the lower end of the story's column. Returns what room is left.
Area Regions::first_look(const Area& area) {
  if (!offers_first_look_ || !session_.document().lesson.empty()) return area;
  const float top = area.max.y - first_look_height(area.width() - 2 * px(region_padding));
  begin_region(session_, "first-look", {{area.min.x, top}, area.max}, "New here?");
  const FirstLookAnswer answer = first_look_offer();
  ImGui::EndChild();
  answered_ = answer != FirstLookAnswer::none;
  if (answer == FirstLookAnswer::start) go_to_step(session_, first_look_lesson, 0);
  return {area.min, {area.max.x, top}};
}

void Regions::panel_in(Panel& panel, std::string_view region, const Area& area) {
  begin_region(session_, region, area, std::string(panel.facts.heading));
  panel.draw({.filled = session_.document().layout.filled == region});
  ImGui::EndChild();
}

/// A lesson's text and the options or the history, whichever are open.
void Regions::left(const Area& area, bool has_options) {
  ask_in_text();
  if (lessons_.shelf.open() && !has_options) return panel_in(panel(region_names::lesson), region_names::lesson, area);
  Area options = area;
  if (lessons_.shelf.open()) {
    const float height = area.height(), grip = px(6);
    float divide = std::round(std::min(height * lesson_share_, height - px(least_options_height)));
    const Area upper{area.min, {area.max.x, area.min.y + divide}};
    panel_in(panel(region_names::lesson), region_names::lesson, upper);
    if (divider("split/lesson", SplitterAxis::up_down, {area.min.x, area.min.y + divide}, area.width(), divide,
                height * 0.2f, height * 0.8f))
      lesson_share_ = divide / height;
    options.min.y += divide + grip;
  }
  panel_in(panel(my_.history.open() ? my_.history.facts.name : region_names::left), region_names::left, options);
}

/// The pixel's story, or while it is folded the button that opens it.
void Regions::right(const Area& column, bool open) {
  const auto show = [&](bool opened) {
    session_.navigate([&](Document& document) { document.layout.story_open = opened; });
  };
  if (!open) {
    ImGui::SetCursorScreenPos({column.min.x, column.min.y + px(6)});
    if (button("pixel/open", "‹", Emphasis::quiet, {.tooltip = "Story: how the picked pixel got its colour."}))
      show(true);
    return;
  }
  const Area area = first_look(column);
  begin_region(session_, region_names::right, area);
  const bool filled = session_.document().layout.filled == region_names::right;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  if (!filled) {
    ImGui::SetCursorScreenPos({area.max.x - button_width("›") - px(6), area.min.y + px(2)});
    if (button("pixel/fold", "›", Emphasis::quiet, {.tooltip = "Folds the story away; ‹ opens it again."})) show(false);
    ImGui::SetCursorScreenPos(at);
  }
  region_heading(session_, region_names::right, std::string(panel(region_names::right).facts.heading),
                 filled ? 0 : button_width("›") + px(2));
  panel(region_names::right).draw({.filled = filled});
  ImGui::EndChild();
}

void Regions::drawer(const Area& area) {
  const bool open = bottom_is_open(session_.document());
  begin_region(session_, region_names::bottom, area, {}, open ? RegionPadding::normal : RegionPadding::tight);
  // Tools come with the first pixel; their place is kept.
  if (open || session_.pixel()) drawer_tabs(session_, panels_, my_.drawer);
  if (open) {
    const bool filled = session_.document().layout.filled == region_names::bottom;
    if (tool(panel(session_.document().layout.bottom_tab), {.filled = filled}))
      fill_window(session_, filled ? "" : region_names::bottom);
  }
  ImGui::EndChild();
}

}  // namespace ps::gui
