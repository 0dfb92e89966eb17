#include "support/option_contexts.h"

#include <algorithm>

#include "base/resources.h"
#include "frame/display_frame.h"
#include "options/listing.h"
#include "options/renderer_kind.h"
#include "options/scene_settings.h"
#include "render/render.h"
#include "scene/load.h"

namespace ps::test {
namespace {

std::string lesson_scene(const char* lesson, const char* name) { return (chapter_dir() / lesson / name).string(); }

Outcome outcome(const Scene& scene, int width, int height, const Settings& settings, Prepared& prepared) {
  Progress progress;
  const Frame frame = render(scene, {scene.camera, width, height}, settings, {}, prepared, progress);
  return {display_frame(frame, settings), frame.counters};
}

std::vector<double> other_values(const Option& option, const Settings& settings) {
  const double now = option.get(settings);
  std::vector<double> values = values_of(option);
  if (option.kind == OptionKind::integer || option.kind == OptionKind::real)
    values.insert(values.begin(), std::clamp(now * 2 + 1, option.minimum, option.maximum));
  std::erase(values, now);
  return values;
}

}  // namespace

std::vector<OptionNumber> values_of(const Option& option) {
  std::vector<OptionNumber> values;
  switch (option.kind) {
  case OptionKind::boolean:
    return {0, 1};
  case OptionKind::choice:
    for (std::size_t i = 0; i < option.choices.size(); ++i) values.push_back(static_cast<OptionNumber>(i));
    return values;
  case OptionKind::integer:
  case OptionKind::real:
    break;
  }
  return {option.minimum, option.maximum};
}

bool has_renderer(std::string_view key) {
  for (const RendererKind& kind : renderer_kinds())
    if (kind.key == key) return !kind.inactive || !kind.inactive(Settings{}, SceneTraits{});
  return false;
}

// An option that nobody reads although all renderers are here is a mistake, and no excuse.
bool lacks_its_renderer(const Option& option) {
  if (has_renderer("hardware") || option.acts_for != ActsFor::readers) return false;
  const auto all = listings();
  return std::none_of(all.begin(), all.end(), [&](const NamedListing& one) { return listing_reads(one, option.key); });
}

const std::vector<OptionContext>& option_contexts() {
  static const std::vector<OptionContext> all = [] {
    std::vector<OptionContext> contexts{
        {"cgfs/reflections", {}},
        {"cgfs/reflections", {"renderer=rasterizer"}},
        {"cgfs/reflections", {"self-hit=epsilon"}},
        {"cgfs/reflections", {"self-hit=epsilon", "shadow-epsilon=0.1"}},
        {"cgfs/shading", {"renderer=rasterizer"}},
        {"cgfs/shading", {"triangle-test=moeller-trumbore"}},
        {"cgfs/shading", {"triangle-test=moeller-trumbore", "triangle-epsilon=1"}},
        {"cgfs/crates", {"renderer=rasterizer"}},
        {"cgfs/depth", {"renderer=rasterizer"}},
        {"cgfs/depth", {"renderer=rasterizer", "subpixel-bits=12"}},
        {"lab/depth-complexity", {}},
        {"lab/far-origin", {}},
        {"lab/z-fighting", {}},
        {"lab/z-fighting", {"depth-format=unit-float"}},
        {"cgfs/lines", {"renderer=rasterizer"}},
        {"cgfs/wireframe", {"renderer=rasterizer"}},
        {"cgfs/reflections", {"samples-per-pixel=4"}},
        {"cgfs/reflections", {"samples-per-pixel=4", "adaptive-sampling=on"}},
        {"cgfs/brick-wall", {}},
        {"cgfs/relief", {"parallax-mapping=steep"}},
        {"cgpp/teapot", {"renderer=rasterizer", "tessellation=20"}},
        {"octree/attenuation", {}},
        {"cgfs/magnifying-glass", {}},
        {"lab/flattened", {"renderer=rasterizer"}},
        {"cgfs/cubes", {"renderer=rasterizer", "subpixel-bits=0"}},
        {"cgfs/reflections", {"accelerator=octree", "octree-leaf=1"}},
        {"cgfs/shadows", {"renderer=rasterizer", "shadows=map", "shadow-map-size=64"}},
        {"cgfs/shadows", {"renderer=rasterizer", "shadows=stencil-depth-fail", "far=7"}},
        {"lab/stacked-shadows", {}},
        {"lab/mirror-room", {"environment-size=32"}},
        {"cgfs/reflections", {"renderer=textbook"}},
        {"cgfs/shading", {"renderer=textbook"}},
        {lesson_scene("cgfs_14_textures", "floor.scene"), {"renderer=rasterizer"}},
        {lesson_scene("cgfs_14_textures", "closeup.scene"), {"renderer=rasterizer", "texture-filter=bilinear"}},
        {"cgfs/triangles", {"renderer=textbook"}},
        {"cgfs/shaded-triangle", {"renderer=textbook"}},
        {"cgfs/crates", {"renderer=textbook"}},
        {"cgfs/shading", {"accelerator=octree"}},
        {"cgfs/behind", {"renderer=rasterizer", "subpixel-bits=12", "clipping=near"}},
        {"lab/depth-complexity", {"subpixel-bits=12"}},
        {"lab/polygons", {}},
        {"cgfs/spheres", {"renderer=textbook"}},
        {"cgfs/lights", {"renderer=textbook"}},
        {lesson_scene("cgfs_06_lines", "ends.scene"), {"renderer=textbook"}},
        {lesson_scene("cgfs_07_filled_triangles", "square.scene"), {"renderer=textbook"}},
        {"cgfs/cubes", {"renderer=textbook", "listing=cgfs-10-scenes"}},
        {"cgfs/depth", {"renderer=textbook", "backface-culling=on"}},
        {"cgfs/depth", {"renderer=textbook", "backface-culling=off"}},
        {lesson_scene("cgfs_11_clipping", "two.scene"), {"renderer=textbook", "listing=cgfs-11-clipping"}},
        {lesson_scene("cgfs_15_shadows_in_the_rasterizer", "yard.scene"), {"renderer=textbook"}},
        {"cgpp/ground", {"renderer=textbook", "listing=cgpp-15-4-measured-light"}},
        {lesson_scene("cgpp_15_6_exact_edges", "fan.scene"), {"renderer=textbook", "listing=cgpp-15-6-exact-edges"}},
        {"lab/polygon-rows", {"renderer=textbook", "listing=lab-cornell"}},
        {"cgfs/cubes", {"renderer=textbook", "listing=oct-dont-test-everything"}},
        {PIXELSCOPE_TEST_DIR "/support/sixteen_lights.scene", {}},
    };
    if (has_renderer("hardware")) contexts.push_back({"cgfs/crates", {"renderer=hardware"}});
    return contexts;
  }();
  return all;
}

struct OptionResponses::Loaded {
  Scene scene;
  Settings settings;
  Prepared prepared;
  std::optional<Outcome> before;
};

OptionResponses::OptionResponses(int width, int height) : width_(width), height_(height) {
  for (const OptionContext& context : option_contexts()) {
    auto loaded = std::make_unique<Loaded>();
    loaded->scene = load_scene(context.scene);
    loaded->settings = settings_for(loaded->scene);
    for (const std::string& assignment : context.assignments) parse_assignment(assignment, loaded->settings);
    loaded_.push_back(std::move(loaded));
  }
}

OptionResponses::~OptionResponses() = default;

const Settings& OptionResponses::settings(std::size_t context) const { return loaded_[context]->settings; }

const Outcome& OptionResponses::unchanged(std::size_t context) {
  Loaded& my = *loaded_[context];
  if (!my.before) my.before = outcome(my.scene, width_, height_, my.settings, my.prepared);
  return *my.before;
}

std::optional<OptionResponse> OptionResponses::find_in(std::size_t context, const Option& option, bool pictures_only) {
  Loaded& my = *loaded_[context];
  if (inactive_reason(option, my.settings, scene_traits(my.scene))) return {};
  const Outcome& before = unchanged(context);
  for (const double value : other_values(option, my.settings)) {
    Settings changed = my.settings;
    option.set(changed, value);
    Outcome after = outcome(my.scene, width_, height_, changed, my.prepared);
    if (pictures_only ? after.picture != before.picture : after != before)
      return OptionResponse{context, option_text(option, changed), before, std::move(after)};
  }
  return {};
}

std::optional<OptionResponse> OptionResponses::find(const Option& option) {
  for (const bool pictures_only : {true, false})
    for (std::size_t context = 0; context < loaded_.size(); ++context)
      if (auto response = find_in(context, option, pictures_only)) return response;
  return {};
}

std::vector<AlikeValues> OptionResponses::alike(const Option& option, const std::vector<OptionNumber>& values) {
  const std::size_t count = values.size();
  std::vector<std::vector<bool>> apart(count, std::vector<bool>(count, false));
  for (const std::unique_ptr<Loaded>& loaded : loaded_) {
    const SceneTraits traits = scene_traits(loaded->scene);
    if (inactive_reason(option, loaded->settings, traits)) continue;
    std::vector<std::optional<Outcome>> outcomes(count);
    for (std::size_t i = 0; i < count; ++i) {
      const bool is_settled = std::count(apart[i].begin(), apart[i].end(), false) == 1;  // but for the value itself
      Settings changed = loaded->settings;
      option.set(changed, values[i]);
      if (is_settled || inactive_value_reason(option, changed, traits)) continue;
      outcomes[i] = outcome(loaded->scene, width_, height_, changed, loaded->prepared);
    }
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t j = 0; j < count; ++j)
        if (outcomes[i] && outcomes[j] && *outcomes[i] != *outcomes[j]) apart[i][j] = true;
  }
  std::vector<AlikeValues> pairs;
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = i + 1; j < count; ++j)
      if (!apart[i][j]) pairs.push_back({values[i], values[j]});
  return pairs;
}

}  // namespace ps::test
