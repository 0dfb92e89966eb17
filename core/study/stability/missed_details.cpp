#include <algorithm>

#include <fmt/format.h>

#include "scene/scene_writer.h"
#include "study/stability/plain_scene.h"
#include "study/stability/support.h"

namespace ps::stability::missed_details {
namespace {

/// White things before black, without lights, in an orthographic picture whose pixels are 1 world unit wide.
Scene in_pixels(Geometry geometry, int width, int height) {
  Scene scene = plain_scene(std::move(geometry));
  scene.camera.viewport_width = width;
  scene.camera.viewport_height = height;
  scene.background = Vec3d(0);
  return scene;
}
Settings without_light() {
  Settings settings;
  settings.projection = Projection::orthographic;
  settings.lighting = false;
  return settings;
}

/// Discs (balls, seen from straight ahead) at places x places positions relative to the pixels, spread evenly over one
/// pixel. Each lies in the middle one of apart x apart pixels of its own.
class Discs {
 public:
  Discs(double diameter, int places, int apart, const StabilityRun& run) : run_(run), places_(places), apart_(apart) {
    Geometry geometry;
    const int first = apart / 2;
    for (int j = 0; j < places; ++j)
      for (int i = 0; i < places; ++i) {
        const double x = apart * i + first + (i + 0.5) / places, y = apart * j + first + (j + 0.5) / places;
        geometry.objects.push_back({"disc", Sphere{{x - side() / 2.0, side() / 2.0 - y, 10}, diameter / 2}});
      }
    scene_ = in_pixels(std::move(geometry), side(), side());
  }

  /// Of the picture, in pixels.
  int side() const { return apart_ * places_; }
  const Scene& scene() const { return scene_; }

  /// Which discs show in any pixel.
  std::vector<bool> seen(const Settings& settings) {
    run_.check();
    Progress own;
    const Frame frame =
        render(scene_, {scene_.camera, side(), side()}, settings, {}, prepared_, run_.progress ? *run_.progress : own);
    std::vector<bool> seen(static_cast<std::size_t>(places_) * static_cast<std::size_t>(places_));
    for (int y = 0; y < side(); ++y)
      for (int x = 0; x < side(); ++x)
        if (frame.colour.at(x, y).x > 0) {
          const int place = y / apart_ * places_ + x / apart_;
          seen[static_cast<std::size_t>(place)] = true;
        }
    return seen;
  }

 private:
  const StabilityRun& run_;
  int places_, apart_;
  Scene scene_;
  Prepared prepared_;
};

double percent_missed(const std::vector<bool>& seen) {
  return percent(static_cast<double>(std::count(seen.begin(), seen.end(), false)), static_cast<double>(seen.size()));
}

Settings samples(int count, SamplePattern pattern = SamplePattern::grid) {
  Settings settings = without_light();
  settings.samples_per_pixel = count;
  settings.sample_pattern = pattern;
  return settings;
}

void measure_disc(const StabilityRun& run, Rows& rows) {
  Settings at_corner = samples(1);
  at_corner.sample_position = SamplePosition::corner;
  const auto add = [&](double diameter, const char* series, double naive, double robust) {
    rows.add(diameter, series, naive, robust, "% missed");
  };
  for (const double diameter : {0.1, 0.3, 0.5, 0.7, 1.0, 1.4}) {
    Discs discs(diameter, run.effort < 1 ? 24 : 48, 3, run);
    const std::vector<bool> centres = discs.seen(samples(1)), corners = discs.seen(at_corner);
    std::vector<bool> both = centres;
    for (std::size_t i = 0; i < both.size(); ++i) both[i] = both[i] || corners[i];
    const double robust = percent_missed(discs.seen(samples(16)));
    add(diameter, "centres", percent_missed(centres), robust);
    add(diameter, "corners", percent_missed(corners), robust);
    add(diameter, "centres and corners", percent_missed(both), robust);
    add(diameter, "anywhere (random)", percent_missed(discs.seen(samples(1, SamplePattern::random))), robust);
    if (diameter <= 1)
      add(diameter, "closed form: 1 - pi D^2 / 4", 100 * (1 - pi * diameter * diameter / 4), std::nan(""));
  }
}

StabilityPicture picture_disc(double diameter) {
  const Discs discs(diameter, 20, 8, {});
  StabilityPicture picture{.scene = write_scene(discs.scene(), "."), .width = discs.side(), .height = discs.side()};
  picture.naive = samples(1);
  picture.robust = samples(16);
  return picture;
}

/// White bars before black, each a thing of its own. They are 33 pixels apart, so that they begin at each column of the
/// tiles of 32 pixels within which subsampling works.
class Bars {
 public:
  explicit Bars(int width) {
    Geometry geometry;
    for (int i = 0; i < count; ++i)
      geometry.objects.push_back({"bar", Solid{Rectangle{{apart * i - columns / 2.0, -rows / 2.0, 10},
                                                         {static_cast<double>(width), 0, 0},
                                                         {0, static_cast<double>(rows), 0}}}});
    scene_ = in_pixels(std::move(geometry), columns, rows);
  }

  /// Percentage of bars that show in no pixel.
  double missed(int subsampling, const StabilityRun& run) const {
    Settings settings = without_light();
    settings.subsampling = subsampling;
    const Frame frame = picture_of(scene_, {scene_.camera, columns, rows}, settings, Channel::ids, run);
    std::vector<bool> seen(count);
    for (const PixelId& id : frame.ids.pixels())
      if (id.object >= 0) seen[static_cast<std::size_t>(id.object)] = true;
    return percent_missed(seen);
  }

 private:
  static constexpr int count = 32, apart = 33, columns = count * apart, rows = 32;
  Scene scene_;
};

void measure_bars(const StabilityRun& run, Rows& rows) {
  for (const int step : {2, 4, 8, 16})
    for (const int width : {1, 2, 4, 8}) {
      if (width >= step) continue;
      const Bars bars(width);
      rows.add(step, fmt::format("bars {} px wide", width), bars.missed(step, run), bars.missed(1, run), "% missed");
      rows.add(step, fmt::format("closed form: 1 - {} / k", width), 100 * (1 - static_cast<double>(width) / step),
               std::nan(""), "% missed");
    }
}

StabilityPicture picture_bars(double step) {
  StabilityPicture picture{.scene = "cgfs/fence"};
  picture.naive.subsampling = static_cast<int>(step);
  return picture;
}

}  // namespace

extern const StabilityExperiment sub_pixel_disc_missed{
    .key = "sub-pixel-disc-missed",
    .place = {Subject::sampling, 40},
    .set_up = SetUp::reproduction,
    .title = "Sub-pixel detail: discs between the samples",
    .keywords = "aliasing, undersampling, small objects, AA, antialias, flicker",
    .knob = "diameter (px)",
    .naive = "one sample per pixel: at the centre, at a corner, at both, or anywhere",
    .robust = "4 x 4 samples per pixel",
    .explanation =
        "What lies between samples is invisible to them. One sample at the same place of each pixel misses a disc of "
        "diameter D <= 1 px with probability 1 - pi D^2 / 4, random samples miss more. No later step brings it back.",
    .safe = "Discs larger than 1.42 pixels.",
    .window = {1.42, everywhere},
    .series = {{.names = "centres|*", .title = "discs that no sample meets", .unit = "%"}},
    .add_rows = measure_disc,
    .picture = picture_disc,
    .frames = {0.3, 0.5, 0.7, 1.0}};

extern const StabilityExperiment subsampling_bars{
    .key = "subsampling-bars",
    .place = {Subject::sampling, 50},
    .set_up = SetUp::reproduction,
    .title = "Subsampling: bars between traced pixels",
    .keywords = "undersampling, half resolution, thin objects, aliasing",
    .knob = "subsampling: every k-th pixel is searched",
    .naive = "subsampling = k",
    .robust = "subsampling = 1",
    .explanation = "If every k-th column is traced, 1 - w / k of all bars w pixels wide lie between two traced "
                   "columns. Here it is a few less, because the last column of each tile of 32 pixels is traced as "
                   "well. Tracing where neighbours differ does not help, because both sides of the bar agree.",
    .safe = "Objects at least k pixels wide.",
    .window = {1, 1},
    .series = {{.names = "bars 1 px wide|*", .title = "bars that no traced column meets", .unit = "%"}},
    .add_rows = measure_bars,
    .picture = picture_bars,
    .frames = {2.0, 4.0, 8.0, 16.0}};

}  // namespace ps::stability::missed_details
