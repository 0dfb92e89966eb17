#pragma once
#include <string>

#include "gui/work/render_worker.h"

namespace ps::gui {

/// "ray tracer, 3 reflections" or "rasterizer, Phong", then the other options that are not at their defaults. Beside a
/// picture with `other` settings, what differs comes first: "volume-caps = off · rasterizer, Phong".
std::string title_text(const Settings& settings, const SceneTraits& traits, const Settings* other = nullptr);
/// The work in place of a finished picture, or the reason why there is none; empty if neither.
std::string state_text(const RenderStatus& status, const RenderResult* result);
/// All counters that are not 0, one a line.
std::string counters_text(const RenderResult& result);
/// "1,234" up to "99,999", then "1.23 M".
std::string count_text(std::uint64_t count);
/// "0.42", "14.2", "131"
std::string three_digits(double value);
/// "0.42", "14", "130": what a single run is good for.
std::string two_digits(double value);

}  // namespace ps::gui
