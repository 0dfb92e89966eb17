#pragma once
#include <memory>
#include <string>

#include "frame/prepared.h"
#include "frame/view.h"
#include "options/settings.h"
#include "record/shader_listing.h"
#include "scene/scene.h"

namespace ps::hardware {

/// For the renderer's row (record/renderer_row.h): the shaders that draw the triangle at the centre of a pixel, in a
/// picture without further channels. Throws as render_hardware() does.
std::shared_ptr<const ShaderListing> list_shaders(const Scene& scene, const View& view, const Settings& settings,
                                                  Vec2i pixel, Prepared& prepared, Progress& progress);

/// Compiles all programs that are kept from the files as they are on disk now, and takes all or none of them. Gives the
/// compiler's first message where one does not compile.
std::string reload_shaders();

}  // namespace ps::hardware
