#include "document/document.h"
#include "scene/edit.h"

namespace ps {
namespace {

Scene with_edits(const Scene& base, const std::vector<SceneEdit>& edits) {
  Scene scene = base;
  for (const SceneEdit& edit : edits) set_property(scene, edit.path, edit.value);
  return scene;
}

}  // namespace

void attach_scene(Document& document, Scene scene) {
  document.scene = with_edits(scene, document.edits);
  document.base = std::move(scene);
}

void edit_scene(Document& document, const SceneEdit& edit) {
  std::vector<SceneEdit> edits = document.edits;
  std::erase_if(edits, [&](const SceneEdit& earlier) { return earlier.path == edit.path; });
  edits.push_back(edit);
  document.scene = with_edits(document.base, edits);
  document.edits = std::move(edits);
}

}  // namespace ps
