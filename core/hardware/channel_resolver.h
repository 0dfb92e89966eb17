#pragma once
#include "hardware/framebuffer.h"
#include "hardware/program.h"

namespace ps::hardware {

/// Gives each pixel the channels of its first sample, as the rasterizer does, where a target has several samples and
/// channels besides the colour. The first sample is the same on all drivers that keep to Direct3D's standard patterns.
/// Leaves other tests, masks and bindings behind than it has found. On the thread of OpenGL only.
class ChannelResolver {
 public:
  ChannelResolver();
  void resolve(const Framebuffer& target);

 private:
  Program program_;
};

}  // namespace ps::hardware
