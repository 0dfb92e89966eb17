#pragma once
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "options/option.h"
#include "scene/scene.h"

namespace ps {

/// One option with the values that a sweep gives it.
struct SweepAxis {
  const Option* option = nullptr;
  std::vector<std::string> values;  ///< as option_text() writes them
};

/// Reads "KEY=V1,V2.." or "KEY", which means standard_values(). Throws InputError for an unknown key and a value
/// that the option cannot have, and for the same value twice.
SweepAxis parse_sweep_axis(std::string_view text);

/// All values of a toggle or a choice; of a number at most eight, spread over its range as its scale says.
std::vector<std::string> standard_values(const Option& option);

/// A sweep worth making, for menus and for `--sweep NAME`.
struct NamedSweep {
  std::string_view key;    ///< "accelerators"
  std::string_view label;  ///< "Accelerators"
  std::vector<std::string> axes;
};
std::span<const NamedSweep> named_sweeps();
/// The axes of a named sweep, without renderers that this machine cannot run, or the one axis that `text` describes.
std::vector<SweepAxis> parse_sweep(std::string_view text);

/// The sweep over the model in place of options, from full to reduced (study/model/model_sweep.h); it has no axes.
inline constexpr std::string_view model_sweep_key = "needs";

/// The key of the named sweep with these axes, otherwise all axes as text: "shading=phong,flat;textures=on,off", or
/// "none".
std::string sweep_text(std::span<const SweepAxis> axes);
/// The axes that sweep_text() wrote; none for the model's sweep. Throws InputError like parse_sweep().
std::vector<SweepAxis> parse_sweep_text(std::string_view text);

/// One point of a sweep before it is measured.
struct SweepPoint {
  std::string label;     ///< what sets it apart from the others, by keys: "rasterizer, gouraud"
  std::string name;      ///< the same for people: "rasterizer, Gouraud", or "Samples per pixel: 16"
  std::string settings;  ///< the swept options and what else differs from the scene's settings: "K=V;K=V"
  Settings value;
  std::shared_ptr<const Scene> scene{};  ///< in place of the chart's own, where the model varies; nullptr: that one
};

/// The product of all axes over `base`. With several axes, an option that cannot act in a combination ("only the
/// rasterizer uses it") keeps its value in `base` there, and of combinations that become equal the first is kept.
/// `scene_start` is settings_for(scene): together with `settings` it reproduces a point. Without axes: `base` alone.
std::vector<SweepPoint> sweep_points(std::span<const SweepAxis> axes, const Settings& base, const Settings& scene_start,
                                     const SceneTraits& traits);

/// The part that all names begin with, up to a colon, and what is left of each: "Samples per pixel", and "1", "4",
/// "16".
struct SweepNames {
  std::string common;              ///< empty if the names have no such part
  std::vector<std::string> parts;  ///< in the order of the names
};
SweepNames split_names(const std::vector<std::string>& names);

/// Why one of the axes acts nowhere in the sweep, in a whole sentence; nullopt if it acts somewhere.
std::optional<std::string> idle_axis(const SweepAxis& axis, std::span<const SweepAxis> axes, const Settings& base,
                                     const SceneTraits& traits);
/// Why none of `own` acts anywhere in a sweep over `axes`: the first one's sentence. nullopt where one acts, or there
/// is none.
std::optional<std::string> idle_axes_all(std::span<const SweepAxis> own, std::span<const SweepAxis> axes,
                                         const Settings& base, const SceneTraits& traits);
/// Swept options that act nowhere in the sweep, each with its reason, in whole sentences.
std::vector<std::string> idle_axes(std::span<const SweepAxis> axes, const Settings& base, const SceneTraits& traits);
/// Why a named sweep changes nothing with these settings and this scene ("needs a texture"), or nullopt if it does:
/// none of its options can act. A renderer that it also sweeps does not count.
std::optional<std::string> idle_sweep(const NamedSweep& sweep, const Settings& base, const SceneTraits& traits);

}  // namespace ps
