#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "frame/fast_kernels.h"
#include "frame/frame.h"
#include "frame/prepared.h"
#include "image/mip_chain.h"
#include "raster/base/clip.h"
#include "raster/base/coverage_choice.h"
#include "raster/base/edge_function.h"
#include "raster/setup/depth_format.h"
#include "raster/setup/projection.h"
#include "raster/setup/surface.h"
#include "raster/setup/textures.h"
#include "scene/scene.h"

namespace ps::raster {

struct ShadowMap;       // shadow/shadow_map.h
struct Stencil;         // shadow/stencil.h
struct EnvironmentMap;  // environment/environment_map.h

/// All that stays the same while one picture is made, in the precision of the picture.
template <class Real>
struct RasterInputs {
  const Scene* scene = nullptr;
  Settings settings;
  Channel channels = Channel::none;
  Viewport<double> viewport;
  CanvasProjection<Real> projection;
  CameraSpace camera_space;
  Camera camera;
  Vec3<Real> eye{0, 0, 0};
  Vec3<Real> backward{0, 0, -1};  ///< direction to the viewer in orthographic pictures
  std::vector<ClipPlane<Real>> planes;
  CoverageGrid grid;
  CoverageChoice coverage;
  DepthCode depth;
  std::vector<ShadingLight<Real>> lights;
  std::vector<DrawObject> objects;
  std::vector<std::uint32_t> first_surface;  ///< of each object
  std::vector<Surface<Real>> surfaces;
  std::shared_ptr<const std::vector<MipChain>> textures;  ///< null where none is read

  FastPath path;  ///< what may draw the picture

  /// By light. Set by add_maps(), which fills at most one of these two.
  std::shared_ptr<const std::vector<ShadowMap>> shadow_maps;
  std::shared_ptr<const Stencil> stencil;

  /// By object. Set by add_maps(); null without environment mapping.
  std::shared_ptr<const std::vector<std::shared_ptr<const EnvironmentMap>>> environment;

  bool has_shadows() const { return shadow_maps || stencil; }
  bool perspective() const { return settings.projection == Projection::perspective; }
  /// Whether attributes are carried as value / z.
  bool divides() const { return perspective() && settings.interpolation == Interpolation::perspective; }
  /// From a surface point towards the viewer, world space, not normalised.
  Vec3<Real> to_eye(const Vec3<Real>& world) const { return perspective() ? eye - world : backward; }
};

/// +1, or -1 where a triangle of the object that turns its front to the eye runs clockwise in camera space: the
/// camera's frame mirrors the world, or the instance its model.
template <class Real>
inline double facing_sense(const RasterInputs<Real>& inputs, const DrawObject& object) {
  return object.mirrored ? -inputs.camera_space.handedness : inputs.camera_space.handedness;
}

template <class Real>
RasterInputs<Real> make_raster_inputs(const Scene& scene, const View& view, const Settings& settings, Channel channels,
                                      Prepared& prepared);

}  // namespace ps::raster
