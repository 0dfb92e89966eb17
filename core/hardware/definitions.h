#pragma once
#include <string>

#include "hardware/picture_plan.h"

namespace ps::hardware {

/// What a program is for.
enum class ProgramUse {
  picture,
  story  ///< reports what the picture's program computes, page by page (story.glsl)
};

/// What the shaders of a surface must know when they are compiled, as lines "#define NAME VALUE".
std::string definitions(const PicturePlan& plan, const raster::Surface<float>& surface, bool clip_control,
                        ProgramUse use = ProgramUse::picture);

/// The same for the faces of shadow volumes.
std::string volume_definitions(const PicturePlan& plan, bool clip_control, ProgramUse use = ProgramUse::picture);

/// The same for deferred.glsl, which shades all surfaces at once.
std::string deferred_definitions(const PicturePlan& plan, bool clip_control, ProgramUse use = ProgramUse::picture);

/// Surfaces in a row of the table that deferred.glsl reads.
inline constexpr int surface_table_columns = 512;

}  // namespace ps::hardware
