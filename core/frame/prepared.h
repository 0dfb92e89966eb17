#pragma once
#include <cstdint>
#include <cstring>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "base/memory_size.h"
#include "scene/scene.h"

namespace ps {

/// Exactly what a product was made from: scene revisions and setting values, in a fixed order.
class Key {
 public:
  explicit Key(std::string_view product) : product_(product) {}
  Key& add(std::uint64_t value) {
    parts_.push_back(value);
    return *this;
  }
  Key& add(double value) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    return add(bits);
  }
  template <class Enum>
  requires std::is_enum_v<Enum> Key& add(Enum value) { return add(static_cast<std::uint64_t>(value)); }
  /// For a product that reads all of a scene; others add the revisions of the parts that they read.
  Key& add(const SceneRevision& scene) {
    return add(scene.geometry)
        .add(scene.lights)
        .add(scene.materials)
        .add(scene.textures)
        .add(scene.canvas_items)
        .add(scene.background.x)
        .add(scene.background.y)
        .add(scene.background.z);
  }
  const std::string& product() const { return product_; }
  bool operator==(const Key&) const = default;

 private:
  std::string product_;
  std::vector<std::uint64_t> parts_;
};

/// Products that renderers derive from a scene before drawing it: accelerators, mip chains, tessellations. Built when
/// first asked for, kept while their Key stays the same; of each product the last few keys are kept. Safe to use from
/// several threads; two threads that ask for the same missing product may both build it.
class Prepared {
 public:
  /// The product for `key`, made by `build()` (which returns a T) if it is not there yet.
  template <class T, class Build>
  std::shared_ptr<const T> get(const Key& key, Build&& build) {
    if (auto found = find(key)) return std::static_pointer_cast<const T>(found);
    auto made = std::make_shared<const T>(build());
    keep({key, made, [](const void* value) { return memory_size(*static_cast<const T*>(value)); }});
    return made;
  }
  void clear();
  /// Memory of all products that are kept now.
  std::size_t bytes() const;

 private:
  struct Entry {
    Key key;
    std::shared_ptr<const void> value;
    std::size_t (*size_of)(const void*) = nullptr;  ///< bytes, asked each time: some products grow when they are used
    std::size_t bytes() const { return size_of(value.get()); }
  };
  std::shared_ptr<const void> find(const Key& key);
  void keep(Entry made);

  mutable std::mutex mutex_;
  std::list<Entry> entries_;  // most recently used first
};

}  // namespace ps
