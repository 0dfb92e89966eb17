#include <algorithm>
#include <array>
#include <span>

#include <fmt/format.h>

#include "scene/generate/uv_sphere.h"
#include "study/stability/jittered_mesh.h"
#include "study/stability/plain_scene.h"

namespace ps::stability::snapped_corners {
namespace {

/// Which triangle each pixel belongs to when vertices are rounded to this number of fractional bits.
Image<int> owners(const FlatMesh& mesh, int side, int bits) {
  Image<int> owner(side, side, -1);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    for_pixels_in_box(mesh, i, bits, FillRule::top_left, side, [&](const auto& edges, int x, int y) {
      if (edges.inside(edges.at(x, y))) owner.at(x, y) = static_cast<int>(i);
    });
  return owner;
}

/// Percentage of pixels that go to another triangle than with 18 bits, for each number of bits, over some meshes of
/// 512 x 512 px.
using ByBits = std::array<double, 4>;
constexpr std::array tried_bits{0, 2, 4, 8};
ByBits wrong_owners(double leg, int meshes, const StabilityRun& run) {
  constexpr int finest = 18, side = 520;
  Random random(run.seed);
  ByBits changed{};
  double all = 0;
  for (int i = 0; i < meshes; ++i) {
    run.check();
    const FlatMesh mesh = jittered_mesh(std::max(3, static_cast<int>(512 / leg)), 2.3, 514.7, 0.3, 0, random);
    const Image<int> truth = owners(mesh, side, finest);
    all += static_cast<double>(
        std::count_if(truth.pixels().begin(), truth.pixels().end(), [](int owner) { return owner >= 0; }));
    for (std::size_t k = 0; k < tried_bits.size(); ++k) {
      const Image<int> owner = owners(mesh, side, tried_bits[k]);
      for (std::size_t p = 0; p < truth.pixels().size(); ++p)
        changed[k] += truth.pixels()[p] >= 0 && owner.pixels()[p] != truth.pixels()[p] ? 1 : 0;
    }
  }
  for (double& share : changed) share = percent(share, all);
  return changed;
}

void measure_bits(const StabilityRun& run, Rows& rows) {
  for (const double leg : {171.0, 17.7, 5.2, 2.6, 1.3}) {
    // Large triangles have few edges: of one such mesh 8 bits change two pixels.
    const ByBits wrong = wrong_owners(leg, leg > 100 ? run.count(8) : 1, run);
    const std::string series = leg > 100 ? fmt::format("legs of {} px", leg) : fmt::format("legs of {:#.3g} px", leg);
    for (std::size_t k = 0; k < tried_bits.size(); ++k)
      rows.add(tried_bits[k], series, wrong[k], wrong.back(), "% of px given to another triangle");
  }
}

/// A ball of radius 1 at a distance of 5 from the book's camera. Its rings run along rows of pixels, so one rounding
/// may move a whole row of edges at once.
Scene ball(int slices) {
  return plain_scene("ball", make_uv_sphere({slices, slices / 2 + 1}), {.translation = {0, 0, 5}});
}

/// A ball's triangles as rays find them, against those of fragments.
class Agreement {
 public:
  Agreement(int slices, const StabilityRun& run) : run_(run), scene_(ball(slices)) {
    settings_.lighting = false;
    settings_.precision = Precision::float64;
    traced_ = ids();
    settings_.renderer = renderer_for(PictureWay::fragments);
  }
  /// Pixels with another triangle.
  double differing(int bits, SamplePosition position = SamplePosition::centre) {
    settings_.subpixel_bits = bits;
    settings_.sample_position = position;
    const Image<PixelId> drawn = ids();
    double count = 0;
    for (std::size_t i = 0; i < drawn.pixels().size(); ++i) count += drawn.pixels()[i] == traced_.pixels()[i] ? 0 : 1;
    return count;
  }
  /// Pixels that show the ball.
  double covered() const {
    return static_cast<double>(std::count_if(traced_.pixels().begin(), traced_.pixels().end(),
                                             [](const PixelId& id) { return id.object >= 0; }));
  }

 private:
  Image<PixelId> ids() const {
    return picture_of(scene_, {scene_.camera, 512, 512}, settings_, Channel::ids, run_).ids;
  }

  const StabilityRun& run_;
  Scene scene_;
  Settings settings_;
  Image<PixelId> traced_;
};

void measure_agreement(const StabilityRun& run, Rows& rows) {
  Agreement ball(80, run);
  const double robust = ball.differing(12);
  for (const int bits : {0, 2, 4, 8, 12})
    rows.add(bits, "both renderers", ball.differing(bits), robust, "px with another triangle");
  rows.add(8, "half a pixel apart", ball.differing(8, SamplePosition::corner), robust, "px with another triangle");
  // Coarser and finer meshes, in shares of a ball that is equally large in each.
  constexpr std::array all_slices{20, 40, 80, 160};
  for (const int slices : std::span(all_slices).first(static_cast<std::size_t>(std::min(4, run.count(4))))) {
    Agreement other(slices, run);
    const std::string series = std::to_string(slices * slices) + " triangles, share of the ball";
    const double finest = percent(other.differing(12), other.covered());
    for (const int bits : {0, 2, 4, 8, 10, 12})
      rows.add(bits, series, percent(other.differing(bits), other.covered()), finest, "% of px with another triangle");
  }
}

StabilityPicture picture_bits(double bits) {
  StabilityPicture picture{.scene = "cgfs/shading"};
  picture.robust.renderer = renderer_for(PictureWay::fragments);
  picture.naive = picture.robust;
  picture.naive.subpixel_bits = static_cast<int>(bits);
  return picture;
}

constexpr std::array frames{0.0, 1.0, 2.0, 4.0, 8.0};

}  // namespace

extern const StabilityExperiment sub_pixel_bits{
    .key = "sub-pixel-bits",
    .place = {Subject::coverage, 50},
    .title = "Sub-pixel bits",
    .keywords = "fixed point, snapping, vertex precision, overflow",
    .knob = "fractional bits of vertex positions",
    .naive = "few bits",
    .robust = "8 bits",
    .explanation =
        "Vertices are rounded before coverage is computed, so edges move by up to half a step. Each bit more halves "
        "the number of pixels that go to another triangle.",
    .safe = "8 bits: 0.2 % of the pixels with triangles of one pixel.",
    .window = {8, everywhere},
    .series = {{.names = "legs of 2.60 px|*", .title = "pixels given to another triangle", .unit = "%"}},
    .add_rows = measure_bits,
    .picture = picture_bits,
    .frames = {frames.begin(), frames.end()}};

extern const StabilityExperiment ray_vs_raster_agreement{
    .key = "ray-vs-raster-agreement",
    .place = {Subject::coverage, 60},
    .title = "Rays and fragments may see different triangles",
    .keywords = "rasterizer, ray tracer, hybrid rendering, edge pixels",
    .knob = "sub-pixel bits",
    .naive = "few bits",
    .robust = "12 bits, the same sample position",
    .explanation =
        "Rays are tested against the exact edges, fragments against edges between rounded vertices. Half a pixel "
        "between their sample positions does more harm than all rounding.",
    .safe = "8 bits and the same sample position.",
    .window = {8, everywhere},
    .series = {{.names = "both renderers|*", .title = "pixels with another triangle", .unit = "px"},
               {.names = "*share of the ball", .title = "pixels of the ball with another triangle", .unit = "%"}},
    .add_rows = measure_agreement,
    .picture = picture_bits,
    .frames = {frames.begin(), frames.end()}};

}  // namespace ps::stability::snapped_corners
