// A fault that is planted in one stage belongs to that stage's cause. Options plant it, in the rasterizer or in the
// hardware renderer, which acts on nothing else.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <set>

#include "agreement/hardware/hardware_pair.h"
#include "options/option.h"
#include "options/scene_settings.h"
#include "scene/load.h"
#include "study/stage_causes.h"

namespace ps {
namespace {

struct PlantedFault {
  StageCause cause;
  const char* scene;
  std::vector<std::string> both, hardware, rasterizer;
};

const std::vector<PlantedFault> faults{
    {StageCause::coverage, "cgfs/cubes", {}, {}, {"subpixel-bits=1"}},
    {StageCause::coverage, "cgpp/teapot", {"lighting=off"}, {}, {"subpixel-bits=2"}},
    {StageCause::coverage, "cgfs/shadows", {"shadows=stencil-depth-fail"}, {}, {"volume-length=1"}},
    {StageCause::depth_tie, "lab/z-fighting", {}, {"depth-bits=24"}, {"depth-bits=12"}},
    {StageCause::clipping, "cgfs/crates", {}, {}, {"far=5"}},
    {StageCause::clipping, "cgfs/crates", {}, {}, {"near=5"}},
    {StageCause::interpolation, "cgfs/crates", {"texture-filter=bilinear"}, {}, {"interpolation=affine"}},
    {StageCause::interpolation, "cgfs/shading", {}, {}, {"normals=triangle"}},
    {StageCause::filtering, "cgfs/crates", {}, {}, {"mip-bias=2"}},
    {StageCause::filtering, "cgfs/fence", {}, {}, {"texture-filter=bilinear"}},
    {StageCause::filtering, "cgfs/shadows", {"shadows=map"}, {"shadow-map-size=64"}, {}},
    {StageCause::missing_effect, "cgfs/shadows", {}, {}, {"shadows=map"}},
    {StageCause::missing_effect, "cgfs/shading", {}, {"specular=off"}, {}},
};

StageRequest request_of(const PlantedFault& fault, Renderer hardware) {
  StageRequest request;
  request.scene = load_scene(fault.scene);
  request.view = {request.scene.camera, 300, 300};
  Settings settings = settings_for(request.scene);
  for (const char* plain : {"vertex-snapping=cpu", "reflection-depth=0", "shadows=none"})
    parse_assignment(plain, settings);
  for (const std::string& assignment : fault.both) parse_assignment(assignment, settings);
  request.ours = request.other = settings;
  for (const std::string& assignment : fault.hardware) parse_assignment(assignment, request.other);
  for (const std::string& assignment : fault.rasterizer) parse_assignment(assignment, request.ours);
  request.other.renderer = hardware;
  request.ours.renderer = renderer_for(PictureWay::fragments);
  return request;
}

std::string shares_text(const StageSplit& split) {
  std::string text;
  for (std::size_t i = 0; i < stage_cause_count; ++i)
    text += fmt::format("{} {}; ", stage_cause_label(static_cast<StageCause>(i)), split.shares[i].pixels);
  return text;
}

TEST(HardwareStages, PlantedFaultsBelongToTheirCause) {
  PS_NEEDS_HARDWARE(hardware);
  std::set<StageCause> planted;
  for (const PlantedFault& fault : faults) {
    planted.insert(fault.cause);
    StudyControl control;
    const StageSplit split = split_by_stage(request_of(fault, hardware), control);
    const std::string name = fmt::format("{} in {} {}{}", stage_cause_label(fault.cause), fault.scene,
                                         fmt::join(fault.hardware, " "), fmt::join(fault.rasterizer, " "));
    fmt::print("{}: {} pixels, {:.1f} %\n", name, split.whole.pixels, 100 * split.part(fault.cause));
    EXPECT_GT(split.whole.pixels, 50) << name << ": hardly a fault";
    EXPECT_GE(split.part(fault.cause), 0.95) << name << ": " << shares_text(split);
    const Image<Rgb8> picture = stage_picture(split);
    long coloured = 0;
    for (const Rgb8& pixel : picture.pixels()) coloured += pixel == stage_cause_colour(fault.cause);
    EXPECT_EQ(coloured, split.share(fault.cause).pixels) << name;
  }
  EXPECT_EQ(planted.size(), stage_cause_count - 2) << "all but none and unexplained";
}

TEST(HardwareStages, NothingDiffersWithoutAFault) {
  PS_NEEDS_HARDWARE(hardware);
  StudyControl control;
  const StageSplit split =
      split_by_stage(request_of({StageCause::none, "cgfs/shading", {}, {}, {}}, hardware), control);
  EXPECT_EQ(split.whole.pixels, 0);
  EXPECT_EQ(split.part(StageCause::coverage), 0);
}

TEST(HardwareStages, AreRefusedForOtherPairs) {
  PS_NEEDS_HARDWARE(hardware);
  const StageRequest request = request_of(faults.front(), hardware);
  const SceneTraits traits = scene_traits(request.scene);
  EXPECT_FALSE(why_no_stages(traits, request.ours, request.other));
  EXPECT_FALSE(why_no_stages(traits, request.other, request.ours));
  EXPECT_TRUE(why_no_stages(traits, request.ours, request.ours));
  EXPECT_TRUE(why_no_stages(traits, request.other, request.other));
  Settings lines = request.other;
  lines.draw = Draw::wireframe;
  EXPECT_EQ(renderer_with_stages(), hardware);
  EXPECT_TRUE(why_no_stages(traits, request.ours, lines));
}

}  // namespace
}  // namespace ps
