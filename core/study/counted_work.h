#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "base/counters.h"
#include "options/settings.h"
#include "scene/scene.h"

namespace ps {

/// Counted work: rays, tests of boxes, primitives and samples, fragments, and reads of textures and maps. nullopt if
/// the renderer counts none of them.
std::optional<std::uint64_t> counted_work(const Counters& counters);

/// The count, or "none".
std::string work_text(const std::optional<std::uint64_t>& work);

/// The settings that draw the same picture with counts that are the same on every processor. SIMD searches visit a tree
/// of their own, as wide as the processor's vectors; all other paths count what scalar code does.
Settings counted_settings(const Settings& settings, const SceneTraits& traits);

}  // namespace ps
