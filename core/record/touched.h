#pragma once
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/counters.h"
#include "record/events.h"

namespace ps {

/// The objects and lights that the rays of a picture ended on, over all of its pixels.
struct Touched {
  struct Object {
    std::uint64_t pixels = 0;             ///< in whose story it is hit, or keeps a light away
    std::uint64_t seen = 0;               ///< of these, by the eye ray
    std::vector<std::uint8_t> triangles;  ///< of a mesh: 1 = a ray ended there
  };
  std::vector<Object> objects;        ///< in the scene's order
  std::vector<std::uint64_t> lights;  ///< pixels in whose story each light adds something

  /// Adds what was met in other pixels.
  void add(const Touched& other) {
    for (std::size_t i = 0; i < objects.size(); ++i) {
      Object& object = objects[i];
      object.pixels += other.objects[i].pixels;
      object.seen += other.objects[i].seen;
      for (std::size_t k = 0; k < object.triangles.size(); ++k)
        if (other.objects[i].triangles[k]) object.triangles[k] = 1;
    }
    for (std::size_t i = 0; i < lights.size(); ++i) lights[i] += other.lights[i];
  }
};

/// The fourth recorder (record/recorder.h): keeps no event, but notes in a Touched what the hits and lights of all
/// pixels name. Other events are never made.
class TouchRecorder {
 public:
  static constexpr bool counts = false;
  static constexpr bool records = false;
  static constexpr bool one_pixel = false;
  explicit TouchRecorder(Touched& touched)
      : touched_(touched), object_pixel_(touched.objects.size()), light_pixel_(touched.lights.size()) {}

  void at(int, int) { ++pixel_; }
  void count(Counter, std::uint64_t = 1) {}
  static constexpr bool wants(int, int) { return false; }
  static constexpr bool collects() { return false; }
  template <class Make>
  void event(Make&& make) {
    using Made = std::remove_cvref_t<std::invoke_result_t<Make>>;
    if constexpr (std::is_same_v<Made, HitEvent>) touch(make().id);
    if constexpr (std::is_same_v<Made, LightEvent>) light(make());
  }
  template <class Make>
  void begin(Make&& make) {
    using Made = std::remove_cvref_t<std::invoke_result_t<Make>>;
    if constexpr (std::is_same_v<Made, RayEvent>) by_eye_ = make().kind == RayKind::eye;
  }
  void end() {}
  template <class Make>
  void end(Make&&) {}

 private:
  void touch(const PixelId& id) {
    const auto index = static_cast<std::size_t>(id.object);
    Touched::Object& object = touched_.objects[index];
    std::uint64_t& pixel = object_pixel_[index];
    if (pixel != pixel_) ++object.pixels;
    if (pixel != pixel_ && by_eye_) ++object.seen;
    pixel = pixel_;
    const auto triangle = static_cast<std::size_t>(id.triangle);
    if (triangle < object.triangles.size()) object.triangles[triangle] = 1;
  }
  void light(const LightEvent& event) {
    if (event.blocker) touch(*event.blocker);
    const auto index = static_cast<std::size_t>(event.light);
    if ((event.diffuse <= 0 && event.specular <= 0 && event.ambient <= 0) || light_pixel_[index] == pixel_) return;
    light_pixel_[index] = pixel_;
    ++touched_.lights[index];
  }

  Touched& touched_;
  std::vector<std::uint64_t> object_pixel_, light_pixel_;  ///< the last one that was counted, by object and light
  std::uint64_t pixel_ = 0;
  bool by_eye_ = true;
};

}  // namespace ps
