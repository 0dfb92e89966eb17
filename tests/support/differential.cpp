#include "support/differential.h"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cmath>
#include <vector>

#include "frame/display_frame.h"
#include "support/random_settings.h"
#include "support/render_once.h"
#include "support/simd_targets.h"

namespace ps::test {
namespace {

bool same_number(float a, float b) {
  return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b) || (std::isnan(a) && std::isnan(b));
}
bool same_number(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) || (std::isnan(a) && std::isnan(b));
}
bool same_number(std::uint32_t a, std::uint32_t b) { return a == b; }
bool same_number(const PixelId& a, const PixelId& b) { return a == b; }
template <int n, class Real>
bool same_number(const glm::vec<n, Real>& a, const glm::vec<n, Real>& b) {
  for (int i = 0; i < n; ++i)
    if (!same_number(a[i], b[i])) return false;
  return true;
}

/// The first pixel of `region` in which two images differ.
template <class T>
std::optional<Vec2i> differing_pixel(const Image<T>& a, const Image<T>& b, const TileRect& region) {
  if (a.empty() != b.empty()) return Vec2i(-1, -1);
  if (a.empty()) return {};
  for (int y = region.y0; y < region.y1; ++y)
    for (int x = region.x0; x < region.x1; ++x)
      if (!same_number(a.at(x, y), b.at(x, y))) return Vec2i(x, y);
  return {};
}

/// What a search costs depends on the tree, and SIMD searches trees of its own, several rays at once; surfaces that are
/// cut out by a picture are asked in the order in which the search meets them.
Counters without_the_search(Counters counters) {
  for (const Counter c : {Counter::node_visits, Counter::triangle_tests, Counter::sphere_tests, Counter::solid_tests,
                          Counter::edge_rays, Counter::texel_reads})
    counters[c] = 0;
  return counters;
}

std::string work_difference(const Subject& subject, const Frame& a, const Frame& b) {
  const bool rays = subject.settings.renderer == Renderer::ray_tracer;
  const Counters one = rays ? without_the_search(a.counters) : a.counters;
  const Counters other = rays ? without_the_search(b.counters) : b.counters;
  for (std::size_t i = 0; i < counter_count; ++i)
    if (one.values[i] != other.values[i])
      return fmt::format("{} are {} and {}", counter_label(static_cast<Counter>(i)), one.values[i], other.values[i]);
  return {};
}

/// Another accelerator that must find the same; of a large model, one that does not test all of it for each ray.
/// Embree's own arithmetic may part at edges, and the naive slab test loses boxes, as its help says.
Accelerator another_accelerator(const Scene& scene, const Settings& settings, std::mt19937& random) {
  constexpr std::array all{Accelerator::bvh,  Accelerator::octree, Accelerator::two_level,
                           Accelerator::none, Accelerator::box,    Accelerator::bounding_spheres};
  if (settings.accelerator == Accelerator::embree || settings.slab_test == SlabTest::naive) return settings.accelerator;
  return all[static_cast<std::size_t>(below(random, is_large(scene) ? 3 : static_cast<int>(all.size())))];
}

TileRect random_region(const View& view, std::mt19937& random) {
  const int x = below(random, view.width), y = below(random, view.height);
  return {x, y, x + 1 + below(random, view.width - x), y + 1 + below(random, view.height - y)};
}

std::string inspector_fault(const Subject& subject, const Frame& picture, const Vec2i& pixel) {
  Prepared own;
  Progress progress;
  const PixelStory story = inspect(*subject.scene, subject.view, subject.settings, pixel,
                                   subject.prepared ? *subject.prepared : own, progress);
  const Vec3d stored = linear_at(picture, pixel);
  bool same = true;
  for (int i = 0; i < 3; ++i)
    same = same && (story.linear[i] == stored[i] || (std::isnan(story.linear[i]) && std::isnan(stored[i])));
  if (!same)
    return fmt::format("the inspector has ({}, {}, {}) for ({}, {}, {}) at {},{}", story.linear.x, story.linear.y,
                       story.linear.z, stored.x, stored.y, stored.z, pixel.x, pixel.y);
  return story.verdict.empty() ? "the inspector has no verdict" : "";
}

}  // namespace

bool is_large(const Scene& scene) {
  std::size_t triangles = 0;
  for (const auto& mesh : scene.geometry->meshes) triangles += mesh->triangles.size();
  return triangles > 2000;
}

std::string picture_difference(const Frame& a, const Frame& b, const TileRect& region) {
  std::string found;
  const auto compare = [&](const char* name, const auto& one, const auto& other) {
    if (!found.empty()) return;
    if (const auto pixel = differing_pixel(one, other, region))
      found = fmt::format("{} differs at {},{}", name, pixel->x, pixel->y);
  };
  compare("colour", a.colour, b.colour);
  compare("colour in double", a.colour_double, b.colour_double);
  compare("depth", a.depth, b.depth);
  compare("normal", a.normal, b.normal);
  compare("barycentric", a.barycentric, b.barycentric);
  compare("uv", a.uv, b.uv);
  compare("ids", a.ids, b.ids);
  compare("facing", a.facing, b.facing);
  compare("overdraw", a.overdraw, b.overdraw);
  compare("mip", a.mip, b.mip);
  compare("shadow", a.shadow, b.shadow);
  compare("samples", a.samples, b.samples);
  compare("direction", a.direction, b.direction);
  return found;
}

Frame drawn(const Subject& subject, const Settings& settings, const std::optional<TileRect>& region) {
  Prepared own;
  Progress progress;
  return render(*subject.scene, subject.view, settings, request_for(subject.channels, region),
                subject.prepared ? *subject.prepared : own, progress);
}

std::string differential_fault(const Subject& subject, std::mt19937& random, SeenPaths& seen, Targets targets) {
  const TileRect all{0, 0, subject.view.width, subject.view.height};
  Settings plain = subject.settings;
  plain.simd = Simd::off;
  plain.threads = 1;
  const Frame base = drawn(subject, plain);
  std::vector<Simd> all_targets = simd_targets();
  if (targets == Targets::one && !all_targets.empty())
    all_targets = {all_targets[static_cast<std::size_t>(below(random, static_cast<int>(all_targets.size())))]};
  else
    all_targets.push_back(Simd::off);
  for (const Simd target : all_targets) {
    Settings other = subject.settings;
    other.simd = target;
    other.threads = 1 + below(random, 7);
    const Frame frame = drawn(subject, other);
    seen.push_back(frame.path);
    std::string fault = picture_difference(base, frame, all);
    if (fault.empty()) fault = work_difference(subject, base, frame);
    if (fault.empty() && subject.settings.renderer == Renderer::ray_tracer) {
      other.accelerator = another_accelerator(*subject.scene, subject.settings, random);
      if (other.accelerator != subject.settings.accelerator)
        fault = picture_difference(base, drawn(subject, other), all);
    }
    if (!fault.empty()) return fault + ", with" + changed_settings(other);
  }
  const TileRect region = random_region(subject.view, random);
  const std::string fault = picture_difference(base, drawn(subject, subject.settings, region), region);
  if (!fault.empty())
    return fmt::format("{} in the region {},{} {}x{}", fault, region.x0, region.y0, region.width(), region.height());
  return inspector_fault(subject, base, {below(random, subject.view.width), below(random, subject.view.height)});
}

}  // namespace ps::test
