#include "gui/frame/app.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>  // ClosePopupToLevel

#include <algorithm>
#include <sstream>
#include <utility>

#include "document/permalink.h"
#include "document/permalink_file.h"
#include "gui/frame/bottom_tab_table.h"
#include "gui/input/actions.h"
#include "gui/panels/studies/timings_panel.h"
#include "gui/platform/state_file.h"
#include "gui/widgets/tab_row.h"
#include "gui/widgets/widgets.h"
#include "options/option.h"
#include "scene/load.h"

namespace ps::gui {
namespace {

constexpr const char* first_scene = "cgfs/reflections";
constexpr const char* layout_key = "app/layout";
constexpr const char* first_look_key = "app/first-look";  // "answered" once the offer is taken, declined or passed by
/// Without backgrounds: the window is cleared to their colour.
constexpr ImGuiWindowFlags fixed_window = ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoDecoration |
                                          ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                                          ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoScrollWithMouse;

/// The sizes of the regions in pixels where the document leaves them to the window. They grow with it only so far that
/// the pictures keep more than half of it.
float automatic_left(float width) { return std::clamp(width * 0.2f, std::min(px(250), width * 0.26f), px(290)); }
float automatic_right(float width) { return std::clamp(width * 0.26f, std::min(px(236), width * 0.3f), px(390)); }
/// One line: the title that opens it.
float folded_height() { return ImGui::GetFrameHeight() + px(8); }
constexpr double opened_share = 0.3;  // of the height, when the title is clicked

std::string layout_text(const Layout& layout) {
  return fmt::format("{} {} {}", layout.left, layout.right, layout.bottom);
}

void read_layout(const std::string& text, Layout& layout) {
  std::istringstream words(text);
  double left = 0, right = 0, bottom = 0;
  if (!(words >> left >> right >> bottom)) return;
  const auto sensible = [](double share) { return share >= 0 && share < 0.6; };
  if (sensible(left) && sensible(right) && sensible(bottom)) {
    layout.left = left;
    layout.right = right;
    layout.bottom = bottom;
  }
}

/// Whether no permalink says how the window is divided.
bool nothing_linked(const AppOptions& options) {
  return options.permalink.empty() && (options.scene.empty() || !permalink_in_file(options.scene));
}

std::filesystem::path autosave_folder(const AppOptions& options) {
  return options.remember ? StateFile::default_path().parent_path() : std::filesystem::path();
}

}  // namespace

Document first_document(const AppOptions& options) {
  if (!options.lesson.empty()) load_lesson(options.lesson);
  Document document;
  std::string link = options.permalink;
  if (link.empty() && !options.scene.empty()) link = permalink_in_file(options.scene).value_or("");
  if (!link.empty()) {
    document = parse_permalink(link);
    attach_scene(document, load_scene(document.scene_name));
  } else {
    const std::string scene = options.scene.empty() ? first_scene : options.scene;
    document = open_document(scene, load_scene(scene));
  }
  for (const auto& assignment : options.set) parse_assignment(assignment, document.a.settings);
  for (const auto& assignment : options.set_b) parse_assignment(assignment, document.b.settings);
  const View before = view_of(document);
  if (options.width > 0) document.view.width = options.width;
  if (options.height > 0) document.view.height = options.height;
  // The telling pixel is meant for the scene's own size.
  const View after = view_of(document);
  if (document.pixel.x >= 0)
    document.pixel = {document.pixel.x * after.width / before.width, document.pixel.y * after.height / before.height};
  fit_region(document);
  return document;
}

App::App(Shell& shell, const AppOptions& options, Document document)
    : shell_(shell),
      session_({.wake = [&shell] { shell.wake(); },
                .remembered = [&shell](const std::string& key) { return shell.remembered(key); },
                .remember_lines = [&shell](const std::string& key,
                                           std::string lines) { shell.remember_lines(key, std::move(lines)); }}),
      pixel_panel_([&shell] { shell.wake(); }), space_([&shell] { shell.wake(); }),
      microscope_([&shell] { shell.wake(); }), pixels_([&shell] { shell.wake(); }),
      listing_([&shell] { shell.wake(); }), history_([&shell] { shell.wake(); }),
      studies_([&shell] { shell.wake(); }, options.remember), autosave_(autosave_folder(options)) {
  pictures_.meter = std::make_unique<DifferenceMeter>([&shell] { shell.wake(); });
  const bool nothing_asked = options.scene.empty() && options.permalink.empty() && options.lesson.empty();
  std::vector<Message> words;  // start() clears what was said before it
  auto left_behind = nothing_asked ? restored(words) : std::optional<Document>();  // else it waits for another start
  offers_first_look_ = nothing_asked && !left_behind && shell.remembers() && shell.remembered(first_look_key).empty();
  if (left_behind)
    document = std::move(*left_behind);
  else if (nothing_linked(options))
    read_layout(shell.remembered(layout_key), document.layout);
  session_.start(std::move(document));
  for (const Message& message : words) session_.say(message.kind, message.text);
  if (!options.lesson.empty()) go_to_step(session_, options.lesson, 0);
  space_.save = [this] { files_.ask(FilePurpose::save_space, "space.svg"); };
  microscope_.save = [this] { files_.ask(FilePurpose::save_microscope, "pixel.svg"); };
  add_actions();
}

void App::set_option(Side side, const std::string& assignment) {
  Settings settings = session_.settings(side);
  parse_assignment(assignment, settings);
  session_.set_settings(side, settings, fmt::format("{}: {}", letter_of(side), assignment));
  shell_.wake();
}

bool App::busy() const {
  return session_.busy() || session_.has_news() || space_.worker.busy() || space_.worker.has_news() ||
         space_.tree_worker.busy() || space_.tree_worker.has_news() || microscope_.worker.busy() ||
         microscope_.worker.has_news() || history_.thumbnails.busy() || studies_.busy() || listing_.worker.busy() ||
         listing_.worker.has_news() || pixels_.cost.busy() || pixels_.cost.has_news() || pictures_.meter->busy() ||
         pictures_.meter->has_news() || pin_busy(pixel_panel_.pin);
}

std::optional<WindowPoint> App::pixel_place(Side side, Vec2i pixel) const {
  const auto& area = pictures_.areas[index_of(side)];
  if (!area) return {};
  const ImVec2 at = pictures_.transform.to_window({pixel.x + 0.5, pixel.y + 0.5}, *area);
  if (!area->contains(at)) return {};
  return WindowPoint{at.x, at.y};
}

bool App::may_close() {
  remember_layout();
  return true;
}

void App::ended_from_outside() {
  remember_layout();
  autosave_.keep();
}

void App::remember_layout() { shell_.remember(layout_key, layout_text(session_.document().layout)); }

/// Esc leaves whatever is in front: an open menu, flying, a picture that is alone.
void App::close_on_escape() {
  if (!ImGui::IsKeyPressed(parse_chord("Esc").scancode, false)) return;
  if (ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel)) {
    ImGui::ClosePopupToLevel(0, true);
    return;
  }
  if (about_open_) {
    about_open_ = false;
    return;
  }
  if (!dropped_.file.empty()) {
    dropped_ = {};
    return;
  }
  pictures_.fly = false;
  if (session_.region()) {
    session_.set_region({});
    return;
  }
  if (!filling().empty()) {
    fill({});
    return;
  }
  if (history_.open) {
    history_.open = false;
    return;
  }
  session_.navigate([](Document& document) {
    document.layout.panels = true;
    if (document.compare == CompareMode::only_a || document.compare == CompareMode::only_b)
      document.compare = CompareMode::side_by_side;
  });
}

void App::draw() {
  const double now = ImGui::GetTime();
  const double passed = std::min(now - last_draw_, 0.1);
  last_draw_ = now;
  close_on_escape();
  session_.update();
  flying_now_ = fly_camera(session_, pictures_, passed);
  collect_pictures(session_, pictures_);
  if (session_.has_scene()) follow_stories(session_, pixel_panel_);
  mirror_screen(session_, pixel_panel_, mirror_);
  update_pin(session_, pixel_panel_.pin);
  listing_.worker.take_news();
  const Layout& shares = session_.document().layout;
  const StoryPanels story_panels{pixel_panel_, space_, microscope_, listing_, vertex_};
  mirror_story(session_, story_panels, mirror_, story_mirror_);
  update_vertex(session_, vertex_, shares.panels && shares.bottom > 0 && shares.bottom_tab == "vertex");
  space_.vertex = vertex_.chain;
  update_space(session_, space_);
  restore_play(session_, story_panels, mirror_, story_mirror_);
  studies_.update(session_);
  update_pixels(session_, pixels_, pictures_);
  pictures_.asked.reset();
  if (session_.pixel() && prediction_pending(session_, predict_))
    pictures_.asked = Hover{inspected_side(session_), *session_.pixel()};

  const ImVec2 size = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize(size);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0);
  ImGui::Begin("pixelscope", nullptr, fixed_window | ImGuiWindowFlags_MenuBar);
  ImGui::PopStyleVar(3);
  menu_bar();
  const float top = ImGui::GetCursorScreenPos().y, status_height = ImGui::GetFrameHeight() + px(6);
  layout({{0, top}, {size.x, size.y - status_height - status_bar_.bars_height}});
  ImGui::SetCursorScreenPos({px(12), size.y - status_height + px(3)});
  ImGui::BeginChild("status", {size.x - px(24), status_height - px(3)}, false, fixed_window);
  const std::string study = studies_.status();
  status_bar(session_, pictures_, status_bar_,
             study.empty() ? "Click a pixel to see how it got its colour.   ? shows all keys." : study);
  ImGui::EndChild();
  ImGui::End();
  message_bars(session_, status_bar_, px(8), size.x - px(8), size.y - status_height);
  if (studies_.unsafe(session_, pictures_)) show_tab("stability");
  file_dialog();
  about();
  dropped_picture(session_, dropped_);
  session_.request_changed();
  publish();
  autosave_.save(session_.permalink());
  if (session_.busy() || studies_.busy()) shell_.wake_after(0.1);  // progress moves also between tiles
}

/// A region with its heading; call ImGui::EndChild() after what is in it. A double click on the heading lets the region
/// fill the window, another one or Esc takes it back.
void App::begin_region(const char* name, const Area& area, const char* heading) {
  ImGui::SetCursorScreenPos(area.min);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {px(12), px(8)});
  ImGui::BeginChild(name, {area.width(), area.height()}, false,
                    ImGuiWindowFlags_AlwaysUseWindowPadding | ImGuiWindowFlags_NoScrollbar |
                        ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PopStyleVar();
  if (heading) region_heading(name, heading);
}

void App::region_heading(const char* name, const char* heading) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const FontScope font(Face::bold);
  ImGui::InvisibleButton("heading", {std::max(ImGui::GetContentRegionAvail().x, 1.f), ImGui::GetTextLineHeight()});
  const bool hovered = ImGui::IsItemHovered();
  controls().record(std::string("region/") + name, filling() == name ? "fills the window" : heading);
  if (hovered && ImGui::IsMouseDoubleClicked(0)) fill(filling() == name ? "" : name);
  ImGui::GetWindowDrawList()->AddText(at, colour_u32(hovered ? palette().text : palette().text_quiet), heading);
  const FontScope body(Face::body);
  tooltip(filling() == name ? "Double-click or Esc: back to the pictures."
                            : "Double-click: fill the window with this.");
}

void App::layout(const Area& area) {
  Layout shares = session_.document().layout;
  const float margin = px(6);
  const float width = area.width(), height = area.height();
  if (!filling().empty()) {
    if (filling() == "right")
      right_region(area);
    else if (filling() == "bottom")
      bottom_region(area);
    else
      left_region(area);
    pictures_.areas = {};
    pictures_.notes = {};
    return;
  }
  if (!shares.panels) {
    pictures_panel(session_, pictures_, {{area.min.x + margin, area.min.y}, {area.max.x - margin, area.max.y}});
    return;
  }
  const float grip = px(6), least = px(180), folded = folded_height();
  const float wanted_left = shares.left > 0 ? static_cast<float>(shares.left) * width : automatic_left(width);
  const float wanted_right = shares.right > 0 ? static_cast<float>(shares.right) * width : automatic_right(width);
  const float wanted_bottom = shares.bottom > 0 ? static_cast<float>(shares.bottom) * height : folded;
  auto left = std::round(wanted_left);
  auto right = std::round(width - wanted_right);
  auto bottom = std::round(height - grip - wanted_bottom);
  const float most_left = std::max(least, width * 0.5f - grip),
              least_right = std::min(width - least, width * 0.5f + grip);
  const float most_bottom = std::max(height - grip - folded, height * 0.3f);
  left = std::clamp(left, std::min(least, most_left), most_left);
  right = std::clamp(right, least_right, std::max(width - least, least_right));
  bottom = std::clamp(bottom, height * 0.3f, most_bottom);

  left_region({area.min, {area.min.x + left, area.max.y}});
  right_region({{area.min.x + right + grip, area.min.y}, area.max});
  bottom_region({{area.min.x + left + grip, area.min.y + bottom + grip}, {area.min.x + right, area.max.y}});
  pictures_panel(session_, pictures_,
                 {{area.min.x + left + grip + margin, area.min.y}, {area.min.x + right - margin, area.min.y + bottom}});

  bool finished = false;
  const auto line = [&](const char* name, SplitterAxis axis, ImVec2 at, float length, float& position, float low,
                        float high) {
    ImGui::SetCursorScreenPos(at);
    const Edit edit = splitter(name, axis, length, position, low, high);
    finished = finished || edit.finished;
    return edit.changed;
  };
  // Only what was dragged becomes a share of its own; the rest stays with what suits the window.
  if (line("split/left", SplitterAxis::left_right, {area.min.x + left, area.min.y}, height, left, least, most_left))
    session_.navigate([&](Document& document) { document.layout.left = left / width; });
  if (line("split/right", SplitterAxis::left_right, {area.min.x + right, area.min.y}, height, right, least_right,
           width - least))
    session_.navigate([&](Document& document) { document.layout.right = 1 - right / width; });
  if (line("split/bottom", SplitterAxis::up_down, {area.min.x + left + grip, area.min.y + bottom}, right - left - grip,
           bottom, height * 0.3f, most_bottom)) {
    const bool shut = bottom >= most_bottom - 1;
    session_.navigate([&](Document& document) { document.layout.bottom = shut ? 0 : 1 - (bottom + grip) / height; });
  }
  if (finished) remember_layout();
}

// Below it the list of options would have no line of its own.
constexpr double least_options_height = 280;

/// At the first start, until it is answered or a lesson is begun by other ways. Returns what room is left.
Area App::first_look(const Area& area) {
  if (!offers_first_look_) return area;
  const bool passed_by = !session_.document().lesson.empty();
  FirstLookAnswer answer = FirstLookAnswer::none;
  const float bottom = area.min.y + first_look_height();
  if (!passed_by) {
    begin_region("first-look", {area.min, {area.max.x, bottom}}, "NEW HERE?");
    answer = first_look_offer();
    ImGui::EndChild();
  }
  if (passed_by || answer != FirstLookAnswer::none) {
    offers_first_look_ = false;
    shell_.remember(first_look_key, "answered");
  }
  if (answer == FirstLookAnswer::start) go_to_step(session_, first_look_lesson, 0);
  return passed_by ? area : Area{{area.min.x, bottom}, area.max};
}

void App::left_region(const Area& area) {
  Area options = first_look(area);
  if (lessons_.open(session_)) {
    const float height = area.height(), grip = px(6);
    float divide = std::round(std::min(height * lesson_share_, height - px(least_options_height)));
    begin_region("lesson", {area.min, {area.max.x, area.min.y + divide}}, "LESSON");
    lesson_panel(session_, lessons_);
    ImGui::EndChild();
    ImGui::SetCursorScreenPos({area.min.x, area.min.y + divide});
    if (splitter("split/lesson", SplitterAxis::up_down, area.width(), divide, height * 0.2f, height * 0.8f).changed)
      lesson_share_ = divide / height;
    options.min.y += divide + grip;
  }
  if (history_.open) {
    begin_region("left", options, "HISTORY");
    history_panel(session_, history_);
    ImGui::EndChild();
    return;
  }
  begin_region("left", options, "OPTIONS");
  if (session_.has_scene()) options_panel(session_, options_panel_);
  if (const Option* swept = std::exchange(options_panel_.sweep, nullptr)) {
    sweep_option(studies_.chart(), *swept, options_panel_.side);
    show_tab("chart");
  }
  ImGui::EndChild();
}

void App::right_region(const Area& area) {
  begin_region("right", area, "PIXEL");
  if (prediction_pending(session_, predict_)) {
    predict_panel(session_, predict_);
    ImGui::EndChild();
    return;
  }
  prediction_verdict(session_, predict_);
  pixel_panel(session_, pixel_panel_, [this](const std::string& text) {
    shell_.set_clipboard(text);
    session_.say(Message::Kind::information, "Copied to the clipboard.");
  });
  ImGui::EndChild();
}

void App::bottom_region(const Area& area) {
  if (!(filling() == "bottom" || session_.document().layout.bottom > 0)) {
    bool open = false;
    begin_region("bottom", area);
    section("bottom/open", "SPACE, LISTING, CHART, NEEDS and others", open);
    toggle_bottom(open);
    ImGui::EndChild();
    return;
  }
  begin_region("bottom", area);
  constexpr std::size_t count = bottom_tabs.size();
  static constexpr auto tabs = [] {
    std::array<Choice, count + 1> choices;
    for (std::size_t i = 0; i < count; ++i)
      choices[i] = {bottom_tabs[i], bottom_tab_table[i].heading, bottom_tab_table[i].help};
    choices[count] = {"fold", "↓", "Hides the panels, so that the pictures have the whole window."};
    return choices;
  }();
  static constexpr auto brief = [] {
    std::array<std::string_view, count + 1> words;
    for (std::size_t i = 0; i < count; ++i) words[i] = bottom_tab_table[i].brief;
    words[count] = "↓";
    return words;
  }();
  int tab = 0;
  for (std::size_t i = 0; i + 1 < tabs.size(); ++i)  // all but the last are tabs
    if (tabs[i].key == session_.document().layout.bottom_tab) tab = static_cast<int>(i);
  if (tab_row("bottom", tabs, brief, tab)) {
    if (tabs[static_cast<std::size_t>(tab)].key == "fold")
      toggle_bottom(false);
    else
      session_.navigate([&](Document& document) {
        document.layout.bottom_tab = std::string(tabs[static_cast<std::size_t>(tab)].key);
      });
  }
  bottom_tab(std::string(tabs[static_cast<std::size_t>(tab)].key));
  ImGui::EndChild();
}

void App::bottom_tab(const std::string& tab) {
  const bool filled = filling() == "bottom";
  bool fill_or_not = false;
  const bool story = tab == "space" || tab == "microscope" || tab == "listing";
  if (story && prediction_pending(session_, predict_))
    ImGui::TextWrapped("The story is shown after your answer.");
  else if (tab == "space")
    fill_or_not = space_panel(session_, space_, pixel_panel_, pictures_, filled);
  else if (tab == "microscope")
    fill_or_not =
        microscope_panel(session_, microscope_, pixel_panel_.cursors[index_of(inspected_side(session_))], filled);
  else if (tab == "listing")
    fill_or_not = listing_panel(session_, listing_, filled);
  else if (tab == "vertex")
    fill_or_not = vertex_panel(session_, vertex_, filled);
  else if (tab == "pixels")
    fill_or_not = pixels_panel(session_, pixels_, pictures_, filled);
  else if (tab == "timings")
    timings_panel(session_);
  else
    fill_or_not =
        studies_.tab(tab, session_,
                     {.browse_reference = [this] { files_.ask(FilePurpose::open_picture); },
                      .ask_export = [this](const std::string& name) { files_.ask(FilePurpose::save_chart, name); },
                      .copy =
                          [this](const std::string& text) {
                            shell_.set_clipboard(text);
                            session_.say(Message::Kind::information, "The command is on the clipboard.");
                          }},
                     filled);
  if (fill_or_not) fill(filled ? "" : "bottom");
}

void App::fill(const std::string& region) {
  session_.navigate([&](Document& document) { document.layout.filled = region; });
}

/// Opens or shuts the region as its title asks.
void App::toggle_bottom(bool open) {
  const bool was_open = filling() == "bottom" || session_.document().layout.bottom > 0;
  if (open == was_open) return;
  if (filling() == "bottom") fill({});
  session_.navigate([&](Document& document) { document.layout.bottom = open ? opened_share : 0; });
  remember_layout();
}

}  // namespace ps::gui
