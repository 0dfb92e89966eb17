#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/counters.h"
#include "base/parallel.h"
#include "frame/machinery.h"
#include "frame/precision_fault.h"
#include "image/image.h"
#include "math/vec.h"

namespace ps {

struct ShownField;  // record/field_query.h

/// Pictures that a renderer can make besides colour. Combined with |.
enum class Channel : std::uint32_t {
  none = 0,
  depth = 1u << 0,        ///< camera-space z of the visible point; +infinity for the background
  normal = 1u << 1,       ///< shading normal, world space, unit length; (0,0,0) for the background
  barycentric = 1u << 2,  ///< perspective-correct weights of the triangle's vertices; (0,0,0) on spheres and background
  uv = 1u << 3,
  ids = 1u << 4,           ///< object and triangle; -1 for the background
  facing = 1u << 5,        ///< cosine between the geometric normal and the direction to the eye; negative = back
  overdraw = 1u << 6,      ///< fragments that covered the pixel
  tests = 1u << 7,         ///< primitives (rays) or coverage samples (fragments) tested for the pixel
  mip = 1u << 8,           ///< texture level of detail used; -1 where no texture was read
  shadow = 1u << 9,        ///< bit i set: light i is blocked at the visible point
  samples = 1u << 10,      ///< colours that were averaged for the pixel
  direction = 1u << 11,    ///< of the ray through the pixel's sample position, world space, unit length (CGPP 15.4.1)
  shadow_map = 1u << 12,   ///< the lights' shadow maps themselves, laid out over the picture's area
  stencil = 1u << 13,      ///< counts in the stencil buffers, added up over the lights
  environment = 1u << 14,  ///< the cube map of the first mirror, laid out over the picture's area
  precision = 1u << 15,    ///< what comes out otherwise in double; needs ids
  field = 1u << 17,        ///< the number of the pixel's story that RenderRequest::field asks for
  depth_gap = 1u << 16,    ///< between the first and the second surface, in units of the stored depth
};
constexpr Channel operator|(Channel a, Channel b) {
  return static_cast<Channel>(static_cast<std::uint32_t>(a) | static_cast<std::uint32_t>(b));
}
constexpr Channel without(Channel set, Channel one) {
  return static_cast<Channel>(static_cast<std::uint32_t>(set) & ~static_cast<std::uint32_t>(one));
}
inline bool has(Channel set, Channel one) {
  return (static_cast<std::uint32_t>(set) & static_cast<std::uint32_t>(one)) != 0;
}

/// Which object and which of its triangles (0 for spheres) a pixel shows; -1 = none.
struct PixelId {
  std::int32_t object = -1;
  std::int32_t triangle = -1;
  bool operator==(const PixelId&) const = default;
};

struct StageTime {
  std::string stage;
  double milliseconds = 0;
};

/// How long a graphics driver took for a picture, each until it said that it had finished (glFinish).
struct DriverTimes {
  double upload_ms = 0;  ///< what it did not have yet of meshes, textures and shaders, and the lights
  double draw_ms = 0;    ///< all draw calls
};

/// A finished picture and how it came about. Only `colour` is always there; other channels have size 0 unless asked
/// for.
struct Frame {
  Image<Vec3f> colour;         ///< linear, unclamped
  Image<Vec3d> colour_double;  ///< the same before rounding to float; only with precision = double
  Image<float> depth;
  Image<Vec3f> normal;
  Image<Vec3f> barycentric;
  Image<Vec2f> uv;
  Image<PixelId> ids;
  Image<float> facing;
  Image<std::uint32_t> overdraw;
  Image<std::uint32_t> tests;
  Image<float> mip;
  Image<std::uint32_t> shadow;
  Image<std::uint32_t> samples;
  Image<Vec3f> direction;
  Image<float> shadow_map;  ///< depth that a texel stores; +infinity = no surface, -1 = no map here
  Image<std::int32_t> stencil;
  Image<Vec3f> environment;  ///< linear; negative = no map here
  Image<PrecisionFault> precision;
  Image<float> depth_gap;                         ///< see render/precision_channels.h
  Image<float> field;                             ///< NaN where the story has no such number
  std::shared_ptr<const ShownField> shown_field;  ///< what `field` holds
  Counters counters;
  std::vector<StageTime> times;
  std::optional<DriverTimes> driver;  ///< only where a graphics driver drew it
  FastPath path;                      ///< what drew it, as the kernels report it

  int width() const { return colour.width(); }
  int height() const { return colour.height(); }
};

/// The data of the scene that a graphics driver has when it begins with a picture.
enum class DriverMemory {
  kept,     ///< meshes and textures of earlier pictures
  emptied,  ///< none of them: the picture uploads all that it needs
};

/// The content of a picture outside the region that was asked for.
enum class Outside {
  black,     ///< black, and channels as for the background
  anything,  ///< whatever is there: it is never read, and clearing it may take longer than a small region
};

/// The results that a caller wants besides the picture itself.
struct RenderRequest {
  Channel channels = Channel::none;
  std::shared_ptr<const ShownField> field{};  ///< of Channel::field
  WorkerPriority priority = WorkerPriority::normal;
  /// Only these pixels are wanted (CGPP 15.4.4); they come out as in the whole picture.
  std::optional<TileRect> region{};
  Outside outside = Outside::black;
  /// Gets the display levels of display_frame() while the colours are still at hand, or nullptr. Of the view's size; a
  /// rectangle is filled before on_tile is called for it, which then had better read them than the colours. Pixels
  /// outside `region` may hold anything.
  Image<Rgb8>* levels = nullptr;
  /// Called on a worker thread after each finished rectangle of the frame that is being made; only that rectangle may
  /// be read. May be empty.
  std::function<void(const Frame&, const TileRect&)> on_tile;
  DriverMemory driver_memory = DriverMemory::kept;
};

}  // namespace ps
