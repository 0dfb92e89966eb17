#include "gui/frame/panels.h"

#include <algorithm>

#include "base/check.h"
#include "engine/screen_names.h"
#include "gui/panels/kept/kept_panel.h"
#include "gui/panels/lesson/glossary_sheet.h"
#include "gui/panels/lesson/notes_sheet.h"
#include "gui/panels/microscope/microscope_panel.h"
#include "gui/panels/pictures/pixels_panel.h"
#include "gui/panels/scenes/notation_sheet.h"
#include "gui/panels/scenes/scene_gallery.h"
#include "gui/panels/space/space_panel.h"
#include "gui/panels/story/listing_panel.h"
#include "gui/panels/studies/chart_tab.h"
#include "gui/panels/studies/needs_tab.h"
#include "gui/panels/studies/stability_tab.h"
#include "gui/panels/studies/timings_tab.h"
#include "gui/panels/studies/unsafe_line.h"
#include "gui/panels/studies/why_tab.h"

namespace ps::gui {

/// The tools have the order of their tabs, first those about the picked pixel.
Panels::Panels(const PanelHost& host)
    : pictures(host.wake, selection), lessons(host), options(host, selection), history(host),
      pixel(host, lessons.state.questions), vertex(host), picker(host, lessons.state.read), about(host), dropped(host),
      host_(host), folder_(host.remember), all_{pixel, lessons, options, history} {
  add<SpacePanel>(pictures, vertex);
  add<MicroscopePanel>();
  add<PixelsPanel>(pictures);
  add<ListingPanel>(lessons.state.shelf, lessons.state.questions);
  all_.emplace_back(vertex);
  add<ChartTab>(folder_);
  add<NeedsTab>(folder_);
  add<WhyTab>();
  add<TimingsTab>();
  add<StabilityTab>(folder_);
  add<UnsafeLines>(pictures);
  all_.emplace_back(about);
  add<SceneGallery>();
  all_.emplace_back(picker);
  add<KeptPanel>();
  add<GlossarySheet>();
  add<NotationSheet>();
  add<NotesSheet>(lessons.state.shelf);
  all_.emplace_back(dropped);
  PS_ASSERT(std::all_of(tool_names::all.begin(), tool_names::all.end(),
                        [&](std::string_view name) { return find(name).facts.name == name; }),
            "a panel for each name that a lesson may have");
}

}  // namespace ps::gui
