#include "support/bare_scene.h"

namespace ps::test {

Scene bare_scene(Scene scene, Bare what) {
  switch (what) {
  case Bare::without_casters:
    scene.materials.edit([](std::vector<Material>& materials) {
      for (Material& material : materials) material.transparency = 1;
    });
    break;
  case Bare::without_lights:
    scene.lights = {};
    break;
  case Bare::without_objects:
    scene.geometry.edit([](Geometry& geometry) { geometry.objects.clear(); });
    break;
  }
  return scene;
}

}  // namespace ps::test
