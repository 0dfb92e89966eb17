#include <fmt/format.h>
#include <gtest/gtest.h>

#include <chrono>

#include "agreement/hardware/agreement_matrix.h"
#include "agreement/hardware/hardware_pair.h"
#include "hardware/gl_thread.h"
#include "options/option.h"
#include "options/scene_settings.h"
#include "scene/load.h"

namespace ps {
namespace {

std::string text_of(const StageSplit& split) {
  std::string text = fmt::format("{} pixels, {} ids, {} colours by {}, edge {:.4f}:", split.whole.pixels, split.whole.ids, split.whole.colours, split.largest, split.edge_distance);
  for (std::size_t i = 1; i < stage_cause_count; ++i)
    if (split.shares[i].pixels > 0) text += fmt::format(" {} {}", stage_cause_label(static_cast<StageCause>(i)), split.shares[i].pixels);
  return text;
}

TEST(HardwareStages, Explore) {
  PS_NEEDS_HARDWARE(hardware);
  for (const test::MatrixRow& row : test::matrix_rows())
    for (const char* snapping : {"cpu", "driver"}) {
      const auto start = std::chrono::steady_clock::now();
      const test::MeasuredRow measured = test::measure(row, hardware, snapping);
      const double s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      fmt::print("{} {}: {} ({:.1f} s)\n", row.name(), snapping, text_of(measured.split), s);
      std::fflush(stdout);
    }
}

TEST(HardwareStages, ExploreRays) {
  PS_NEEDS_HARDWARE(hardware);
  for (const test::RayRow& row : test::ray_rows())
    for (const Renderer renderer : {Renderer::rasterizer, hardware}) {
      const test::RayDifference d = test::against_rays(row, renderer);
      fmt::print("{} {} {}: ids {} colours {} rms {:.3f}\n", row.scene, fmt::join(row.assignments, " "), renderer_label(renderer), d.ids, d.colours, d.rms);
    }
}

struct Planted {
  StageCause cause;
  const char* scene;
  std::vector<std::string> both, other, ours;
};

TEST(HardwareStages, PlantedFaultsAreFound) {
  PS_NEEDS_HARDWARE(hardware);
  const std::vector<Planted> faults{
      {StageCause::coverage, "cgfs/cubes", {"shadows=none"}, {}, {"subpixel-bits=1"}},
      {StageCause::coverage, "cgpp/teapot", {"shadows=none", "lighting=off"}, {}, {"subpixel-bits=0"}},
      {StageCause::coverage, "cgfs/shadows", {}, {"shadows=stencil-depth-fail"}, {"shadows=stencil-depth-fail", "volume-length=1"}},
      {StageCause::depth_tie, "lab/z-fighting", {"depth-format=unorm"}, {"depth-bits=24"}, {"depth-bits=12"}},
      {StageCause::clipping, "cgfs/crates", {"shadows=none"}, {}, {"near=3"}},
      {StageCause::clipping, "cgfs/crates", {"shadows=none"}, {}, {"far=5"}},
      {StageCause::interpolation, "cgfs/crates", {"shadows=none"}, {}, {"interpolation=affine"}},
      {StageCause::interpolation, "cgfs/shading", {"shadows=none"}, {}, {"normals=triangle"}},
      {StageCause::filtering, "cgfs/crates", {"shadows=none"}, {}, {"mip-bias=2"}},
      {StageCause::filtering, "cgfs/fence", {"shadows=none"}, {}, {"texture-filter=bilinear"}},
      {StageCause::filtering, "cgfs/shadows", {"shadows=map"}, {"shadow-map-size=64"}, {}},
      {StageCause::missing_effect, "cgfs/shadows", {}, {"shadows=none"}, {"shadows=map"}},
      {StageCause::missing_effect, "cgfs/shading", {"shadows=none"}, {"specular=off"}, {"specular=on"}},
  };
  for (const Planted& fault : faults) {
    const Scene scene = load_scene(fault.scene);
    StageRequest request;
    request.scene = scene;
    request.view = {scene.camera, 300, 300};
    Settings both = settings_for(scene);
    parse_assignment("vertex-snapping=cpu", both);
    parse_assignment("reflection-depth=0", both);
    for (const auto& a : fault.both) parse_assignment(a, both);
    request.ours = request.other = both;
    for (const auto& a : fault.other) parse_assignment(a, request.other);
    for (const auto& a : fault.ours) parse_assignment(a, request.ours);
    request.other.renderer = hardware;
    request.ours.renderer = Renderer::rasterizer;
    StudyControl control;
    const StageSplit split = split_by_stage(request, control);
    fmt::print("{} {} {}|{}: {}\n", stage_cause_label(fault.cause), fault.scene, fmt::join(fault.other, " "), fmt::join(fault.ours, " "), text_of(split));
  }
}

}  // namespace
}  // namespace ps
