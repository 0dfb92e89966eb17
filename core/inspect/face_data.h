#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "record/event_fields.h"
#include "record/story.h"
#include "scene/scene.h"

namespace ps {

/// A vertex of a triangle with its normal and texture coordinates.
struct FaceCorner {
  int vertex = 0;               ///< index into Mesh::positions
  std::optional<Vec3d> normal;  ///< world space, length 1, taken there by the inverse transpose
  std::optional<Vec2d> uv;      ///< v = 0 is the top row of a picture
  bool faces_away = false;      ///< the normal points to the back of the triangle
};

/// A triangle of a model: its names and its line in the model's file, and what its vertices carry.
struct FaceData {
  std::string object, group, material;  ///< as the file names them; each may be empty
  std::string file;                     ///< empty for models that come from no file of their own
  int line = 0;                         ///< of its face (`f`), from 1; 0 = none
  std::array<FaceCorner, 3> corners;
};

/// nullopt for other things than triangles of models, and for models of curved patches, which renderers cut anew.
std::optional<FaceData> face_data(const Scene& scene, const PixelId& id);

/// A face with the barycentric weights of a point on it.
struct FacePoint {
  FaceData face;
  std::array<double, 3> weights{};
};

/// The point that a hit or a fragment is about; nullopt for other events and where there is no face_data().
std::optional<FacePoint> face_point(const EventData& event, const Scene& scene);

/// The values that renderers interpolate between the vertices, in world space with length 1; nullopt where vertices
/// have none, or where theirs cancel.
std::optional<Vec3d> normal_at(const FacePoint& point);
std::optional<Vec2d> uv_at(const FacePoint& point);

/// "Head, material skin, line 812 of robot.obj"; empty for a face without all of these.
std::string origin_text(const FaceData& face);
/// "the normals of vertices 0 and 2 face away from their face"; empty where none does.
std::string facing_text(const FaceData& face);
/// Both, with "; " between them where there are both.
std::string face_words(const FaceData& face);

/// The fields of an event (record/event_fields.h). A hit or a fragment on a model has those of its face behind them:
/// names, line, the normals and texture coordinates of the vertices, and for a fragment those of the point.
std::vector<EventField> event_fields(const EventData& event, const Scene& scene);

}  // namespace ps
