#pragma once
#include <string>

namespace ps::hardware {

/// assets/gallery/hardware-options.md: each choice of each option that renderers of fragments use, and whether this one
/// honours it, by a depth that the fragment shader writes (gl_FragDepth), by an extension, or not, with the reason. The
/// same on every machine: what depends on the driver is named so.
std::string option_page();

}  // namespace ps::hardware
