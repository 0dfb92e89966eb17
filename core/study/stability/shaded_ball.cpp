#include "study/stability/shaded_ball.h"

#include <algorithm>
#include <memory>
#include <numeric>
#include <span>

#include <glm/common.hpp>

namespace ps::stability {
namespace {

constexpr int lights_at_a_time = 20;
constexpr double intensity = 0.5;  // of the lights that show errors

Material black_with_highlight(double exponent) {
  Material material;
  material.colour = Vec3d(0);
  material.specular = exponent;
  material.specular_colour = Vec3d(1);
  return material;
}

constexpr double far_away = 100;

/// Pictures of one ball.
class BallPictures {
 public:
  /// The smooth ball.
  BallPictures(const Material& material, int side, const StabilityRun& run)
      : BallPictures(Sphere{}, material, side, renderer_for(PictureWay::rays), run) {}
  BallPictures(Mesh triangles, const Material& material, int side, const StabilityRun& run)
      : BallPictures(Instance{}, material, side, renderer_for(PictureWay::fragments), run) {
    triangles.materials = {0};
    scene_.geometry.edit(
        [&](Geometry& geometry) { geometry.meshes = {std::make_shared<const Mesh>(std::move(triangles))}; });
  }

  /// Linear colours without clamping, under up to three lights, each of which has a channel of its own: the first is
  /// red, the second green, the third blue.
  Image<Vec3f> under(std::span<const Vec3d> to_lights, double brightness, const Settings& settings) {
    std::vector<Light> lights;
    for (std::size_t i = 0; i < to_lights.size(); ++i) {
      lights.push_back({LightKind::directional, brightness, Vec3d(0)});
      lights.back().colour[static_cast<int>(i)] = 1;
      lights.back().direction = to_lights[i];
    }
    scene_.lights = Part<std::vector<Light>>(std::move(lights));
    return draw(settings, Channel::none).colour;
  }

  /// 1 where a pixel shows the ball, 0 elsewhere.
  Image<std::uint8_t> shown() {
    const Image<PixelId> ids = draw({}, Channel::ids).ids;
    Image<std::uint8_t> shown(ids.width(), ids.height());
    for (std::size_t i = 0; i < ids.pixels().size(); ++i) shown.pixels()[i] = ids.pixels()[i].object >= 0 ? 1 : 0;
    return shown;
  }

 private:
  BallPictures(const decltype(Object::shape)& shape, const Material& material, int side, Renderer renderer,
               const StabilityRun& run)
      : side_(side), renderer_(renderer), run_(run) {
    scene_.camera.position = {0, 0, -far_away};
    scene_.camera.projection_plane_d = far_away;
    scene_.camera.viewport_width = scene_.camera.viewport_height = 2;
    scene_.background = Vec3d(0);
    scene_.materials = Part<std::vector<Material>>({material});
    Geometry geometry;
    geometry.objects.push_back({"ball", shape});
    scene_.geometry = Part<Geometry>(std::move(geometry));
  }

  Frame draw(Settings settings, Channel channels) {
    settings.renderer = renderer_;
    settings.near = 0.5;
    settings.shadows = Shadows::none;
    run_.check();
    Progress own;
    RenderRequest request;
    request.channels = channels;
    return render(scene_, {scene_.camera, side_, side_}, settings, request, prepared_,
                  run_.progress ? *run_.progress : own);
  }

  Scene scene_;
  int side_;
  Renderer renderer_;
  const StabilityRun& run_;
  Prepared prepared_;
};

/// Directions towards lights before the ball.
std::vector<Vec3d> lights_before_ball(int count, std::uint32_t seed) {
  constexpr double least_cosine = 0.2;  // nearer to the outline the ball's pixels see the highlight edge-on
  Random random(seed);
  std::vector<Vec3d> lights;
  while (static_cast<int>(lights.size()) < count)
    if (const Vec3d to_light = random.direction(); to_light.z < -least_cosine) lights.push_back(to_light);
  return lights;
}

/// Calls use(first, lights) for three lights at a time, of which the first has that number.
template <class Use>
void for_each_three(const std::vector<Vec3d>& lights, Use&& use) {
  for (std::size_t first = 0; first < lights.size(); first += 3)
    use(first, std::span(lights).subspan(first, std::min<std::size_t>(3, lights.size() - first)));
}

}  // namespace

KeptPeaks kept_peaks(const Mesh& triangles, double exponent, const Settings& settings, int lights,
                     const StabilityRun& run) {
  BallPictures ball(triangles, black_with_highlight(exponent), 200, run);
  std::vector<double> peaks(static_cast<std::size_t>(lights));
  for_each_three(lights_before_ball(lights, run.seed), [&](std::size_t first, std::span<const Vec3d> three) {
    const Image<Vec3f> picture = ball.under(three, 1, settings);
    for (const Vec3f& colour : picture.pixels())
      for (std::size_t i = 0; i < three.size(); ++i)
        peaks[first + i] = std::max(peaks[first + i], static_cast<double>(colour[static_cast<int>(i)]));
  });
  KeptPeaks kept;
  for (auto some = peaks.begin(); some != peaks.end(); some += lights_at_a_time) {
    kept.mean += std::accumulate(some, some + lights_at_a_time, 0.0) / lights;
    kept.least += *std::min_element(some, some + lights_at_a_time) * lights_at_a_time / lights;
  }
  return kept;
}

BallErrors::BallErrors(double exponent, const StabilityRun& run)
    : side_(run.side(200)), run_(run), lights_(lights_before_ball(lights_at_a_time, run.seed)) {
  material_.specular = exponent;
  BallPictures smooth(material_, side_, run);
  for_each_three(lights_, [&](std::size_t, std::span<const Vec3d> three) {
    truths_.push_back(smooth.under(three, intensity, {}));
  });
  shown_ = smooth.shown();
}

double BallErrors::rmse(const Mesh& triangles, const Settings& settings) const {
  BallPictures ball(triangles, material_, side_, run_);
  const Image<std::uint8_t> shown = ball.shown();
  double squares = 0, count = 0;
  for_each_three(lights_, [&](std::size_t first, std::span<const Vec3d> three) {
    const Image<Vec3f>& truth = truths_[first / 3];
    const Image<Vec3f> picture = ball.under(three, intensity, settings);
    for (std::size_t i = 0; i < shown.pixels().size(); ++i) {
      if (shown.pixels()[i] == 0 || shown_.pixels()[i] == 0) continue;
      const Vec3d off = 255.0 * (Vec3d(picture.pixels()[i]) - Vec3d(truth.pixels()[i]));
      squares += dot(off, off);  // a channel without a light is 0 in both
      count += static_cast<double>(three.size());
    }
  });
  return std::sqrt(squares / count);
}

NormalErrors normal_errors(const Mesh& triangles, double exponent, const StabilityRun& run) {
  Material material;
  material.specular = exponent;
  BallPictures ball(triangles, material, run.side(200), run);
  const Image<std::uint8_t> shown = ball.shown();
  NormalErrors errors;
  for_each_three(lights_before_ball(6, run.seed), [&](std::size_t, std::span<const Vec3d> three) {
    const auto draw = [&](bool renormalise, Precision numbers) {
      return ball.under(three, intensity, {.renormalise = renormalise, .precision = numbers});
    };
    const Image<Vec3f> truth = draw(true, Precision::float64);
    const auto largest_error = [&](const Image<Vec3f>& picture) {
      float largest = 0;
      for (std::size_t i = 0; i < shown.pixels().size(); ++i) {
        if (shown.pixels()[i] == 0) continue;
        const Vec3f off = glm::abs(picture.pixels()[i] - truth.pixels()[i]);
        largest = std::max({largest, off.x, off.y, off.z});
      }
      return 255 * static_cast<double>(largest);
    };
    errors.as_interpolated = std::max(errors.as_interpolated, largest_error(draw(false, Precision::float32)));
    errors.renormalised = std::max(errors.renormalised, largest_error(draw(true, Precision::float32)));
  });
  return errors;
}

}  // namespace ps::stability
