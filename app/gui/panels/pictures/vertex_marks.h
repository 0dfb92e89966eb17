#pragma once
#include <array>
#include <string>
#include <vector>

#include "gui/panels/pictures/picture_transform.h"
#include "gui/session/session.h"
#include "inspect/vertex_chain.h"

namespace ps::gui {

/// Where the vertices of models are projected to, over the picture: a switch, and what it found last for each side.
struct VertexMarks {
  bool on = false;
  struct Found {
    std::string of;  ///< scene, view and settings that it holds for
    std::vector<ProjectedVertex> vertices;
  };
  std::array<Found, 2> found;
};

/// Marks each projected vertex (CGPP 15.6.2), also those that the picture hides; in large pixels with number, place and
/// depth, while few are in sight. `clip` is the part of the area that shows this side. Published as "a/vertices" (how
/// many); those with numbers are recorded as "view/a/vertex/OBJECT.NUMBER".
void draw_vertex_marks(const Session& session, VertexMarks& marks, Side side, const PictureTransform& transform,
                       const Area& area, const Area& clip);

}  // namespace ps::gui
