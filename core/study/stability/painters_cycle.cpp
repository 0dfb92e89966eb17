#include <algorithm>
#include <array>
#include <numeric>

#include "study/stability/support.h"

namespace ps::stability {
namespace {

/// A triangle on the screen with a depth at each corner.
struct Sheet {
  std::array<Vec3d, 3> p;
};

/// Depth at a place inside the sheet, or infinity.
double depth_at(const Sheet& sheet, double x, double y) {
  const auto edge = [&](const Vec3d& a, const Vec3d& b) { return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x); };
  const double u = edge(sheet.p[1], sheet.p[2]), v = edge(sheet.p[2], sheet.p[0]), w = edge(sheet.p[0], sheet.p[1]);
  if (!((u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0)) || u + v + w == 0) return everywhere;
  return (u * sheet.p[0].z + v * sheet.p[1].z + w * sheet.p[2].z) / (u + v + w);
}

constexpr int side = 200;

/// Percentage of covered pixels that show the wrong sheet when they are painted in this order, last on top.
double wrong_share(const std::vector<Sheet>& sheets, const std::vector<std::size_t>& order) {
  double covered = 0, wrong = 0;
  for (int row = 0; row < side; ++row)
    for (int column = 0; column < side; ++column) {
      const double x = (column + 0.5) / side, y = (row + 0.5) / side;
      double nearest = everywhere, last_painted = everywhere;
      for (const std::size_t i : order) {
        const double z = depth_at(sheets[i], x, y);
        if (z == everywhere) continue;
        nearest = std::min(nearest, z);
        last_painted = z;
      }
      if (nearest == everywhere) continue;
      ++covered;
      wrong += last_painted > nearest ? 1 : 0;
    }
  return percent(wrong, covered);
}

/// A z-buffer in float: of the sheets in any order the nearest stays.
double buffered_share(const std::vector<Sheet>& sheets) {
  double covered = 0, wrong = 0;
  for (int row = 0; row < side; ++row)
    for (int column = 0; column < side; ++column) {
      const double x = (column + 0.5) / side, y = (row + 0.5) / side;
      double truth = everywhere, kept = everywhere;
      float stored = std::numeric_limits<float>::infinity();
      for (const Sheet& sheet : sheets) {
        const double z = depth_at(sheet, x, y);
        truth = std::min(truth, z);
        if (static_cast<float>(z) < stored) stored = static_cast<float>(z), kept = z;
      }
      if (truth == everywhere) continue;
      ++covered;
      wrong += kept > truth * (1 + 1e-6) ? 1 : 0;
    }
  return percent(wrong, covered);
}

/// Three bars, each over the next one and under the one before, each of so many pieces along it.
std::vector<Sheet> bars(int pieces) {
  std::vector<Sheet> sheets;
  for (int k = 0; k < 3; ++k) {
    const double angle = 2 * pi * k / 3;
    const Vec2d along(std::cos(angle), std::sin(angle)), across(-along.y, along.x);
    for (int piece = 0; piece < pieces; ++piece) {
      const double from = static_cast<double>(piece) / pieces, to = static_cast<double>(piece + 1) / pieces;
      const auto at = [&](double share, double c) {
        const Vec2d p = Vec2d(0.5) + along * (0.9 * share - 0.45) + across * c;
        return Vec3d(p.x, p.y, 1 + share);
      };
      sheets.push_back({{at(from, -0.16), at(to, -0.16), at(to, -0.06)}});
      sheets.push_back({{at(from, -0.16), at(to, -0.06), at(from, -0.06)}});
    }
  }
  return sheets;
}

enum class SortBy { centroid, nearest, farthest };

std::vector<std::size_t> sorted(const std::vector<Sheet>& sheets, SortBy by) {
  const auto key = [&](std::size_t i) {
    const auto& p = sheets[i].p;
    switch (by) {
    case SortBy::centroid:
      return p[0].z + p[1].z + p[2].z;
    case SortBy::nearest:
      return std::min({p[0].z, p[1].z, p[2].z});
    case SortBy::farthest:
      return std::max({p[0].z, p[1].z, p[2].z});
    }
    return 0.0;
  };
  std::vector<std::size_t> order(sheets.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return key(a) > key(b); });
  return order;
}

std::vector<StabilityRow> measure(const StabilityRun& run) {
  Rows rows(run);
  const std::vector<Sheet> three = bars(1), halves = bars(2);
  double best = 100, worst = 0;
  std::array<std::size_t, 3> order{0, 1, 2};
  do {
    std::vector<std::size_t> sheets;
    for (const std::size_t bar : order) sheets.insert(sheets.end(), {2 * bar, 2 * bar + 1});
    const double wrong = wrong_share(three, sheets);
    best = std::min(best, wrong);
    worst = std::max(worst, wrong);
  } while (std::next_permutation(order.begin(), order.end()));
  rows.push_back({3, "three bars, best order", best, buffered_share(three), "% of covered pixels wrong"});
  rows.push_back({3, "three bars, worst order", worst, buffered_share(three), "% of covered pixels wrong"});
  rows.push_back({6, "three bars cut in two, by centroid", wrong_share(halves, sorted(halves, SortBy::centroid)),
                  buffered_share(halves), "% of covered pixels wrong"});
  for (const int count : {10, 30, 100, 300}) {
    run.check();
    Random random(run.seed);
    std::vector<Sheet> soup;
    for (int i = 0; i < count; ++i) {
      const Vec3d centre(random.unit(), random.unit(), random.between(2, 10));
      Sheet sheet;
      for (Vec3d& p : sheet.p) p = centre + random.in_cube(0.3) * Vec3d(1, 1, 3);
      soup.push_back(sheet);
    }
    const double robust = buffered_share(soup);
    for (const auto& [by, name] : {std::pair{SortBy::centroid, "soup by centroid"},
                                   {SortBy::nearest, "soup by nearest corner"},
                                   {SortBy::farthest, "soup by farthest corner"}})
      rows.push_back(
          {static_cast<double>(count), name, wrong_share(soup, sorted(soup, by)), robust, "% of covered pixels wrong"});
  }
  return rows;
}

StabilityPicture picture(double) {
  StabilityPicture picture{.scene = "cgfs/depth"};
  picture.robust.renderer = Renderer::rasterizer;
  picture.naive = picture.robust;
  picture.naive.visibility = Visibility::painter;
  return picture;
}

constexpr std::array frames{3.0};

}  // namespace

const StabilityExperiment painters_cycle{
    .key = "painter-s-cycle",
    .title = "The painter's cycle",
    .knob = "sheets",
    .naive = "paint from far to near",
    .robust = "depth buffer",
    .explanation =
        "Three bars that overlap in a circle have no order from far to near, and a triangle that reaches from "
        "near to far has no single depth. A depth buffer decides for each pixel.",
    .safe = "Sheets that can be ordered.",
    .window = {0, 1},
    .measure = measure,
    .picture = picture,
    .frames = frames};

}  // namespace ps::stability
