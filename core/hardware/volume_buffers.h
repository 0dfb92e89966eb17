#pragma once
#include <vector>

#include "hardware/shadow_volumes.h"

namespace ps::hardware {

/// Vertices of shadow volumes in the memory of the graphics driver.
class VolumeBuffers {
 public:
  explicit VolumeBuffers(const VolumeFaces& faces);
  ~VolumeBuffers();
  VolumeBuffers(VolumeBuffers&& other) noexcept;
  VolumeBuffers(const VolumeBuffers&) = delete;
  VolumeBuffers& operator=(const VolumeBuffers&) = delete;

  std::size_t object() const { return object_; }
  /// Number of vertices of faces that face outwards; those of the others follow.
  int outwards() const { return outwards_; }
  int inwards() const { return inwards_; }
  /// Of the triangles in the volume's surface, in the order in which they are drawn.
  const std::vector<std::uint32_t>& numbers() const { return numbers_; }
  /// Makes them the input of volume_vertex.glsl.
  void bind() const;

 private:
  std::size_t object_ = 0;
  int outwards_ = 0, inwards_ = 0;
  std::vector<std::uint32_t> numbers_;
  unsigned places_ = 0, snapped_ = 0;
};

}  // namespace ps::hardware
