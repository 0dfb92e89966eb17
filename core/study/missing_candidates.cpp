#include "study/missing_candidates.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "options/difference_words.h"
#include "options/option.h"
#include "options/renderer_kind.h"
#include "render/story/names.h"
#include "study/features.h"

namespace ps {
namespace {

constexpr std::size_t most_objects = 24;  // left out one by one; a scene of more is seldom typed in

/// Options that only decide how exactly or how fast the same picture is made, or which cannot be meant by a file.
constexpr std::array<std::string_view, 26> not_seen{"listing",
                                                    "listing-bug",
                                                    "demo-slips",
                                                    "camera-relative",
                                                    "sample-pattern",
                                                    "adaptive-sampling",
                                                    "depth-format",
                                                    "depth-reversed",
                                                    "early-depth",
                                                    "deferred-shading",
                                                    "light-passes",
                                                    "canvas-fill",
                                                    "coverage",
                                                    "edge-arithmetic",
                                                    "vertex-snapping",
                                                    "line-algorithm",
                                                    "patches",
                                                    "volume-caps",
                                                    "sphere-test",
                                                    "triangle-test",
                                                    "volume-depth-clamp",
                                                    "hardware-texturing",
                                                    "self-hit",
                                                    "epsilon-unit",
                                                    "light-shown",
                                                    "environment-objects"};

/// Numbers that programs are seen to use, and not a range to search.
struct SeenNumbers {
  std::string_view option;
  std::array<double, 4> values;
};
constexpr std::array<SeenNumbers, 6> seen_numbers{{{"reflection-depth", {0, 1, 2, 3}},
                                                   {"samples-per-pixel", {1, 4, 9, 16}},
                                                   {"multisampling", {1, 2, 4, 8}},
                                                   {"subpixel-bits", {0, 4, 8, 8}},
                                                   {"gamma", {1, 2, 2.2, 2.4}},
                                                   {"exposure", {0.5, 1, 2, 2}}}};

/// Whether the choice is a renderer that is not tried: one that a program adds draws with the machine's own driver, and
/// not the same picture everywhere; a listing brings its own conventions, which are tried one by one.
bool is_left_out(const Option& option, const Choice& choice) {
  return option.key == "renderer" &&
         std::any_of(renderer_kinds().begin(), renderer_kinds().end(), [&](const RendererKind& kind) {
           return kind.key == choice.key && (kind.added || kind.way == PictureWay::listing);
         });
}

class CandidateList {
 public:
  CandidateList(const Scene& scene, const Settings& settings)
      : scene_(scene), settings_(settings), traits_(scene_traits(scene)) {}

  std::vector<MissingCandidate> run() {
    for (const Feature& feature : features())
      if (!unused_reason(feature, settings_, traits_)) set(*find_option(feature.option), feature.off);
    lights();
    objects();
    for (const Option& option : option_table()) values_of(option);
    background();
    sample_places();
    stored();
    return std::move(list_);
  }

 private:
  void add(MissingCandidate candidate) {
    const auto same = [&](const MissingCandidate& other) { return other.key == candidate.key; };
    if (std::none_of(list_.begin(), list_.end(), same)) list_.push_back(std::move(candidate));
  }

  void set(const Option& option, std::string_view value) {
    Settings then = settings_;
    parse_option(option, value, then);
    if (then == settings_) return;
    const std::string key = fmt::format("{}={}", option.key, value);
    std::string words = "with " + setting_words(key);
    for (const Feature& feature : features())
      if (feature.option == option.key && feature.off == value) words = fmt::format("without {}", feature.noun);
    add({key, words, std::string(option.key), false,
         [row = &option, number = option.get(then)](PictureRecipe& recipe) { row->set(recipe.settings, number); }});
  }

  void values_of(const Option& option) {
    if (option.effect == OptionEffect::speed || option.truth.kind == TruthKind::as_set) return;
    if (std::find(not_seen.begin(), not_seen.end(), option.key) != not_seen.end()) return;
    if (inactive_reason(option, settings_, traits_)) return;
    switch (option.kind) {
    case OptionKind::boolean:
      return set(option, option.get(settings_) != 0 ? "off" : "on");
    case OptionKind::choice:
      for (const Choice& choice : option.choices)
        if (!is_left_out(option, choice) && !inactive_choice_reason(option, choice, settings_, traits_))
          set(option, choice.key);
      return;
    case OptionKind::integer:
    case OptionKind::real:
      for (const SeenNumbers& numbers : seen_numbers)
        if (numbers.option == option.key)
          for (const double value : numbers.values) set(option, fmt::format("{}", value));
      return;
    }
  }

  void lights() {
    for (std::size_t i = 0; i < traits_.light_count; ++i) {
      if (!shines(traits_, i)) continue;
      const std::string name = light_name(scene_, static_cast<int>(i)), subject = fmt::format("light.{}", i);
      const auto times = [i](double factor) {
        return [i, factor](PictureRecipe& recipe) {
          recipe.scene.lights.edit([&](std::vector<Light>& lights) { lights[i].intensity *= factor; });
        };
      };
      add({subject + "=off", "without " + name, subject, false, times(0)});
      add({subject + "=twice", fmt::format("with {} twice", name), subject, false, times(2)});
    }
    if (traits_.casting_lights && !traits_.textures && settings_.lighting)
      add({"diffuse=off", "without diffuse light", "diffuse", false, [](PictureRecipe& recipe) {
             recipe.scene.materials.edit([](std::vector<Material>& materials) {
               for (Material& material : materials) {
                 if (!material.specular_colour) material.specular_colour = material.colour;
                 if (!material.ambient_colour) material.ambient_colour = material.colour;
                 material.colour = Vec3d(0);
               }
             });
           }});
  }

  void objects() {
    const std::size_t count = scene_.geometry->objects.size();
    if (count < 2 || count > most_objects) return;
    for (std::size_t i = 0; i < count; ++i)
      add({fmt::format("object.{}=off", i), "without " + object_name(scene_, static_cast<int>(i)),
           fmt::format("object.{}", i), false, [name = scene_.geometry->objects[i]](PictureRecipe& recipe) {
             recipe.scene.geometry.edit([&](Geometry& geometry) {
               const auto found = std::find(geometry.objects.begin(), geometry.objects.end(), name);
               if (found != geometry.objects.end()) geometry.objects.erase(found);
             });
           }});
  }

  void background() {
    for (const auto& [name, value] : {std::pair{"black", 0.0}, std::pair{"white", 1.0}})
      if (scene_.background != Vec3d(value))
        add({fmt::format("background={}", name), fmt::format("with a {} background", name), "background", false,
             [colour = Vec3d(value)](PictureRecipe& recipe) { recipe.scene.background = colour; }});
  }

  /// The option knows the centre and the lower left corner; the other corners are those of the neighbours.
  void sample_places() {
    const auto corner = [&](const char* name, Vec2i shift) {
      add({fmt::format("sample={}", name), fmt::format("sampled at the {} corner of each pixel", name),
           "sample-position", false, [shift](PictureRecipe& recipe) {
             recipe.settings.sample_position = SamplePosition::corner;
             recipe.form.shift = shift;
           }});
    };
    corner("top-left", {0, 1});
    corner("top-right", {-1, 1});
    corner("bottom-right", {-1, 0});
    const auto moved = [&](const char* name, Vec2i shift) {
      add({fmt::format("shift={}", name), fmt::format("one pixel further {}", name), "shift", true,
           [shift](PictureRecipe& recipe) { recipe.form.shift = shift; }});
    };
    moved("right", {1, 0});
    moved("left", {-1, 0});
    moved("down", {0, 1});
    moved("up", {0, -1});
  }

  void stored() {
    const auto rounded = [&](const char* name, const char* words, StoredRounding rounding) {
      add({fmt::format("stored={}", name), words, "stored", true,
           [rounding](PictureRecipe& recipe) { recipe.form.rounding = rounding; }});
    };
    if (settings_.colour_depth == ColourDepth::bits24) {
      rounded("truncated", "with levels truncated, not rounded", StoredRounding::truncated);
      rounded("half-up", "with levels rounded half up", StoredRounding::half_up);
      rounded("of-256", "with levels of 256 v, truncated", StoredRounding::of_256);
      rounded("wrapped", "with levels that are not clamped (256 is stored as 0)", StoredRounding::wrapped);
      rounded("srgb", "with the curve of sRGB", StoredRounding::srgb_curve);
    }
    const auto turned = [&](const char* name, const char* words, void (*turn)(StoredForm&)) {
      add({fmt::format("stored={}", name), words, name, true, [turn](PictureRecipe& recipe) { turn(recipe.form); }});
    };
    turned("upside-down", "upside down", [](StoredForm& form) { form.upside_down = true; });
    turned("mirrored", "mirrored left to right", [](StoredForm& form) { form.mirrored = true; });
    turned("rotated", "turned by 180 degrees", [](StoredForm& form) { form.upside_down = form.mirrored = true; });
    turned("red-as-blue", "with red and blue exchanged", [](StoredForm& form) { form.red_as_blue = true; });
  }

  const Scene& scene_;
  const Settings& settings_;
  const SceneTraits traits_;
  std::vector<MissingCandidate> list_;
};

}  // namespace

std::vector<MissingCandidate> missing_candidates(const Scene& scene, const Settings& settings) {
  return CandidateList(scene, settings).run();
}

}  // namespace ps
