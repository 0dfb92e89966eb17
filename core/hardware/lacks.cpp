#include "hardware/lacks.h"

#include <algorithm>
#include <array>

#include "hardware/gl_thread.h"
#include "hardware/picture_plan.h"

namespace ps::hardware {
namespace {

template <class Enum, Enum... Values>
bool is_one_of(OptionNumber value) {
  return ((value == static_cast<double>(Values)) || ...);
}
bool is_on(OptionNumber value) { return value != 0; }

constexpr std::string_view own_coverage = "the driver has its own coverage test";
constexpr std::string_view no_g_buffer = "the hardware renderer has no G-buffer";
constexpr std::string_view no_volumes = "the hardware renderer has no shadow volumes";
constexpr std::string_view no_environment = "the hardware renderer has no environment maps";

constexpr std::string_view no_samples = "the driver does not offer this number of samples per pixel";

/// Which numbers of samples there are, the driver knows.
bool lacks_samples(OptionNumber value) {
  Settings settings;
  settings.multisampling = static_cast<int>(value);
  const int samples = sample_count(settings);
  if (samples == 1 || !availability().driver) return false;
  const std::vector<int>& offered = availability().driver->samples;
  return std::find(offered.begin(), offered.end(), samples) == offered.end();
}

constexpr std::array all{
    Lack{"depth-value", "the hardware renderer has no plane equations: depth is interpolated",
         is_one_of<DepthValue, DepthValue::ray_plane>},
    Lack{"deferred-shading", no_g_buffer, is_on},
    Lack{"clipping", "a driver always clips at the near plane and the sides",
         is_one_of<Clipping, Clipping::near_only, Clipping::none>},
    Lack{"canvas-fill", "the hardware renderer draws nothing on the canvas"},
    Lack{"line-algorithm", "the driver has its own line algorithm"},
    Lack{"coverage", own_coverage},
    Lack{"edge-arithmetic", own_coverage},
    Lack{"multisampling", no_samples, lacks_samples},
    Lack{"subpixel-bits", "the driver has a fixed number of sub-pixel bits"},
    Lack{"fill-rule", "the driver has the top-left rule"},
    Lack{"shadows", no_volumes, is_one_of<Shadows, Shadows::stencil_depth_fail, Shadows::stencil_depth_pass>},
    Lack{"stencil-bits", no_volumes},
    Lack{"volume-caps", no_volumes},
    Lack{"volume-length", no_volumes},
    Lack{"volume-depth-clamp", no_volumes},
    Lack{"environment", no_environment, is_one_of<Environment, Environment::cube_map, Environment::room_map>},
    Lack{"environment-objects", no_environment},
    Lack{"environment-size", no_environment},
    Lack{"precision", "drivers compute in float", is_one_of<Precision, Precision::float64>},
    Lack{"threads", "the driver chooses its own threads"},
    Lack{"simd", "the driver chooses its own instructions"},
};

const Lack* find(std::string_view key) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const Lack& lack) { return lack.option == key; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace

std::span<const Lack> lacks() { return all; }

std::optional<std::string_view> lacks_option(const Option& option, const Settings&) {
  const Lack* lack = find(option.key);
  if (!lack || lack->values) return {};
  return lack->reason;
}

std::optional<std::string_view> lacks_value(const Option& option, double value, const Settings& settings) {
  // Gouraud and flat shading would need each light by itself at each vertex.
  if (option.key == "shadows" && value == static_cast<double>(Shadows::map) && settings.lighting &&
      settings.shading != Shading::phong)
    return "shadow maps of the hardware renderer need shading = phong";
  const Lack* lack = find(option.key);
  if (!lack || !lack->values || !lack->values(value)) return {};
  return lack->reason;
}

}  // namespace ps::hardware
