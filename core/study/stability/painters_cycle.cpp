#include <algorithm>
#include <array>
#include <numeric>

#include "study/stability/inner_pixels.h"
#include "study/stability/plain_scene.h"

namespace ps::stability::painters_cycle {
namespace {

constexpr int side = 200;  ///< of the picture, px

/// Triangles before the book's camera, submitted in an order of choice.
class Sheets {
 public:
  void add(const Vec3d& a, const Vec3d& b, const Vec3d& c) { triangles_.push_back({a, b, c}); }
  std::size_t size() const { return triangles_.size(); }
  const std::array<Vec3d, 3>& operator[](std::size_t i) const { return triangles_[i]; }

  Scene scene(const std::vector<std::size_t>& order) const {
    Mesh mesh;
    for (const std::size_t i : order) {
      const auto first = static_cast<std::uint32_t>(mesh.positions.size());
      mesh.positions.insert(mesh.positions.end(), triangles_[i].begin(), triangles_[i].end());
      MeshTriangle triangle;
      triangle.position = {first, first + 1, first + 2};
      mesh.triangles.push_back(triangle);
    }
    return plain_scene("sheets", std::move(mesh));
  }

 private:
  std::vector<std::array<Vec3d, 3>> triangles_;
};

/// What the program shows of sheets, against exact rays.
class Judge {
 public:
  Judge(const Sheets& sheets, const StabilityRun& run) : sheets_(sheets), run_(run), as_given_(sheets.size()) {
    std::iota(as_given_.begin(), as_given_.end(), std::size_t{0});
    Settings rays;
    rays.lighting = false;
    rays.precision = Precision::float64;
    truth_ = shown(as_given_, rays);
  }
  /// Percentage of covered pixels that show one triangle although another one lies before it, by more than depths in
  /// float are rounded.
  double wrong(Visibility visibility, const std::vector<std::size_t>& order) const {
    Settings settings = unlit_fragments();
    settings.visibility = visibility;
    const Shown drawn = shown(order, settings);
    constexpr float rounding = 1e-5f;  // of depths, relative
    double covered = 0, wrong = 0;
    for_inner_pixels(truth_.owners, [&](int x, int y) {
      if (truth_.owners.at(x, y) == background_owner) return;
      ++covered;
      const bool other = drawn.owners.at(x, y) != truth_.owners.at(x, y);
      wrong += other && drawn.depth.at(x, y) > truth_.depth.at(x, y) * (1 + rounding) ? 1 : 0;
    });
    return percent(wrong, covered);
  }
  double wrong(Visibility visibility) const { return wrong(visibility, as_given_); }

 private:
  struct Shown {
    Owners owners;
    Image<float> depth;
  };
  Shown shown(const std::vector<std::size_t>& order, const Settings& settings) const {
    const Scene scene = sheets_.scene(order);
    Frame frame = picture_of(scene, {scene.camera, side, side}, settings, Channel::ids | Channel::depth, run_);
    const auto as_given = [&](const PixelId& id) {
      return static_cast<std::int32_t>(order[static_cast<std::size_t>(id.triangle)]);
    };
    return {owners_of(frame.ids, as_given), std::move(frame.depth)};
  }

  const Sheets& sheets_;
  const StabilityRun& run_;
  std::vector<std::size_t> as_given_;
  Shown truth_;
};

/// Three bars 2.7 x 0.3 around a point 4 before the camera, each nearer at one end, where it lies over the next bar,
/// and farther at the other, where it lies under the one before. Each is made of `pieces` quads of two triangles.
Sheets bars(int pieces) {
  Sheets sheets;
  for (int k = 0; k < 3; ++k) {
    const double angle = 2 * pi * k / 3;
    const Vec3d along(std::cos(angle), std::sin(angle), 0), across(-along.y, along.x, 0);
    for (int piece = 0; piece < pieces; ++piece) {
      const auto at = [&](int end, double sideways) {
        const double share = static_cast<double>(piece + end) / pieces - 0.5;
        return along * (2.7 * share) + across * sideways + Vec3d(0, 0, 4 + share);
      };
      sheets.add(at(0, -0.5), at(1, -0.5), at(1, -0.2));
      sheets.add(at(0, -0.5), at(1, -0.2), at(0, -0.2));
    }
  }
  return sheets;
}

/// Triangles within cubes of side 2 whose centres lie anywhere in a box before the camera.
Sheets random_triangles(int count, Random& random) {
  Sheets sheets;
  for (int i = 0; i < count; ++i) {
    const Vec3d centre(random.between(-2, 2), random.between(-2, 2), random.between(4, 8));
    const Vec3d a = centre + random.in_cube(1), b = centre + random.in_cube(1), c = centre + random.in_cube(1);
    sheets.add(a, b, c);
  }
  return sheets;
}

/// The triangles from the farthest to the nearest by one of their vertices. The program's painter goes by their mean
/// depth; any other order is drawn by it as submitted.
enum class Vertex { nearest, farthest };
std::vector<std::size_t> sorted(const Sheets& sheets, Vertex by) {
  const auto depth = [&](std::size_t i) {
    const auto [low, high] = std::minmax({sheets[i][0].z, sheets[i][1].z, sheets[i][2].z});
    return by == Vertex::nearest ? low : high;
  };
  std::vector<std::size_t> order(sheets.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return depth(a) > depth(b); });
  return order;
}

constexpr const char* unit = "% of covered pixels wrong";

void add_bars(Rows& rows, const StabilityRun& run) {
  const Sheets three = bars(1);
  const Judge of_bars(three, run);
  double best = 100, worst = 0;
  std::array<std::size_t, 3> order{0, 1, 2};
  do {
    std::vector<std::size_t> drawn;
    for (const std::size_t bar : order) drawn.insert(drawn.end(), {2 * bar, 2 * bar + 1});
    const double wrong = of_bars.wrong(Visibility::draw_order, drawn);
    best = std::min(best, wrong);
    worst = std::max(worst, wrong);
  } while (std::next_permutation(order.begin(), order.end()));
  const double robust = of_bars.wrong(Visibility::depth_buffer);
  rows.add(3, "three bars, best order", best, robust, unit);
  rows.add(3, "three bars, worst order", worst, robust, unit);
  rows.add(3, "three bars, painter", of_bars.wrong(Visibility::painter), robust, unit);
  const Sheets halves = bars(2);
  const Judge of_halves(halves, run);
  rows.add(6, "three bars cut in two, painter", of_halves.wrong(Visibility::painter),
           of_halves.wrong(Visibility::depth_buffer), unit);
}

/// The mean over several pictures, since few triangles overlap by chance alone.
void add_random_triangles(Rows& rows, int count, const StabilityRun& run) {
  Random random(run.seed);
  const int pictures = run.count(5, 2);
  double painter = 0, nearest = 0, farthest = 0, buffer = 0;
  for (int i = 0; i < pictures; ++i) {
    const Sheets sheets = random_triangles(count, random);
    const Judge judge(sheets, run);
    painter += judge.wrong(Visibility::painter) / pictures;
    nearest += judge.wrong(Visibility::draw_order, sorted(sheets, Vertex::nearest)) / pictures;
    farthest += judge.wrong(Visibility::draw_order, sorted(sheets, Vertex::farthest)) / pictures;
    buffer += judge.wrong(Visibility::depth_buffer) / pictures;
  }
  const double knob = count;
  rows.add(knob, "random triangles, painter", painter, buffer, unit);
  rows.add(knob, "random triangles, by nearest vertex", nearest, buffer, unit);
  rows.add(knob, "random triangles, by farthest vertex", farthest, buffer, unit);
}

void measure(const StabilityRun& run, Rows& rows) {
  add_bars(rows, run);
  for (const int count : {10, 30, 100, 300}) add_random_triangles(rows, count, run);
}

StabilityPicture picture(double) {
  StabilityPicture picture{.scene = "cgfs/depth"};
  picture.robust = unlit_fragments();
  picture.naive = picture.robust;
  picture.naive.visibility = Visibility::painter;
  return picture;
}

}  // namespace

extern const StabilityExperiment painters_cycle{
    .key = "painter-s-cycle",
    .place = {Subject::depth, 70},
    .title = "Painter's algorithm: cycles have no order",
    .keywords = "hidden surface, painter's algorithm, depth sort, z-buffer, cyclic overlap",
    .knob = "number of sheets",
    .naive = "draw from far to near (painter's algorithm)",
    .robust = "depth buffer",
    .explanation = "Three bars that overlap in a cycle have no order from far to near. A triangle that reaches from "
                   "near to far has no single depth for the sort. A depth buffer decides for each pixel.",
    .safe = "Sheets that have an order from far to near, such as one alone.",
    .window = {0, 1},
    .series = {{.names = "three bars*",
                .title = "wrong pixels of three bars in a cycle",
                .unit = "% of covered pixels"},
               {.names = "random triangles, painter|*",
                .title = "wrong pixels of random triangles",
                .unit = "% of covered pixels"}},
    .add_rows = measure,
    .picture = picture,
    .frames = {3.0}};

}  // namespace ps::stability::painters_cycle
