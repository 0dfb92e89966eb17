#include "frame/whole_picture.h"

#include "options/option.h"

namespace ps {

std::size_t WholePicture::heap_bytes() const {
  const auto bytes = [](const auto&... images) { return (std::size_t{0} + ... + images.pixels().size_bytes()); };
  return bytes(frame.colour, frame.colour_double, frame.depth, frame.normal, frame.barycentric, frame.uv, frame.ids,
               frame.facing, frame.overdraw, frame.tests, frame.mip, frame.shadow, frame.samples, frame.direction,
               frame.shadow_map, frame.stencil, frame.environment);
}

Key picture_key(std::string_view product, const Scene& scene, const View& view, const Settings& settings,
                const RenderRequest& request) {
  Key key(product);
  key.add(scene.revision());
  const auto add_vector = [&](const Vec3d& v) { key.add(v.x).add(v.y).add(v.z); };
  const Camera& camera = view.camera;
  for (const Vec3d& v : {camera.position, camera.right, camera.up, camera.forward}) add_vector(v);
  key.add(camera.viewport_width).add(camera.viewport_height).add(camera.projection_plane_d);
  key.add(static_cast<std::uint64_t>(view.width)).add(static_cast<std::uint64_t>(view.height));
  for (const Option& option : option_table()) key.add(option.get(settings));
  key.add(request.channels);
  const TileRect region = request.region.value_or(TileRect{0, 0, view.width, view.height});
  for (const int side : {region.x0, region.y0, region.x1, region.y1}) key.add(static_cast<std::uint64_t>(side));
  return key;
}

}  // namespace ps
