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

constexpr std::string_view own_coverage = "the driver has its own coverage test";
constexpr std::string_view no_samples = "the driver does not offer this number of samples per pixel";

/// Which numbers of samples there are, the driver knows. It is not started for that.
bool lacks_samples(OptionNumber value) {
  Settings settings;
  settings.multisampling = static_cast<int>(value);
  const int samples = sample_count(settings);
  if (samples == 1 || !driver_is_known() || !availability().driver) return false;
  const std::vector<int>& offered = availability().driver->samples;
  return std::find(offered.begin(), offered.end(), samples) == offered.end();
}

constexpr std::array all_lacks{
    Lack{"depth-value", "the hardware renderer has no plane equations: depth is interpolated",
         is_one_of<DepthValue, DepthValue::ray_plane>},
    Lack{"clipping", "a driver draws nothing that lies behind the eye", is_one_of<Clipping, Clipping::none>},
    Lack{"canvas-fill", "the driver fills shapes by its own coverage test", is_one_of<CanvasFill, CanvasFill::rows>},
    Lack{"line-algorithm", "the driver has its own line algorithm"},
    Lack{"coverage", own_coverage},
    Lack{"edge-arithmetic", own_coverage},
    Lack{"multisampling", no_samples, lacks_samples},
    Lack{"subpixel-bits", "the driver has a fixed number of sub-pixel bits"},
    Lack{"fill-rule", "the driver has the top-left rule"},
    Lack{"stencil-bits", "drivers keep 8 stencil bits of a pixel", [](OptionNumber bits) { return bits > 8; }},
    Lack{"precision", "drivers compute in float", is_one_of<Precision, Precision::float64>},
    Lack{"threads", "the driver chooses its own threads"},
    Lack{"simd", "the driver chooses its own instructions"},
};

const Lack* find(std::string_view key) {
  const auto found =
      std::find_if(all_lacks.begin(), all_lacks.end(), [&](const Lack& lack) { return lack.option == key; });
  return found == all_lacks.end() ? nullptr : &*found;
}

}  // namespace

std::span<const Lack> lacks() { return all_lacks; }

std::optional<IdleReason> lacks_option(const Option& option, const Settings&) {
  const Lack* lack = find(option.key);
  if (!lack || lack->values) return {};
  return IdleReason(IdleReason::Kind::renderer, lack->reason);
}

std::optional<IdleReason> lacks_value(const Option& option, double value, const Settings& settings) {
  const bool at_vertices = settings.lighting && settings.shading != Shading::phong;
  const auto is = [&](std::string_view key, auto choice) {
    return option.key == key && value == static_cast<double>(choice);
  };
  // Light computed at vertices is drawn light by light, each where its shadow map lets it through.
  if (is("shadows", Shadows::map) && at_vertices && settings.visibility != Visibility::depth_buffer)
    return IdleReason({{"shading", static_cast<double>(Shading::phong)},
                       {"visibility", static_cast<double>(Visibility::depth_buffer)}})
        .said("shadow maps of the hardware renderer need shading = phong or visibility = depth-buffer");
  const bool by_light = settings.shadows != Shadows::none && settings.shadows != Shadows::traced;
  if (is("deferred-shading", true) && at_vertices && by_light)
    return needs("shading", Shading::phong)
        .said("a buffer that holds the light of vertices holds the sum of all lights, and shadows need each by itself");
  const Lack* lack = find(option.key);
  if (!lack || !lack->values || !lack->values(value)) return {};
  return IdleReason(IdleReason::Kind::renderer, lack->reason);
}

}  // namespace ps::hardware
