#include "document/document.h"

#include <algorithm>

#include "frame/region.h"
#include "options/renderer_kind.h"
#include "options/scene_settings.h"
#include "scene/contents.h"

namespace ps {
namespace {

/// The scene as its file gave it: what is drawn, and from where.
bool same_file(const Scene& x, const Scene& y) {
  return x.name == y.name && x.camera == y.camera && x.canvas_width == y.canvas_width &&
         x.canvas_height == y.canvas_height && x.revision() == y.revision();
}

}  // namespace

bool operator==(const Document& x, const Document& y) {
  return x.scene_name == y.scene_name && same_file(x.base, y.base) && x.edits == y.edits && x.view == y.view &&
         x.a == y.a && x.b == y.b && x.field == y.field && x.picture_b == y.picture_b && x.pixel == y.pixel &&
         x.picked == y.picked && x.events == y.events && x.story == y.story && x.pin == y.pin &&
         x.compare == y.compare && x.split == y.split && x.heat_range == y.heat_range &&
         x.difference_gain == y.difference_gain && x.mode == y.mode && x.layout == y.layout && x.lesson == y.lesson &&
         x.step == y.step;
}

Document open_document(const std::string& scene_name, Scene scene) {
  Document document;
  document.scene_name = scene_name;
  document.a.settings = document.b.settings = settings_for(scene);
  const bool named = std::any_of(scene.settings.begin(), scene.settings.end(),
                                 [](const SceneSetting& setting) { return setting.key == "renderer"; });
  const bool flat = scene.geometry->objects.empty() && !scene.canvas_items->empty();
  if (!named) {
    document.a.settings.renderer = renderer_for(flat ? PictureWay::fragments : PictureWay::rays);
    document.b.settings.renderer = renderer_for(PictureWay::fragments);
  }
  document.pixel = scene.start_pixel;
  document.scene = scene;
  document.base = std::move(scene);
  return document;
}

void attach_scene(Document& document, Scene scene) {
  static_cast<void>(settings_for(scene));  // bad settings are refused before anything changes
  if (document.pin) pinned_scene(*document.pin, scene);
  document.scene = edited_scene(scene, document.edits);
  document.base = std::move(scene);
  fit_region(document);
}

void edit_scene(Document& document, const SceneEdit& edit) {
  std::vector<SceneEdit> edits = document.edits;
  const auto counts_anew = [](const SceneEdit& earlier) { return changes_contents(earlier.path); };
  const auto since = std::find_if(edits.rbegin(), edits.rend(), counts_anew).base();
  const auto same = [&](const SceneEdit& earlier) { return earlier.path == edit.path; };
  edits.erase(std::remove_if(since, edits.end(), same), edits.end());
  edits.push_back(edit);
  document.scene = edited_scene(document.base, edits);
  document.edits = std::move(edits);
}

void pin_pixel(Document& document) {
  if (document.pixel.x < 0) return;
  const PictureView& view = document.view;
  document.pin = Pin{document.pixel, document.a.settings, document.b.settings, document.edits,
                     view.camera,    view.width,          view.height};
}

void fit_region(Document& document) {
  auto& region = document.view.region;
  if (!region) return;
  const View view = view_of(document);
  region = common_part(*region, {0, 0, view.width, view.height});
  if (is_empty(*region)) region.reset();
}

View view_of(const Document& document) {
  const PictureView& view = document.view;
  return view_of(document.scene, view.camera, view.width, view.height);
}

int event_of(const Document& document, Side side) { return document.events[side == Side::a ? 0 : 1]; }
int& event_of(Document& document, Side side) { return document.events[side == Side::a ? 0 : 1]; }

const SideState& side_of(const Document& document, Side side) { return side == Side::a ? document.a : document.b; }

SideState& side_of(Document& document, Side side) { return side == Side::a ? document.a : document.b; }

}  // namespace ps
