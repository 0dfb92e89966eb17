#pragma once
#include "frame/view.h"
#include "image/image.h"
#include "options/settings.h"

namespace ps {

/// For each pixel the direction from the eye through its sample position, in world space, of unit length: what an eye
/// ray would follow (CGPP 15.4.1.2), for renderers that have none.
Image<Vec3f> eye_directions(const View& view, const Settings& settings);

}  // namespace ps
