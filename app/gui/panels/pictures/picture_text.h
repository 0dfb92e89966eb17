#pragma once
#include <string>

#include "gui/work/render_worker.h"

namespace ps::gui {

/// "ray tracer, 3 reflections" or "rasterizer, Phong", then the other options that are not at their defaults. Beside a
/// picture with `other` settings, what differs comes first: "volume-caps = off · rasterizer, Phong".
std::string title_text(const Settings& settings, const SceneTraits& traits, const Settings* other = nullptr);
/// "14.2 ms    1.2 M rays" or what is going on instead.
std::string footer_text(const RenderStatus& status, const RenderResult* result);
/// All counters that are not 0, one a line.
std::string counters_text(const RenderResult& result);
/// "1,234" up to "99,999", then "1.23 M".
std::string count_text(std::uint64_t count);
/// "0.42 ms", "14.2 ms", "1.31 s"
std::string time_text(double milliseconds);

}  // namespace ps::gui
