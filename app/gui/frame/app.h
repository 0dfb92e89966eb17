#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gui/frame/file_dialog.h"
#include "gui/frame/screen_state.h"
#include "gui/frame/status_bar.h"
#include "gui/frame/story_mirror.h"
#include "gui/panels/lesson/first_look.h"
#include "gui/panels/lesson/lesson_panel.h"
#include "gui/panels/microscope/microscope_panel.h"
#include "gui/panels/options/history_panel.h"
#include "gui/panels/options/lights_panel.h"
#include "gui/panels/options/options_panel.h"
#include "gui/panels/pictures/dropped_picture.h"
#include "gui/panels/pictures/pictures_panel.h"
#include "gui/panels/pictures/pixels_panel.h"
#include "gui/panels/space/space_panel.h"
#include "gui/panels/story/listing_panel.h"
#include "gui/panels/story/pixel_panel.h"
#include "gui/panels/story/predict_panel.h"
#include "gui/panels/story/vertex_panel.h"
#include "gui/panels/studies/studies.h"
#include "gui/session/autosave.h"
#include "gui/session/session.h"
#include "gui/shell/content.h"
#include "gui/shell/shell.h"

namespace ps::gui {

struct PaletteEntry;

/// What the window shows first.
struct AppOptions {
  std::string scene;                    ///< path or built-in name; empty = the first-start scene
  std::string permalink;                ///< instead of a scene
  std::string lesson;                   ///< folder name of a lesson to begin
  std::vector<std::string> set, set_b;  ///< "key=value" for A and for B
  int width = 0, height = 0;            ///< picture size; 0 = the scene's own
  bool remember = true;                 ///< restore after a crash; off for scripts
};

/// The document that the options ask for. Throws InputError for a scene, lesson, option or permalink that is not
/// to be had.
Document first_document(const AppOptions& options);

/// Everything inside the window.
class App final : public Content {
 public:
  App(Shell& shell, const AppOptions& options, Document first);

  void draw() override;
  bool busy() const override;
  bool animating() const override { return flying_now_; }
  void open(const std::string& path_or_name) override { session_.open(path_or_name); }
  void drop(const std::string& path, std::optional<WindowPoint> at) override;
  void set_option(Side side, const std::string& assignment) override;
  std::optional<WindowPoint> pixel_place(Side side, Vec2i pixel) const override;
  bool may_close() override;
  void ended_from_outside() override;
  void warn(const std::string& sentence) override { session_.say(Message::Kind::warning, sentence); }

 private:
  // app_actions.cpp
  void add_actions();
  void add_view_actions();
  void add_pixel_actions();
  void add_story_actions();
  void add_camera_actions();
  void add_lesson_actions();
  // study_actions.cpp
  void add_study_actions();
  /// Opens a tab below the pictures, one of bottom_tabs.
  void show_tab(std::string_view tab);
  // palette_entries.cpp
  std::vector<PaletteEntry> palette_entries();
  void go_to_option(const Option& option);
  void nudge(Vec2i by);
  void turn(double right, double up);
  void orbit(double right, double up);
  void move_light(double right, double up, double forward);
  void next_channel(int by);
  void set_compare(CompareMode mode);
  void zoom_to(double zoom);
  // save_pictures.cpp
  void save_pictures(const std::filesystem::path& path);
  void save_scene_as(std::filesystem::path path);
  void save_chart(const std::filesystem::path& path);
  void save_permalink_as(std::filesystem::path path);
  // save_exports.cpp
  void save_story_as(std::filesystem::path path);
  void copy_command(const std::string& command);
  void save_drawing(std::filesystem::path path, const std::string& svg);
  // menus.cpp
  void menu_bar();
  void scene_menu();
  void lesson_menu();
  void view_menu();
  void study_menu();
  void about();
  float compare_buttons_width() const;
  void compare_buttons(float left);
  void file_dialog();
  // drop.cpp
  /// The object that is seen at a place of the window, else that of the picked pixel; -1 = none.
  int object_at(ImVec2 place);
  // restore.cpp
  std::optional<Document> restored(std::vector<Message>& words);
  // app.cpp
  void close_on_escape();
  void layout(const Area& area);
  void begin_region(const char* name, const Area& area, const char* heading = nullptr);
  void region_heading(const char* name, const char* heading);
  void toggle_bottom(bool open);
  Area first_look(const Area& area);
  void left_region(const Area& area);
  void right_region(const Area& area);
  void bottom_region(const Area& area);
  void bottom_tab(const std::string& tab);
  void publish();
  void remember_layout();
  /// The region that fills the window; empty = none.
  const std::string& filling() const { return session_.document().layout.filled; }
  void fill(const std::string& region);

  Shell& shell_;
  Session session_;
  PicturesState pictures_;
  OptionsPanelState options_panel_;
  PixelPanelState pixel_panel_;
  SpacePanelState space_;
  MicroscopePanelState microscope_;
  PixelsPanelState pixels_;
  ListingPanelState listing_;
  VertexPanelState vertex_;
  PredictState predict_;
  ScreenMirror mirror_;
  StoryMirror story_mirror_;
  HistoryPanelState history_;
  StatusBarState status_bar_;
  FileDialog files_;
  DroppedPicture dropped_;
  Studies studies_;
  LessonShelf lessons_;
  bool about_open_ = false;
  bool offers_first_look_ = false;
  float lesson_share_ = 0.6f;  ///< of the left region's height, while a lesson is open
  Autosave autosave_;
  bool flying_now_ = false;
  double last_draw_ = 0;
};

}  // namespace ps::gui
