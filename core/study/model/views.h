#pragma once
#include <string_view>
#include <vector>

#include "frame/view.h"
#include "scene/scene.h"
#include "study/control.h"

namespace ps {

/// The view and `count` - 1 others at equal steps on a circle around what it looks at, about its own upward axis. What
/// it looks at lies at the middle of all visible depths. Throws Cancelled.
std::vector<View> orbit_views(const Scene& scene, const View& view, int count, StudyControl& control);

/// Views of a list with a camera on each line (parse_camera_text()); empty lines and lines that begin with # do not
/// count. All have the size of `view`. `name` is the list's in messages. Throws InputError.
std::vector<View> parse_views(std::string_view text, std::string_view name, const View& view);

}  // namespace ps
