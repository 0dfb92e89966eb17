#pragma once
#include "options/settings.h"

namespace ps::bench {

/// GLSL for GlScene. The vertex shader passes world positions, normals and texture coordinates on.
const char* vertex_source();
/// Lit by the book's equation, textured, or of one colour.
const char* fragment_source(const Settings& settings, bool textured);

}  // namespace ps::bench
