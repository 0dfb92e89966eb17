#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "frame/frame.h"
#include "frame/prepared.h"
#include "frame/view.h"
#include "frame/viewport.h"
#include "image/mip_chain.h"
#include "raster/environment/environment_map.h"
#include "raster/setup/depth_format.h"
#include "raster/setup/draw_list.h"
#include "raster/setup/projection.h"
#include "raster/setup/surface.h"
#include "raster/shadow/shadow_map.h"
#include "raster/shadow/shadow_volume.h"
#include "scene/scene.h"

namespace ps::hardware {

/// All that is known of a picture before a driver is asked: what the rasterizer knows, too.
struct PicturePlan {
  const Scene* scene = nullptr;
  Camera camera;
  Settings settings;
  Channel channels = Channel::none;
  Viewport<double> viewport;
  raster::CanvasProjection<double> projection;
  raster::CameraSpace camera_space;
  raster::DepthCode depth;
  std::vector<raster::DrawObject> objects;
  raster::Surfaces<float> surfaces;
  std::vector<ShadingLight<float>> lights;
  std::shared_ptr<const std::vector<MipChain>> textures;       ///< null where none is read
  bool maps_shadows = false;                                   ///< light is looked up in shadow maps
  std::shared_ptr<const raster::ShadowMaps> shadow_maps;       ///< drawn before the picture, where it does
  bool mirrors = false;                                        ///< surroundings are looked up in environment maps
  std::shared_ptr<const raster::EnvironmentMaps> environment;  ///< drawn before the picture, where it does
  bool counts_volumes = false;                                 ///< shadows are counted in a stencil buffer
  std::shared_ptr<const std::vector<std::vector<raster::ShadowVolume>>> volumes;  ///< by light, where it does
  bool term_colours = false;                                                      ///< SceneTraits::term_colours
  bool defers = false;                                                            ///< shading
  bool exact_places = false;  ///< a light nearly touches a surface (SceneTraits::light_at_surface)
  double farthest = 1;        ///< camera z beyond which nothing lies
  std::optional<TileRect> region;

  bool perspective() const { return settings.projection == Projection::perspective; }
  bool affine() const { return perspective() && settings.interpolation == Interpolation::affine; }
};

PicturePlan make_plan(const Scene& scene, const View& view, const Settings& settings, const RenderRequest& request,
                      Prepared& prepared);

/// Where a point of the world lies before the camera. Without camera-relative positions its place and the camera's are
/// rounded to float first, as vertex.glsl has them.
Vec3d camera_position(const PicturePlan& plan, const Vec3d& world);

/// Samples of a pixel: the power of two that the rasterizer takes, too.
int sample_count(const Settings& settings);

/// The centre of the canvas where samples lie at the centres of pixels, as a driver has them: pixels.
Vec2d shifted_centre(const PicturePlan& plan);

/// Does the surface look up its surroundings in an environment map? A picture of them in its material comes first.
bool mirrors(const PicturePlan& plan, const raster::Surface<float>& surface);
/// Does it show the picture of the surroundings in its material?
bool reflects_picture(const PicturePlan& plan, const raster::Surface<float>& surface);

/// Does the driver interpolate the depth that the options ask for? Otherwise the fragment shader computes it.
bool driver_keeps_depth(const PicturePlan& plan, bool clip_control);

}  // namespace ps::hardware
