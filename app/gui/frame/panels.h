#pragma once
#include <functional>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "gui/frame/about.h"
#include "gui/frame/drawer.h"
#include "gui/panels/lesson/lesson_panel.h"
#include "gui/panels/lesson/lesson_picker.h"
#include "gui/panels/options/history_panel.h"
#include "gui/panels/options/options_panel.h"
#include "gui/panels/pictures/dropped_picture.h"
#include "gui/panels/pictures/pictures_panel.h"
#include "gui/panels/story/pixel_panel.h"
#include "gui/panels/story/vertex_panel.h"
#include "gui/panels/studies/study_folder.h"

namespace ps::gui {

/// All panels of the window. Those that have a place of their own are members; the tools below the pictures, and the
/// sheets over the window, are known to the window as panels alone.
class Panels {
 public:
  /// `host` must outlive it.
  explicit Panels(const PanelHost& host);

  const PanelList& all() const { return all_; }
  /// The panel of that name; the first tool where there is none, as in a document of another version.
  Panel& find(std::string_view name) const { return find_panel(all_, name); }

  ObjectSelection selection;
  PicturesState pictures;
  LessonPanel lessons;
  OptionsPanel options;
  HistoryPanel history;
  PixelPanel pixel;
  VertexPanel vertex;
  LessonPicker picker;
  About about;
  DroppedPicture dropped;
  DrawerState drawer;

 private:
  template <class Type, class... More>
  Type& add(More&&... more) {
    auto panel = std::make_unique<Type>(host_, std::forward<More>(more)...);
    Type& added = *panel;
    all_.emplace_back(added);
    own_.push_back(std::move(panel));
    return added;
  }

  const PanelHost& host_;
  StudyFolder folder_;
  std::vector<std::unique_ptr<Panel>> own_;
  PanelList all_;
};

}  // namespace ps::gui
