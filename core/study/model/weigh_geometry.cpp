#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "base/number_text.h"
#include "scene/generate/bezier_patch.h"
#include "study/model/model_search.h"
#include "study/model/simple_shape.h"

namespace ps::model {
namespace {

Marks marks_of(const Candidates& chosen, std::size_t count) {
  Marks marks(count, 0);
  for (const std::size_t index : chosen) marks[index] = 1;
  return marks;
}

std::size_t triangles_in(const Scene& scene) {
  std::size_t count = 0;
  for (const auto& mesh : scene.geometry->meshes) count += mesh->triangles.size();
  return count;
}

Scene with_shapes(const Scene& scene, const Candidates& objects, const std::vector<std::optional<Solid>>& shapes) {
  Scene simpler = scene;
  simpler.geometry.edit([&](Geometry& geometry) {
    for (const std::size_t object : objects) geometry.objects[object].shape = *shapes[object];
  });
  return without_objects(simpler, Marks(simpler.geometry->objects.size(), 0));
}

/// Marks for each mesh the triangles that no instance of it shows.
std::vector<Marks> unseen_triangles(const Scene& scene, const Touched& touched) {
  std::vector<Marks> unseen;
  for (const auto& mesh : scene.geometry->meshes) unseen.emplace_back(mesh->triangles.size(), 1);
  for (std::size_t i = 0; i < scene.geometry->objects.size(); ++i)
    if (const auto* instance = std::get_if<Instance>(&scene.geometry->objects[i].shape))
      for (std::size_t k = 0; k < touched.objects[i].triangles.size(); ++k)
        if (touched.objects[i].triangles[k]) unseen[instance->mesh][k] = 0;
  return unseen;
}

}  // namespace

void ModelSearch::weigh_objects() {
  Candidates unseen;
  for (std::size_t i = 0; i < scene().geometry->objects.size(); ++i)
    if (evidence_.touched.objects[i].pixels == 0) unseen.push_back(i);
  const std::size_t all = scene().geometry->objects.size();
  const Scene full = scene();
  const Candidates gone = hold_together(
      unseen, Worth::unseen, [&](const Candidates& some) { return without_objects(full, marks_of(some, all)); });
  if (gone.empty()) return;
  ModelSaving saving{.part = ModelPart::objects, .goes = part_of_all(gone.size(), all, "object", "objects")};
  for (const std::size_t object : gone) {
    const std::uint64_t bytes = model_bytes(full) - model_bytes(without_objects(full, marks_of({object}, all)));
    saving.things.push_back({.name = object_name(full, object), .picture = 0, .bytes = bytes});
  }
  take(std::move(saving));
  forget(full, gone);
}

void ModelSearch::forget(const Scene& before, const Candidates& gone) {
  const Marks marks = marks_of(gone, before.geometry->objects.size());
  std::vector<Touched::Object> left;
  for (std::size_t i = 0; i < marks.size(); ++i)
    if (!marks[i]) left.push_back(std::move(evidence_.touched.objects[i]));
  evidence_.touched.objects = std::move(left);
  // Textures that only they had are gone with them.
  std::vector<std::optional<float>> levels;
  for (std::size_t i = 0; i < before.textures->size(); ++i)
    if (std::any_of(scene().textures->begin(), scene().textures->end(),
                    [&](const Texture& texture) { return texture.texels == (*before.textures)[i].texels; }))
      levels.push_back(evidence_.finest_level[i]);
  levels.resize(scene().textures->size());
  evidence_.finest_level = std::move(levels);
}

void ModelSearch::weigh_shapes() {
  std::vector<std::optional<Solid>> shapes;
  Candidates simple;
  for (const Object& object : scene().geometry->objects) {
    shapes.push_back(simple_shape(scene(), object));
    if (shapes.back()) simple.push_back(shapes.size() - 1);
  }
  const Scene before = scene();
  const Candidates changed = hold_together(simple, Worth::unchanged,
                                           [&](const Candidates& some) { return with_shapes(before, some, shapes); });
  if (changed.empty()) return;
  ModelSaving saving{
      .part = ModelPart::shapes,
      .goes = fmt::format("the triangles of {}", part_of_all(changed.size(), shapes.size(), "object", "objects"))};
  bool boxes = false, rectangles = false;
  for (const std::size_t object : changed) {
    const auto& instance = std::get<Instance>(before.geometry->objects[object].shape);
    (std::holds_alternative<Brick>(shapes[object]->form) ? boxes : rectangles) = true;
    saving.things.push_back(
        {.name = fmt::format("{}: a {} does", object_name(before, object), form_name(shapes[object]->form)),
         .picture = static_cast<double>(evidence_.touched.objects[object].pixels) / evidence_.pixels,
         .bytes = mesh_bytes(*before.geometry->meshes[instance.mesh])});
    evidence_.touched.objects[object].triangles.clear();
  }
  const bool one = changed.size() == 1;
  saving.kept = one                   ? (boxes ? "a box does" : "a rectangle does")
                : boxes && rectangles ? "boxes and rectangles do"
                : boxes               ? "boxes do"
                                      : "rectangles do";
  take(std::move(saving));
}

void ModelSearch::weigh_triangles() {
  const std::vector<Marks> unseen = unseen_triangles(scene(), evidence_.touched);
  Candidates meshes;
  for (std::size_t i = 0; i < unseen.size(); ++i) {
    const auto gone = static_cast<double>(count_marks(unseen[i])), all = static_cast<double>(unseen[i].size());
    const bool enough = gone >= least_saving * all && gone < all;
    if (enough && scene().geometry->meshes[i]->patches.empty()) meshes.push_back(i);
  }
  const Scene before = scene();
  const Candidates changed = hold_together(meshes, Worth::unchanged, [&](const Candidates& some) {
    Scene less = before;
    for (const std::size_t mesh : some)
      less = with_mesh(less, mesh, without_triangles(*before.geometry->meshes[mesh], unseen[mesh]));
    return less;
  });
  if (changed.empty()) return;
  const std::size_t all = triangles_in(before), left = triangles_in(last_.scene);
  ModelSaving saving{.part = ModelPart::triangles,
                     .goes = fmt::format("{} of {} triangles", with_thousands(std::to_string(all - left)),
                                         with_thousands(std::to_string(all)))};
  for (const std::size_t mesh : changed) {
    const Mesh& whole = *before.geometry->meshes[mesh];
    saving.things.push_back({.name = fmt::format("model '{}': {} of {} triangles", whole.name,
                                                 with_thousands(std::to_string(count_marks(unseen[mesh]))),
                                                 with_thousands(std::to_string(whole.triangles.size()))),
                             .picture = 0,
                             .bytes = mesh_bytes(whole) - mesh_bytes(*last_.scene.geometry->meshes[mesh])});
  }
  take(std::move(saving));
}

void ModelSearch::weigh_detail() {
  for (std::size_t i = 0; i < scene().geometry->meshes.size(); ++i) {
    const std::shared_ptr<const Mesh> whole = scene().geometry->meshes[i];
    if (whole->patches.empty()) continue;
    int divisions = 1, enough = 0;
    while (tessellate(whole->patches, divisions).triangles.size() < whole->triangles.size()) ++divisions;
    for (int coarser = divisions / 2; coarser >= 1; coarser /= 2) {
      Mesh less = tessellate(whole->patches, coarser);
      less.name = whole->name;
      less.materials = whole->materials;
      if (!holds(with_mesh(scene(), i, std::move(less)), settings(), Worth::lossy)) break;
      enough = coarser;
    }
    if (enough == 0) continue;
    ModelSaving saving{
        .part = ModelPart::detail,
        .goes = fmt::format("{} of {} divisions of the curved model '{}'", divisions - enough, divisions, whole->name)};
    saving.things.push_back({.name = whole->name, .bytes = model_bytes(scene()) - model_bytes(last_.scene)});
    take(std::move(saving));
  }
}

}  // namespace ps::model
