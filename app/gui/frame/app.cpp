#include "gui/frame/app.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>  // ClosePopupToLevel

#include <algorithm>
#include <chrono>
#include <sstream>
#include <utility>

#include "document/permalink.h"
#include "document/permalink_file.h"
#include "engine/lesson.h"
#include "gui/base/fit.h"
#include "gui/frame/about.h"
#include "gui/frame/drop.h"
#include "gui/frame/file_dialog.h"
#include "gui/frame/follow_link.h"
#include "gui/frame/menu_bar.h"
#include "gui/frame/palette_entries.h"
#include "gui/frame/region.h"
#include "gui/frame/regions.h"
#include "gui/frame/shots.h"
#include "gui/frame/show_panel.h"
#include "gui/frame/status_bar.h"
#include "gui/frame/window_actions.h"
#include "gui/panels/pictures/dropped_picture.h"
#include "gui/panels/pictures/picture_actions.h"
#include "gui/panels/pictures/picture_gizmo.h"
#include "gui/panels/pictures/picture_values.h"
#include "gui/platform/imgui_version.h"
#include "gui/platform/state_file.h"
#include "gui/session/session_values.h"
#include "gui/shell/shell.h"
#include "gui/widgets/flash.h"
#include "gui/widgets/key_focus.h"
#include "gui/widgets/redraw.h"
#include "options/option.h"

namespace ps::gui {
namespace {

constexpr const char* layout_key = "app/layout";
constexpr const char* mode_key_of_state = "app/mode";
constexpr const char* first_look_key = "app/first-look";  // "answered" once the offer is taken, declined or passed by
/// Without backgrounds: the window is cleared to their colour.
constexpr ImGuiWindowFlags fixed_window = ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoDecoration |
                                          ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                                          ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoScrollWithMouse;
constexpr double progress_interval = 0.1;  // seconds

std::string layout_text(const Layout& layout) {
  return fmt::format("{} {} {} {} {}", layout.left, layout.right, layout.bottom, layout.story_open ? "story" : "folded",
                     layout.options_open ? "options" : "folded");
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
  std::string story, options;
  words >> story >> options;
  layout.story_open = story != "folded";
  layout.options_open = options == "options";
}

/// Whether no permalink says how the window is divided.
bool nothing_linked(const AppOptions& options) {
  return options.permalink.empty() && (options.scene.empty() || !permalink_in_file(options.scene));
}

std::filesystem::path autosave_folder(const AppOptions& options) {
  return options.remember ? StateFile::default_path().parent_path() : std::filesystem::path();
}

SessionHost session_host(Shell& shell) {
  return {.wake = [&shell] { shell.wake(); },
          .remembered = [&shell](const std::string& key) { return shell.remembered(key); },
          .remember_lines = [&shell](const std::string& key,
                                     std::string lines) { shell.remember_lines(key, std::move(lines)); }};
}

}  // namespace

struct App::Parts {
  Parts(Shell& of, const AppOptions& options, Document document);

  void add_actions();
  void offer_values();
  void update();
  void draw();
  void draw_status(ImVec2 window, float height);
  void close_on_escape();
  void keep_what_is_open();
  void show_options();
  void open_tool(std::string_view name);
  std::string status() const;
  bool unsafe_busy() const;
  bool busy() const;

  Shell& shell;
  Session session;
  PanelStates my;
  FileDialog files;
  PanelHost host;
  std::vector<Panel> panels;
  Regions regions;
  About about;
  MenuBar menu_bar;
  DroppedPicture dropped;
  StatusBarState status_bar;
  Autosave autosave;
  std::optional<std::uint64_t> kept_revision;  ///< of the document, that was saved last
  std::chrono::steady_clock::time_point started = std::chrono::steady_clock::now();
  std::uint64_t first_revision = 0;  ///< of the document, as it was opened
  bool offers_first_look = false;
  bool flying_now = false;
  double last_draw = 0;
};

App::Parts::Parts(Shell& of, const AppOptions& options, Document document)
    : shell(of), session(session_host(of)),
      my([&of] { of.wake(); }, options.remember), host{.copy =
                                                           [this](const std::string& text, const std::string& said) {
                                                             shell.set_clipboard(text);
                                                             session.say(Message::Kind::information, said);
                                                           },
                                                       .ask_file =
                                                           [this](FileQuestion question) {
                                                             files.ask(std::move(question));
                                                           }},
      panels(panel_table(session, my, host)), regions(session, my, panels),
      menu_bar(session, shell.actions(), panels, about, my.lessons.read, my.pictures.compare),
      autosave(autosave_folder(options)) {
  my.kept.presets = parse_kept(shell.remembered(presets_key));
  my.kept.bookmarks = parse_kept(shell.remembered(bookmarks_key));
  my.kept.remember = [this](const char* key, std::string lines) { shell.remember_lines(key, std::move(lines)); };
  my.lessons.read.names = parse_read_lessons(shell.remembered(read_lessons_key));
  my.lessons.read.remember = [this](std::string lines) { shell.remember_lines(read_lessons_key, std::move(lines)); };
  std::vector<Message> words;  // start() clears what was said before it
  const bool asked = !nothing_asked(options);
  auto left_behind = asked ? std::optional<Document>() : restored_document(autosave, session, words);
  offers_first_look = !asked && !left_behind && shell.remembers() && shell.remembered(first_look_key).empty();
  if (offers_first_look) document.pixel = {-1, -1};  // the story's place says what a click does
  if (left_behind) {
    document = std::move(*left_behind);
  } else if (nothing_linked(options)) {
    read_layout(shell.remembered(layout_key), document.layout);
    if (shell.remembered(mode_key_of_state) == mode_key(ScreenMode::lesson)) document.mode = ScreenMode::lesson;
  }
  session.start(std::move(document));
  for (const Message& message : words) session.say(message.kind, message.text);
  if (!options.lesson.empty()) {
    const LessonPlace place = parse_lesson_place(options.lesson);
    go_to_step(session, place.lesson, place.step);
  }
  first_revision = session.revision();
  add_actions();
  offer_values();
}

void App::Parts::add_actions() {
  Actions& actions = shell.actions();
  add_window_actions(actions, session, my.pictures, host);
  actions.add({.name = "scenes", .label = "Gallery of scenes", .group = "Scene", .keys = "Ctrl+Shift+O", .run = [this] {
                 open_scene_gallery(my.scenes);
               }});
  actions.add({.name = "lessons",
               .label = "Find a lesson: pictures, and a search in all texts",
               .group = "Lesson",
               .keys = "Ctrl+L",
               .run = [this] { open_lesson_picker(my.picker, session); }});
  add_picture_actions(actions, session, my.pictures);
  add_shot_actions(actions, session, my.pictures,
                   [this](std::function<void(Image<Rgb8>)> take) { shell.take_shot(std::move(take)); });
  actions.add({.name = "kept",
               .label = "Presets and bookmarks: keep options or the screen under a name",
               .group = "Edit",
               .keys = "M",
               .run = [this] { my.kept.open = my.kept.just_opened = true; },
               .enabled = [this] { return session.has_scene(); }});
  actions.add({.name = "object",
               .label = "Object: place, size and material of the picked one",
               .group = "Edit",
               .run =
                   [this] {
                     my.options.object.open = true;
                     my.options.object.come = 3;
                     show_options();
                     key_focus().go_to("options/object/gizmo");
                   },
               .enabled = [this] { return session.has_scene(); }});
  for (const Panel& panel : panels) {
    if (panel.actions) panel.actions(actions);
    if (panel.place == PanelPlace::below)
      actions.add({.name = "study-" + std::string(panel.name),
                   .label = std::string(panel.command),
                   .group = "Study",
                   .run = [this, name = panel.name] { open_tool(name); },
                   .enabled = [this] { return session.has_scene(); }});
  }
  actions.add({.name = "vertex-film",
               .label = "Vertex: play its way from the model to the canvas",
               .group = "Study",
               .run =
                   [this] {
                     open_tool(tool_names::vertex);
                     play_film(my.vertex.film);
                   },
               .enabled = [this] { return session.has_scene(); }});
  actions.add({.name = "film-frame",
               .label = "Stability: go through the frames of the film strip",
               .group = "Study",
               .run =
                   [this] {
                     open_tool(tool_names::stability);
                     key_focus().go_to("stability/scrub");
                   },
               .enabled = [this] { return session.has_scene(); }});
  actions.add(
      {.name = "range",
       .label = "Set the range of the false colours",
       .group = "View",
       .run = [] { key_focus().go_to("view/a/range/low"); },
       .enabled =
           [this] { return session.has_scene() && shown_channel(session.shown(Side::a)).heat.value != nullptr; }});
  actions.add({.name = "range-auto",
               .label = "False colours in the range of the pictures' own values",
               .group = "View",
               .run = [this] { session.navigate([](Document& document) { document.heat_range.reset(); }); },
               .enabled = [this] { return session.has_scene() && session.document().heat_range.has_value(); }});
  add_drawer_actions(actions, session, panels, my.drawer);
  actions.offer_more(
      [this] { return palette_entries(session, my.lessons.column, my.options, my.kept, [this] { show_options(); }); });
}

void App::Parts::open_tool(std::string_view name) {
  make_room_for(session, find_panel(panels, name));
  show_tool(session, my.lessons.column, name);
}

void App::Parts::offer_values() {
  offer_session_values(values(), session);
  offer_picture_values(values(), session, my.pictures);
  offer_unsafe_values(values(), my.unsafe);
  for (const Panel& panel : panels)
    if (panel.publish) panel.publish(values());
  values().offer("actions", [this] {
    std::string names;
    for (const Action& action : shell.actions().all()) names += (names.empty() ? "" : " ") + action.name;
    return names;
  });
  values().offer_below("area/", [](std::string_view name) { return noted_area(name); });
  values().offer("window/cut", [] { return fit_watch().cut(); });
  values().offer("window/overlap", [] { return fit_watch().overlap(); });
  values().offer("scenes/open", [this] { return my.scenes.open; });
  values().offer("picker/open", [this] { return my.picker.open; });
  values().offer("picker/pictures", [this] { return static_cast<int>(my.picker.thumbnails.count()); });
  offer_drawer_values(values(), session, panels);
  values().offer("first-look/offered", [this] { return offers_first_look; });
}

void App::Parts::show_options() {
  my.history.open = false;
  set_mode(session, ScreenMode::explore);
  session.navigate([](Document& document) { document.layout.options_open = true; });
}

/// Esc leaves whatever is in front: an open menu, flying, a picture that is alone.
void App::Parts::close_on_escape() {
  if (!key_pressed(Key::escape, KeyRepeat::once) || key_focus().left_by_escape()) return;
  if (cancel_picture_drag(session, my.pictures) || cancel_space_drag(session, my.space)) return;
  if (ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel)) {
    ImGui::ClosePopupToLevel(0, true);
    return;
  }
  bool left = false;  // sheets over the window
  for (bool* open : {&about.open, &my.scenes.open, &my.picker.open, &my.kept.open, &my.lessons.glossary.open,
                     &my.lessons.notes.open})
    left |= std::exchange(*open, false);
  if (left) return;
  if (!dropped.file.empty()) {
    dropped = {};
    return;
  }
  my.pictures.fly = false;
  if (my.predict.on && prediction_pending(session, my.predict) && asks_about_pixel(session, my.predict)) {
    my.predict.on = false;
    return;
  }
  if (session.region()) return session.set_region({});
  if (!session.document().layout.filled.empty()) return fill_window(session, {});
  if (my.history.open) {
    my.history.open = false;
    return;
  }
  if (leave_presenter(session)) return;
  session.navigate([](Document& document) {
    document.layout.panels = true;
    if (document.compare == CompareMode::only_a || document.compare == CompareMode::only_b)
      document.compare = CompareMode::side_by_side;
  });
}

void App::Parts::update() {
  const double now = ImGui::GetTime();
  const double passed = std::min(now - last_draw, 0.1);
  last_draw = now;
  close_on_escape();
  session.update();
  flying_now = fly_camera(session, my.pictures, passed);
  collect_pictures(session, my.pictures);
  my.pictures.picked.update(session);
  for (const Panel& panel : panels)
    if (panel.update) panel.update();
  update_unsafe(session, my.unsafe);
}

std::string App::Parts::status() const {
  for (const Panel& panel : panels)
    if (panel.status)
      if (std::string text = panel.status(); !text.empty()) return text;
  return {};
}

bool App::Parts::unsafe_busy() const {
  return std::any_of(my.unsafe.sides.begin(), my.unsafe.sides.end(),
                     [](const UnsafeSide& side) { return side.study.running(); });
}

bool App::Parts::busy() const {
  return session.busy() || my.pictures.meter->busy() || my.pictures.meter->has_news() || unsafe_busy() ||
         (my.scenes.open && my.scenes.thumbnails.busy()) || (my.picker.open && my.picker.thumbnails.busy()) ||
         std::any_of(panels.begin(), panels.end(), [](const Panel& panel) { return panel.busy && panel.busy(); });
}

/// Autosaves the document for the case of a crash, and remembers the layout for the next start.
void App::Parts::keep_what_is_open() {
  constexpr std::chrono::seconds start{30};
  if (session.revision() != first_revision && std::chrono::steady_clock::now() - started >= start)
    autosave.outlived_start();
  const bool failed = !autosave.problem().empty();
  if (kept_revision == session.revision() && !failed) return;
  kept_revision = session.revision();
  autosave.save(session.permalink());
  constexpr double next_try = 5;  // seconds
  if (const std::string& problem = autosave.problem(); !problem.empty()) {
    if (!failed)
      session.say(Message::Kind::warning, fmt::format("What is open is not saved any more for the next start: {}. "
                                                      "It is tried again every few seconds.",
                                                      problem));
    redraw_after(next_try);
  } else if (failed) {
    session.say(Message::Kind::information, "What is open is saved again for the next start.");
  }
  shell.remember(layout_key, layout_text(session.document().layout));
  shell.remember(mode_key_of_state, std::string(mode_key(session.document().mode)));
}

void App::Parts::draw_status(ImVec2 window, float height) {
  ImGui::SetCursorScreenPos({px(8), window.y - height + px(1)});
  ImGui::BeginChild("status", {window.x - px(16), height - px(1)}, false, fixed_window);
  StatusHint hint{.text = status()};
  if (const auto task = regions.question_in_line()) {
    hint = {StatusHint::Kind::task, *task};
    ImGui::SameLine(0, px(16));
  } else if (hint.text.empty()) {
    hint.text = fmt::format("Click a pixel to see how it got its colour.   {} shows all keys.",
                            shell.actions().key_text("help"));
  }
  gui::status_bar(session, my.pictures, status_bar, hint);
  ImGui::EndChild();
}

void App::Parts::draw() {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize(size);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0);
  // The presenter's audience sees pictures and text alone.
  const bool presents = session.document().mode == ScreenMode::presenter;
  ImGui::Begin("pixelscope", nullptr, fixed_window | (presents ? ImGuiWindowFlags_None : ImGuiWindowFlags_MenuBar));
  ImGui::PopStyleVar(3);
  if (!presents) menu_bar.draw();
  const float top = ImGui::GetCursorScreenPos().y, status_height = presents ? 0 : ImGui::GetFrameHeight() + px(2);
  regions.draw({{0, top}, {size.x, size.y - status_height - status_bar.bars_height}}, offers_first_look);
  // Opening a lesson in any other way dismisses the offer.
  if (regions.first_look_answered() || (offers_first_look && !session.document().lesson.empty())) {
    offers_first_look = false;
    shell.remember(first_look_key, "answered");
  }
  if (!presents) draw_status(size, status_height);
  ImGui::End();
  message_bars(session, status_bar, px(8), size.x - px(8), size.y - status_height);
  if (const auto experiment = unsafe_lines(session, my.unsafe, my.pictures)) {
    my.stability.show(*experiment);
    open_tool(tool_names::stability);
  }
  files.draw();
  about.draw();
  scene_gallery(session, my.scenes);
  lesson_picker(session, my.picker, my.lessons.read);
  kept_panel(session, my.kept);
  dropped_picture(session, dropped);
  if (auto link = glossary_sheet(session, my.lessons.glossary)) my.lessons.followed = std::move(link);
  if (auto link = notes_sheet(session, my.lessons.notes, my.lessons.open(session)))
    my.lessons.followed = std::move(link);
  if (const auto followed = std::exchange(my.lessons.followed, {}))
    follow_link(session, my, *followed, [this] { show_options(); });
  draw_flash();
}

App::App(Shell& shell, const AppOptions& options, Document document)
    : parts_(std::make_unique<Parts>(shell, options, std::move(document))) {}

App::~App() = default;

void App::draw() {
  Parts& my = *parts_;
  my.update();
  my.draw();
  my.session.request_changed();
  my.keep_what_is_open();
  // Progress moves also between tiles.
  if (my.session.busy() || my.unsafe_busy() || !my.status().empty()) my.shell.wake_after(progress_interval);
}

bool App::busy() const { return parts_->busy(); }
bool App::animating() const { return parts_->flying_now; }

void App::open(const std::string& path_or_name) { parts_->session.open(path_or_name); }

void App::drop(const std::string& path, std::optional<WindowPoint> at) {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  take_dropped_file(parts_->session, parts_->my.pictures, parts_->dropped, path,
                    at.value_or(WindowPoint{mouse.x, mouse.y}));
}

void App::set_option(Side side, const std::string& assignment) {
  Session& session = parts_->session;
  Settings settings = session.settings(side);
  parse_assignment(assignment, settings);
  session.set_settings(side, settings, fmt::format("{}: {}", letter_of(side), assignment));
  parts_->shell.wake();
}

std::optional<WindowPoint> App::pixel_place(Side side, Vec2i pixel) const {
  const PicturesState& pictures = parts_->my.pictures;
  const auto& area = pictures.areas[index_of(side)];
  if (!area) return {};
  const ImVec2 at = pictures.transform.to_window({pixel.x + 0.5, pixel.y + 0.5}, *area);
  if (!area->contains(at)) return {};
  // Of a picture that A and B share, each shows its part; flicker lets them change places.
  const Side left = pictures.flip ? Side::b : Side::a;
  if (pictures.split_at && (at.x < *pictures.split_at) != (side == left)) return {};
  return WindowPoint{at.x, at.y};
}

bool App::may_close() {
  parts_->keep_what_is_open();
  return true;
}

void App::ended_from_outside() {
  parts_->keep_what_is_open();
  parts_->autosave.outlived_start();  // it did not end by itself
  parts_->autosave.keep();
}

void App::warn(const std::string& sentence) { parts_->session.say(Message::Kind::warning, sentence); }

}  // namespace ps::gui
