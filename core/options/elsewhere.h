#pragma once
#include <initializer_list>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include "options/fast_limits.h"
#include "options/idle_reason.h"
#include "options/renderer_kind.h"
#include "options/settings.h"

namespace ps {

/// In a row: no renderer of fragments uses the option.
struct NotAsked {};
/// In a row: there is none.
struct NoExperiment {};

/// How the hardware renderer takes an option.
struct HardwareUse {
  HardwareUse() = delete;
  HardwareUse(AnyValue) {}
  HardwareUse(NotAsked) : asked(false) {}

  bool asked = true;
  std::string_view definition{};  ///< by this name the shaders know its value: "#define RENORMALISE 1"; may be empty
  std::string_view reason{};      ///< why it lacks values
  OptionNumber first_lacked = std::numeric_limits<OptionNumber>::infinity();
  OptionNumber last_lacked = -std::numeric_limits<OptionNumber>::infinity();
  bool as_driver_offers = false;  ///< the driver is asked which values it lacks (hardware/lacks.cpp)
  /// Why it lacks the value together with other settings, or nullopt. May be nullptr.
  std::optional<IdleReason> (*lacks)(OptionNumber, const Settings&) = nullptr;

  /// Does it not act on the option at all?
  bool lacks_all() const { return first_lacked == -std::numeric_limits<OptionNumber>::infinity(); }
};

/// The code that knows an option. The scalar code of the renderers for which it acts knows it whole.
struct KnownTo {
  FastLimits fast;       ///< SIMD
  HardwareUse hardware;  ///< the hardware renderer
};

/// An experiment about an option (study/stability).
struct OptionExperiment {
  std::string_view key;
  bool (*unsafe)(const Settings&) = nullptr;  ///< does the option leave the experiment's safe window? nullptr: never
  std::string_view safe{};                    ///< settings that bring it back, "KEY=VALUE;KEY=VALUE"
  std::string_view probe{};  ///< set while its effect is measured, so that only what this option does is seen
};

struct OptionExperiments {
  OptionExperiments() = delete;
  OptionExperiments(NoExperiment) {}
  OptionExperiments(std::initializer_list<OptionExperiment> all) : list(all) {}
  std::vector<OptionExperiment> list{};
};

/// A scene in which values of an option differ, by the picture or by what is counted.
struct SeenScene {
  std::string_view scene;       ///< a built-in scene; "FOLDER/NAME.scene" of a lesson, "NAME.scene" in tests/support
  std::string_view settings{};  ///< to the scene's own, "KEY=VALUE;KEY=VALUE"
  /// The way in which its picture is made; none: the scene's own or, if that does not use the option, one that does.
  std::optional<PictureWay> way{};
};

/// In one of the scenes or another, any two values differ.
struct SeenScenes {
  SeenScenes() = delete;
  SeenScenes(std::initializer_list<SeenScene> all) : list(all) {}
  std::vector<SeenScene> list{};
};

/// Where an option is seen to act, and to fail.
struct ShownBy {
  OptionExperiments experiments;
  SeenScenes scenes;  ///< of the tests
};

}  // namespace ps
