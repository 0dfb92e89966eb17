#pragma once
#include <functional>

#include "gui/frame/drawer.h"
#include "gui/panels/kept/kept_panel.h"
#include "gui/panels/lesson/lesson_panel.h"
#include "gui/panels/lesson/lesson_picker.h"
#include "gui/panels/microscope/microscope_panel.h"
#include "gui/panels/options/history_panel.h"
#include "gui/panels/options/options_panel.h"
#include "gui/panels/pictures/pictures_panel.h"
#include "gui/panels/pictures/pixels_panel.h"
#include "gui/panels/scenes/scene_gallery.h"
#include "gui/panels/space/space_panel.h"
#include "gui/panels/story/listing_panel.h"
#include "gui/panels/story/pixel_panel.h"
#include "gui/panels/story/predict_panel.h"
#include "gui/panels/story/vertex_panel.h"
#include "gui/panels/studies/chart_tab.h"
#include "gui/panels/studies/needs_tab.h"
#include "gui/panels/studies/stability_tab.h"
#include "gui/panels/studies/study_folder.h"
#include "gui/panels/studies/timings_tab.h"
#include "gui/panels/studies/unsafe_line.h"
#include "gui/panels/studies/why_tab.h"

namespace ps::gui {

/// State of the panels beside the document.
struct PanelStates {
  /// `wake` may be called from any thread; `remember`: results of studies are kept from one start to the next.
  PanelStates(const std::function<void()>& wake, bool remember);

  PicturesState pictures;
  SceneGallery scenes;
  KeptState kept;
  LessonShelf lessons;
  LessonPicker picker;
  OptionsPanelState options;
  HistoryPanelState history;
  PredictState predict;
  PixelPanelState pixel;
  SpacePanelState space;
  MicroscopePanelState microscope;
  PixelsPanelState pixels;
  ListingPanelState listing;
  VertexPanelState vertex;
  StudyFolder folder;
  ChartTab chart;
  StabilityTab stability;
  NeedsTab needs;
  WhyTab why;
  TimingsTab timings;
  UnsafeState unsafe;
  DrawerState drawer;
};

}  // namespace ps::gui
