#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "frame/view.h"
#include "inspect/space_model.h"
#include "record/story.h"
#include "scene/scene.h"

/// The way of one vertex through the spaces: model, world, camera, clip, viewport, canvas (CGFS ch. 9 to 11).

namespace ps {

/// A vertex of an instance's mesh.
struct VertexId {
  int object = 0;  ///< index into Geometry::objects; must be an Instance
  int vertex = 0;  ///< index into Mesh::positions
  bool operator==(const VertexId&) const = default;
};

/// Which of the two comes first on the way from model to world. The renderers turn first; the other way round the
/// translation is turned as well, and the model lands elsewhere.
enum class ModelOrder { turn_then_move, move_then_turn };

/// Steps that are tried out, without a change of scene or settings.
struct VertexEdits {
  ModelOrder order = ModelOrder::turn_then_move;
  std::optional<double> near;  ///< in place of the option's, in units of projection_plane_d
  bool operator==(const VertexEdits&) const = default;
};

/// How far a vertex lies in front of a clipping plane, in world units; negative = it is cut away.
struct PlaneDistance {
  std::string_view plane;  ///< "near plane", "left plane", ...
  double distance = 0;
};

struct VertexChain {
  VertexId id;
  std::string object_name;
  Vec3d model{0, 0, 0}, world{0, 0, 0}, camera{0, 0, 0};
  /// The factors of the way to the world, and their product in the order that was asked for.
  Mat4d scale{1.0}, rotation{1.0}, translation{1.0}, to_world{1.0};
  Mat4d to_camera{1.0};  ///< world to camera: minus the position, then along right, up, forward
  Mat4d to_clip{1.0};    ///< camera to clip space; x and y of a clip point, divided by its w, are centred pixels
  Vec4d clip{0, 0, 0, 1};
  std::vector<PlaneDistance> planes;
  bool inside = true;    ///< of all clipping planes
  Vec2d viewport{0, 0};  ///< on the projection plane, world units from its centre
  Vec2d centred{0, 0};   ///< canvas, pixels from the centre, y up
  Vec2d canvas{0, 0};    ///< pixels from the top left, y down
};

/// Follows the vertex with the rasterizer's own camera space, projection and clipping planes, in the precision of the
/// settings. Throws InputError for a vertex that there is not.
VertexChain vertex_chain(const Scene& scene, const View& view, const Settings& settings, const VertexId& id,
                         const VertexEdits& edits = {});

/// The vertex that is seen nearest to a place on the canvas (pixels from the top left) among all in front of the
/// camera, or among the vertices of `triangle` where that is a triangle of a model. Of equals the one nearer to the
/// eye, then the first. nullopt in a scene without models.
std::optional<VertexId> nearest_vertex(const Scene& scene, const View& view, const Settings& settings,
                                       const Vec2d& place, const PixelId& triangle = {});

/// A vertex on the canvas.
struct ProjectedVertex {
  VertexId id;
  Vec2d canvas{0, 0};  ///< pixels from the top left
  double z = 0;        ///< camera space
};

/// The vertices of all models whose projections lie within the picture, object by object, whatever hides them (CGPP
/// 15.6.2): a test of the projection. None behind the near limit; at most `most`, the first ones.
std::vector<ProjectedVertex> projected_vertices(const Scene& scene, const View& view, const Settings& settings,
                                                std::size_t most);

/// The event that gave the story's pixel its colour: the last fragment that passed, or the eye ray's hit; -1 = neither.
int event_of_shown(const PixelStory& story);
/// The triangle that it is about.
PixelId shown_triangle(const PixelStory& story);

/// The vertex in space, where it is in its model, and its line of sight through the image.
void add_vertex(const VertexChain& chain, const Camera& camera, SpaceModel& model);

}  // namespace ps
