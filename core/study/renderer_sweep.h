#pragma once
#include <span>
#include <string>
#include <vector>

#include "study/sweep.h"

namespace ps {

/// The key of the named sweep whose points are the renderers.
inline constexpr std::string_view renderer_sweep = "renderers";

/// "renderer=ray-tracer,rasterizer,hardware": all renderers of this program that make pictures of any scene, whether or
/// not this machine can run them. Listings draw only what their chapter covers.
std::string renderer_sweep_axis();

/// The axes without renderers that cannot draw on this machine.
std::vector<SweepAxis> without_absent_renderers(std::vector<SweepAxis> axes);

/// Which renderers a sweep of the renderers lacks on this machine or in this program, each with its reason: "hardware
/// (OpenGL): no OpenGL: the library libEGL is not installed". Nothing for other sweeps.
std::vector<std::string> absent_renderers(std::span<const SweepAxis> axes);

}  // namespace ps
