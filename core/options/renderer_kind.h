#pragma once
#include <string_view>

#include "options/settings.h"

namespace ps {

/// How a renderer goes about a picture. What lies above the renderers asks for this and never for one of them by name,
/// so that another renderer needs no change there.
enum class PictureWay {
  rays,       ///< which surface does the ray of a pixel meet first?
  fragments,  ///< which pixels does a triangle cover?
  listing     ///< as the listing of a lesson does, line by line
};

PictureWay picture_way(Renderer renderer);

/// Its name for people: "ray tracer".
std::string_view renderer_label(Renderer renderer);

inline bool sends_rays(Renderer renderer) { return picture_way(renderer) == PictureWay::rays; }
inline bool draws_fragments(Renderer renderer) { return picture_way(renderer) == PictureWay::fragments; }
inline bool runs_listing(Renderer renderer) { return picture_way(renderer) == PictureWay::listing; }

}  // namespace ps
