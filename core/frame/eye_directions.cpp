#include "frame/eye_directions.h"

#include "frame/viewport.h"
#include "math/unit.h"

namespace ps {

Image<Vec3f> eye_directions(const View& view, const Settings& settings) {
  const Viewport<double> viewport = make_viewport<double>(view, settings);
  Image<Vec3f> directions(view.width, view.height);
  for (int y = 0; y < view.height; ++y)
    for (int x = 0; x < view.width; ++x) {
      Vec3d direction = view.camera.forward * viewport.distance;
      const Vec2d place = viewport.at(x, y);
      if (settings.projection == Projection::perspective)
        direction += view.camera.right * place.x + view.camera.up * place.y;
      directions.at(x, y) = Vec3f(unit_of(direction));
    }
  return directions;
}

}  // namespace ps
