#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "frame/fast_kernels.h"
#include "frame/viewport.h"
#include "raytrace/base/accelerators.h"
#include "raytrace/base/geometry.h"
#include "shade/normal_mapping.h"
#include "shade/shading_inputs.h"

namespace ps {
namespace raster {
struct ShadowMap;  // raster/shadow/shadow_map.h
}

/// A body in which eye rays may begin (raytrace/base/eye_bodies.h).
struct EyeBody {
  std::int32_t object = -1;                ///< index into Geometry::objects
  std::optional<std::uint32_t> primitive;  ///< of a sphere or solid; absent: an instance of a mesh
};

/// All that the kernel reads, in its precision, made once for each picture.
template <class Real>
struct TraceInputs {
  std::shared_ptr<const TracedGeometry<Real>> geometry;
  TracedAccelerator<Real> accelerator;
  std::vector<ShadingMaterial<Real>> materials;
  std::vector<ShadingLight<Real>> lights;
  std::vector<std::shared_ptr<const Image<Vec3f>>> textures;
  std::vector<TextureWrap> wraps;       ///< of each texture
  std::vector<Placing<Real>> placings;  ///< of each object, where mapped normals go by the inverse transpose
  bool any_transparent = false;
  std::vector<EyeBody> eye_bodies;
  /// By light. Set by add_shadow_maps() (raytrace/shadow_maps.h); null where rays find the shadows.
  std::shared_ptr<const std::vector<raster::ShadowMap>> shadow_maps;
  FastPath path;             ///< what may draw the picture
  bool maps_spheres = true;  ///< whether spheres have texture coordinates: pictures that use none do without
  Vec3<Real> background{0};
  Settings settings;
  Viewport<Real> viewport;
  Vec3<Real> eye{0}, right{1, 0, 0}, up{0, 1, 0}, forward{0, 0, 1};  ///< the camera frame; forward has length d
  Real near = 0, far = 0;  ///< of eye rays, a few roundings further out: what lies right on a limit is seen
  Real triangle_epsilon = 0, shadow_epsilon = 0, reflection_epsilon = 0, reflection_cutoff = 0;
  Real box_padding = 0;  ///< how far boxes are grown, in units of the sizes of the coordinates involved
  SlabForm slab_form = SlabForm::robust;  ///< of the clear path
};

/// `channels` are those that the picture stores: some of them only the clear path knows.
template <class Real>
TraceInputs<Real> make_trace_inputs(const Scene& scene, const View& view, const Settings& settings, Prepared& prepared,
                                    Channel channels = Channel::none);

}  // namespace ps
