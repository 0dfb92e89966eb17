#pragma once
#include <string>

#include "gui/work/render_worker.h"

namespace ps::gui {

/// The words over a picture.
struct PictureTitle {
  std::string differing;  ///< from the other picture: "shading: flat"; alone or where both are equal all that there is
  std::string brief;      ///< the same as values alone: "flat"
  std::string shared;     ///< with the other picture: "rasterizer"
  std::string text() const;  ///< "shading: flat · rasterizer"
};
/// "ray tracer, 3 reflections" or "rasterizer, Phong", then the other options that are not at their defaults. `other`:
/// the settings of the picture beside it, nullptr = none.
PictureTitle picture_title_words(const Settings& settings, const SceneTraits& traits, const Settings* other = nullptr);
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
