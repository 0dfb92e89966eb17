#include "gui/frame/app.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>  // ClosePopupToLevel

#include <algorithm>
#include <chrono>
#include <sstream>
#include <utility>

#include "base/enumerators.h"
#include "document/permalink.h"
#include "document/permalink_file.h"
#include "engine/lesson.h"
#include "gui/base/fit.h"
#include "gui/frame/drop.h"
#include "gui/frame/file_dialog.h"
#include "gui/frame/file_questions.h"
#include "gui/frame/follow_link.h"
#include "gui/frame/menu_bar.h"
#include "gui/frame/palette_entries.h"
#include "gui/frame/region.h"
#include "gui/frame/regions.h"
#include "gui/frame/shots.h"
#include "gui/frame/show_panel.h"
#include "gui/frame/status_bar.h"
#include "gui/frame/window_actions.h"
#include "gui/panels/pictures/picture_actions.h"
#include "gui/panels/pictures/picture_gizmo.h"
#include "gui/panels/pictures/picture_values.h"
#include "gui/platform/imgui_version.h"
#include "gui/platform/state_file.h"
#include "gui/session/session_values.h"
#include "gui/shell/shell.h"
#include "gui/theme/projected_type.h"
#include "gui/widgets/flash.h"
#include "gui/widgets/key_focus.h"
#include "gui/widgets/redraw.h"
#include "options/option.h"

namespace ps::gui {
namespace {

constexpr const char* layout_key = "app/layout";
constexpr const char* mode_key_of_state = "app/mode";
constexpr const char* folder_key = "files/folder";
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
  void follow_presenter();
  void update();
  void draw();
  void draw_status(ImVec2 window, float height);
  void close_on_escape();
  void keep_what_is_open();
  void take(const PanelMessage& message);
  void show_tool(const ShowTool& asked);
  std::string status() const;
  bool busy() const;

  Shell& shell;
  Session session;
  FileDialog files;
  PanelHost host;
  Panels my;
  Regions regions;
  MenuBar menu_bar;
  StatusBarState status_bar;
  Autosave autosave;
  std::optional<std::uint64_t> kept_revision;  ///< of the document, that was saved last
  std::chrono::steady_clock::time_point started = std::chrono::steady_clock::now();
  std::uint64_t first_revision = 0;  ///< of the document, as it was opened
  bool offers_first_look = false;
  bool flying_now = false;
  bool presented = false, filled_screen = false;  ///< by the presenter
  double last_draw = 0;
};

App::Parts::Parts(Shell& of, const AppOptions& options, Document document)
    : shell(of),
      session(session_host(of)), host{.session = session,
                                      .wake = [&of] { of.wake(); },
                                      .remember = options.remember,
                                      .remembered = [&of](const std::string& key) { return of.remembered(key); },
                                      .remember_lines =
                                          [&of](const std::string& key, std::string lines) {
                                            of.remember_lines(key, std::move(lines));
                                          },
                                      .copy =
                                          [this](const std::string& text, const std::string& said) {
                                            shell.set_clipboard(text);
                                            session.say(Message::Kind::information, said);
                                          },
                                      .ask_file = [this](FileQuestion question) { files.ask(std::move(question)); },
                                      .send = [this](const PanelMessage& message) { take(message); },
                                      .needs_processors =
                                          [this] {
                                            return session.work().rendering() ||
                                                   std::any_of(
                                                       my.all().begin(), my.all().end(),
                                                       [](const Panel& panel) { return panel.measures_times(); });
                                          }},
      my(host), regions(session, my),
      menu_bar(session, shell.actions(), my.all(), my.about, my.lessons.state.read, my.pictures.drawn.compare),
      autosave(autosave_folder(options)) {
  std::vector<Message> words;  // start() clears what was said before it
  const bool asked = !nothing_asked(options);
  auto left_behind = asked ? std::optional<Document>() : restored_document(autosave, session, words);
  offers_first_look = !asked && !left_behind && shell.remembers() && shell.remembered(first_look_key).empty();
  if (offers_first_look) document.pixel = {-1, -1};  // the story's place says what a click does
  if (left_behind) {
    document = std::move(*left_behind);
  } else if (nothing_linked(options)) {
    read_layout(shell.remembered(layout_key), document.layout);
    if (shell.remembered(mode_key_of_state) == enumerator_key(ScreenMode::lesson)) document.mode = ScreenMode::lesson;
  }
  session.start(std::move(document));
  for (const Message& message : words) session.say(message.kind, message.text);
  if (!options.lesson.empty()) {
    const LessonPlace place = parse_lesson_place(options.lesson);
    go_to_step(session, place.lesson, place.step);
  }
  first_revision = session.revision();
  files.keep_folder(shell.remembered(folder_key),
                    [this](const std::string& folder) { shell.remember(folder_key, folder); });
  add_actions();
  offer_values();
}

void App::Parts::add_actions() {
  Actions& actions = shell.actions();
  add_window_actions(actions, session, my.pictures, host);
  for (Panel& panel : my.all())
    if (panel.facts.place == PanelPlace::over) panel.add_actions(actions);
  add_picture_actions(actions, session, my.pictures);
  add_shot_actions(actions, session, my.pictures,
                   {.ask = [this](std::function<void(Image<Rgb8>)> take) { shell.take_shot(std::move(take)); },
                    .copy = [this](const std::string& text) { shell.set_clipboard(text); },
                    .last_folder = [this] { return files.folder(); }});
  ActionGroup tools(actions, "Study", [this] { return session.has_scene(); });
  for (Panel& panel : my.all()) {
    if (panel.facts.place != PanelPlace::over) panel.add_actions(actions);
    if (panel.facts.place == PanelPlace::below)
      tools.add("study-" + std::string(panel.facts.name), std::string(panel.facts.command), "",
                [this, name = panel.facts.name] { take(ShowTool{name}); });
  }
  ActionGroup(actions, "View", [this] {
    return session.has_scene() && shown_channel(session.shown(Side::a)).heat.value != nullptr;
  }).add("range", "Set the range of the false colours", "", [] { key_focus().go_to("view/a/range/low"); });
  ActionGroup(actions, "View", [this] {
    return session.has_scene() && session.document().heat_range.has_value();
  }).add("range-auto", "False colours in the range of the pictures' own values", "", [this] {
    session.navigate([](Document& document) { document.heat_range.reset(); });
  });
  add_drawer_actions(actions, session, my.all(), my.drawer);
  actions.offer_more([this] { return palette_entries(host, my.all()); });
}

void App::Parts::show_tool(const ShowTool& asked) {
  if (asked.room == ShowTool::Room::made) make_room_for(session, my.find(asked.name));
  show_panel(session, asked.name);
  if (session.document().mode == ScreenMode::lesson) my.lessons.state.column.shows = ColumnShows::tool;
}

/// Requests of panels to the window, after each panel has looked at them.
void App::Parts::take(const PanelMessage& message) {
  for (Panel& panel : my.all()) panel.take(message);
  if (const auto* tool = std::get_if<ShowTool>(&message)) return show_tool(*tool);
  if (const auto* mode = std::get_if<SetMode>(&message)) return set_mode(session, mode->mode);
  if (std::holds_alternative<ShowOptions>(message)) {
    set_mode(session, ScreenMode::explore);
    session.navigate([](Document& document) { document.layout.options_open = true; });
  }
  if (const auto* link = std::get_if<LinkTarget>(&message)) return follow_link(host, *link);
  if (const auto* drawing = std::get_if<SaveDrawing>(&message)) files.ask(save_drawing_question(session, *drawing));
}

void App::Parts::offer_values() {
  offer_session_values(values(), session);
  offer_picture_values(values(), session, my.pictures);
  for (Panel& panel : my.all()) panel.offer(values());
  values().offer("actions", [this] {
    std::string names;
    for (const Action& action : shell.actions().all()) names += (names.empty() ? "" : " ") + action.name;
    return names;
  });
  values().offer_below("area/", [](std::string_view name) { return noted_area(name); });
  values().offer("window/cut", [] { return fit_watch().cut(); });
  values().offer("window/overlap", [] { return fit_watch().overlap(); });
  offer_drawer_values(values(), session, my.all());
  values().offer("first-look/offered", [this] { return offers_first_look; });
}

/// Esc leaves whatever is in front: an open menu, flying, a picture that is alone.
void App::Parts::close_on_escape() {
  if (!key_pressed(Key::escape, KeyRepeat::once) || key_focus().left_by_escape()) return;
  if (cancel_picture_drag(session, my.pictures)) return;
  for (Panel& panel : my.all())
    if (panel.cancel_drag()) return;
  if (ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel)) {
    ImGui::ClosePopupToLevel(0, true);
    return;
  }
  bool left = false;
  for (Panel& panel : my.all())
    if (panel.facts.place == PanelPlace::over) left |= panel.close();
  if (left) return;
  my.pictures.keys.fly = false;
  if (my.pixel.stop_asking()) return;
  if (session.region()) return session.set_region({});
  if (!session.document().layout.filled.empty()) return fill_window(session, {});
  if (my.history.close()) return;
  if (leave_presenter(session)) return;
  session.navigate([](Document& document) {
    document.layout.panels = true;
    if (document.compare == CompareMode::only_a || document.compare == CompareMode::only_b)
      document.compare = CompareMode::side_by_side;
  });
}

/// The presenter has the whole screen, unless a size was asked for; what leaves it leaves that.
void App::Parts::follow_presenter() {
  const bool presents = session.document().mode == ScreenMode::presenter;
  if (presents != presented) redraw_after(0);  // with the faces that are loaded before the next frame
  want_projected_type(presents);
  if (std::exchange(presented, presents) == presents || shell.has_asked_size()) return;
  if (presents) filled_screen = !shell.fullscreen();
  if (filled_screen) shell.set_fullscreen(presents);
}

void App::Parts::update() {
  follow_presenter();
  const double now = ImGui::GetTime();
  const double passed = std::min(now - last_draw, 0.1);
  last_draw = now;
  close_on_escape();
  session.update();
  flying_now = fly_camera(session, my.pictures, passed);
  collect_pictures(session, my.pictures);
  my.selection.object.update(session);
  for (Panel& panel : my.all()) panel.update();
}

std::string App::Parts::status() const {
  for (const Panel& panel : my.all())
    if (std::string text = panel.status(); !text.empty()) return text;
  return {};
}

bool App::Parts::busy() const {
  return session.busy() || works(*my.pictures.difference.meter) ||
         std::any_of(my.all().begin(), my.all().end(), [](const Panel& panel) { return panel.busy(); });
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
  shell.remember(mode_key_of_state, std::string(enumerator_key(session.document().mode)));
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
  files.draw();
  for (Panel& panel : my.all())
    if (panel.facts.place == PanelPlace::over) panel.draw({});
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
  if (my.busy() || !my.status().empty()) my.shell.wake_after(progress_interval);
}

bool App::busy() const { return parts_->busy(); }
bool App::animating() const { return parts_->flying_now; }

void App::open(const std::string& path_or_name) { parts_->session.open(path_or_name); }

void App::drop(const std::string& path, std::optional<WindowPoint> at) {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  take_dropped_file(parts_->session, parts_->my.pictures, parts_->my.dropped, path,
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
  const auto& area = pictures.drawn.areas[index_of(side)];
  if (!area) return {};
  const ImVec2 at = pictures.drawn.transform.to_window({pixel.x + 0.5, pixel.y + 0.5}, *area);
  if (!area->contains(at)) return {};
  // Of a picture that A and B share, each shows its part; flicker lets them change places.
  const Side left = pictures.keys.flip ? Side::b : Side::a;
  if (pictures.drawn.split_at && (at.x < *pictures.drawn.split_at) != (side == left)) return {};
  return WindowPoint{at.x, at.y};
}

bool App::may_close() {
  parts_->keep_what_is_open();
  return true;
}

void App::ended_from_outside() {
  parts_->keep_what_is_open();
  parts_->autosave.end_from_outside();
}

void App::warn(const std::string& sentence) { parts_->session.say(Message::Kind::warning, sentence); }

}  // namespace ps::gui
