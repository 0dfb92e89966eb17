#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "hardware/framebuffer.h"
#include "hardware/program.h"

namespace ps::hardware {

/// Reads what depth and stencil buffer hold for each sample of a pixel, where a pixel has several: OpenGL copies only
/// pixels. A shader reads depths, bit for bit, and the stencil test finds the stencil, bit after bit. Leaves other
/// tests, masks and bindings behind than it has found, but the same program and the same scissor. On the thread of
/// OpenGL only.
class SampleReader {
 public:
  SampleReader();
  ~SampleReader();
  SampleReader(const SampleReader&) = delete;
  SampleReader& operator=(const SampleReader&) = delete;

  /// In the depth buffer, from 0 to 1, by sample. nullopt where the driver has no textures for it.
  std::optional<std::vector<float>> depths(const Framebuffer& target, Vec2i pixel);
  /// In the stencil buffer of a target that has one, by sample.
  std::vector<int> stencils(const Framebuffer& target, Vec2i pixel);

 private:
  Program program_;
  unsigned framebuffer_ = 0, picture_ = 0, query_ = 0;
};

}  // namespace ps::hardware
