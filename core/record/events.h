#pragma once
#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "frame/frame.h"
#include "image/texel.h"
#include "math/vec.h"
#include "options/settings.h"
#include "record/polygon_event.h"
#include "record/shadow_events.h"
#include "scene/light.h"

namespace ps {

/// Typed events that kernels report about one pixel. Numbers are those the kernel computed with, widened to double
/// without loss. Positions and directions are in world space unless a member says otherwise. `PixelId` names an object
/// and a triangle of it.

enum class RayKind { eye, shadow, reflection, refraction };

/// A transparent body in which an eye ray begins.
struct MediumAtEye {
  std::int32_t object = -1;
  double index = 1;  ///< of refraction
};

/// A ray is about to be traced. Its tests, hit and shading follow as its children.
struct RayEvent {
  RayKind kind = RayKind::eye;
  Vec3d origin{0, 0, 0};
  Vec3d direction{0, 0, 0};  ///< as used, not normalised
  double t_min = 0, t_max = 0;
  int depth = 0;                      ///< 0 for the eye ray, +1 for each bounce
  double share = 1;                   ///< how much of what this ray returns reaches the pixel
  std::vector<MediumAtEye> inside{};  ///< of an eye ray: the innermost body first
};

struct NodeEvent {
  int node = 0;
  int level = 0;
  Vec3d low{0, 0, 0}, high{0, 0, 0};
  bool entered = false;
  int object = -1;    ///< the instance in whose model space the box lies; -1 = in the world
  double radius = 0;  ///< above 0: the node is not a box but the sphere at its centre
};

enum class TestOutcome {
  accepted,      ///< nearest so far
  missed,        ///< no real root, or outside the triangle
  before_range,  ///< every intersection lies at or before t_min
  beyond_range,  ///< every intersection lies at or beyond t_max
  farther,       ///< a nearer hit is known already
  tie_lost,      ///< same t as the nearest so far, which has the lower index
  back_side,     ///< one-sided, and seen from behind
  parallel,      ///< the ray runs in the triangle's plane
  degenerate,    ///< zero-area triangle
  excluded       ///< not tested: the ray starts on it
};

struct SphereTestEvent {
  PixelId id;
  TestOutcome outcome = TestOutcome::missed;
  double discriminant = 0;
  std::optional<std::array<double, 2>> roots;  ///< absent when the discriminant is negative; nearer root first
};

struct TriangleTestEvent {
  PixelId id;
  TestOutcome outcome = TestOutcome::missed;
  std::string rejected_by;  ///< "weight of vertex 1 is negative"; empty when accepted
  std::optional<std::array<double, 3>> weights;
  std::optional<double> t;
};

/// The stretch of a ray's line inside one part of a solid.
struct SolidSpan {
  int part = 0;
  double enter = 0, leave = 0;
};

/// A plane, rectangle, box or cylinder, or parts put together by CSG.
struct SolidTestEvent {
  PixelId id;
  TestOutcome outcome = TestOutcome::missed;
  std::vector<SolidSpan> spans;   ///< of the parts that the line meets
  std::vector<double> crossings;  ///< t of each place where the line enters or leaves the whole
};

struct HitEvent {
  PixelId id;
  double t = 0;
  Vec3d point{0, 0, 0};
  Vec3d geometric_normal{0, 0, 0};
  Vec3d shading_normal{0, 0, 0};
  std::array<double, 3> weights{};  ///< barycentric; zeros on a sphere
  Vec2d uv{0, 0};
  bool back_face = false;
};

/// The ray left the scene.
struct MissEvent {
  Vec3d background{0, 0, 0};
};

/// The purpose for which a texture was read.
enum class TextureUse { surface, highlight, ambient, opacity, reflection };

struct TextureEvent {
  int texture = 0;
  Vec2d uv{0, 0};
  double level = 0;  ///< continuous level of detail that was asked for
  std::vector<Texel> texels;
  Vec3d result{0, 0, 0};
  TextureUse use = TextureUse::surface;  ///< `surface`: its colour, or its relief
};

struct LightEvent {
  int light = 0;
  LightKind kind = LightKind::ambient;
  Vec3d to_light{0, 0, 0};           ///< L, not normalised; in the shading space of the renderer
  double n_dot_l = 0;                ///< cosine after dividing by both lengths
  double r_dot_v = 0;                ///< cosine of the highlight's angle (R.V or N.H)
  double diffuse = 0, specular = 0;  ///< intensities added, before the light's colour
  double ambient = 0;                ///< as these: ambient light that a light of another kind adds, blocked or not
  std::optional<PixelId> blocker;    ///< what is between; then neither diffuse light nor a highlight is added
  double visible = 1;          ///< share of the light that reaches the point; 0 with a blocker, or in a shadow map
  bool below_horizon = false;  ///< N.L <= 0: no diffuse light
};

/// The light at a point from which a fragment takes its own: a vertex of its triangle (Gouraud shading) or the
/// triangle's centre (flat shading). The lights there are its children.
struct VertexLightEvent {
  PixelId id;
  std::optional<int> vertex;  ///< of the triangle; absent for its centre
  double weight = 1;          ///< of this light in that of the fragment
  Vec3d position{0, 0, 0};    ///< of the point
  Vec3d normal{0, 0, 1};      ///< at the point, any length
  Vec3d light{0, 0, 0};       ///< sum over the lights, before the weight
  Vec3d extra{0, 0, 0};       ///< the same sum for parts with a colour of their own
};

/// Local colour of a surface point: light times colour.
struct ShadeEvent {
  Vec3d surface{0, 0, 0};  ///< the material's colour after texturing
  Vec3d light{0, 0, 0};    ///< sum over the lights, as it multiplies `surface`
  Vec3d extra{0, 0, 0};    ///< what is added with a colour of its own (separate ambient or specular colours)
  Vec3d local{0, 0, 0};
};

struct ReflectionEvent {
  double reflective = 0;
  Vec3d local{0, 0, 0}, reflected{0, 0, 0}, result{0, 0, 0};
};

/// A surface whose next bounce would contribute less than reflection-cutoff: it shows its local colour.
struct CutoffEvent {
  double share = 0;  ///< of the pixel's colour that they would bring
  double least = 0;  ///< the setting
};

/// Light that comes through a surface (CGFS ch. 5).
struct RefractionEvent {
  double transparency = 0;
  double from_index = 1, to_index = 1;         ///< refraction indices on the ray's side and beyond
  double cos_incident = 0, cos_refracted = 0;  ///< of the angles to the normal; the second is 0 in total reflection
  double fresnel = 0;                          ///< share that the boundary reflects; 1 = total internal reflection
  bool total = false;
  double own_share = 0, mirrored_share = 0, refracted_share = 0;  ///< what the three colours are multiplied by
  Vec3d local{0, 0, 0}, mirrored{0, 0, 0}, refracted{0, 0, 0}, result{0, 0, 0};
};

enum class RejectReason {
  outside_view,  ///< bounding sphere outside a clipping plane
  clipped_near,
  clipped_side,
  clipped_far,
  back_face,
  zero_area,
  cut_out,       ///< covered, but its opacity map is below 1/2 there
  not_covered,   ///< its box touched the pixel, its area did not
  behind_camera  ///< clipping is off and it could not be projected
};

/// A triangle that never became a fragment of this pixel, though it could have.
struct RejectEvent {
  PixelId id;
  RejectReason reason = RejectReason::not_covered;
  std::string detail;  ///< "left plane", "edge 1"; may be empty
  std::optional<std::array<double, 3>> edges;
};

/// A covered sample of one triangle, from coverage to depth test.
struct FragmentEvent {
  PixelId id;
  std::array<Vec2d, 3> corners{};        ///< canvas, pixels from the top left
  std::array<double, 3> corner_depth{};  ///< camera-space z of the vertices
  /// Edge function values at the sample, entry i for the edge opposite vertex i; positive = inside. Graphics drivers do
  /// not report them.
  std::optional<std::array<double, 3>> edges;
  std::optional<std::array<bool, 3>> tie_owned;  ///< edge passes exactly through the sample and this triangle owns it
  std::array<double, 3> weights_2d{};            ///< screen-space barycentric weights
  std::array<double, 3> weights{};               ///< perspective-correct weights
  double z = 0, inverse_z = 0;
  enum class Depth { passed, failed, off } depth = Depth::off;
  /// Which pass over the triangles it belongs to: with an early depth pass or deferred shading there are two.
  enum class Pass { only, depth_first, shading } pass = Pass::only;
  int samples = 1, samples_covered = 1;  ///< of the pixel, with multisampling
  /// In the stored depth value; meaningless when off. With multisampling those of the first covered sample, absent
  /// where a graphics driver has no textures of depths with several samples.
  std::optional<double> depth_stored, depth_new;
  bool back_face = false;
  int sphere_triangle = -1;         ///< index among the triangles of a tessellated sphere; -1 for triangles of a model
  std::optional<int> clipped_into;  ///< number of triangles that clipping made of the original
};

/// How a coverage strategy other than plain edge functions decided about the pixel (options/settings.h). A child of the
/// fragment, or of the rejection, that followed from it.
struct CoverageEvent {
  PixelId id;
  std::optional<Coverage> strategy;  ///< absent where a graphics driver has one of its own
  bool covered = false;
  std::string how;             ///< "row 12 is covered from column 3 to 17"
  std::vector<double> values;  ///< what was compared: edge values, weights or volumes, as the strategy has them
  int tests = 0;               ///< samples, cells, rows or pieces looked at for this pixel
};

/// A fragment that passed wrote the pixel. With multisampling `before` and `after` are of its first sample.
struct WriteEvent {
  PixelId id;
  Vec3d before{0, 0, 0}, shaded{0, 0, 0}, after{0, 0, 0};
  double opacity = 1;  ///< below 1: after = shaded * opacity + before * (1 - opacity)
};

/// A line or an outline wrote the pixel.
struct LineEvent {
  PixelId id;
  Vec2d from{0, 0}, to{0, 0};  ///< canvas, pixels from the top left
  int step = 0;                ///< index along the walk
  Vec3d colour{0, 0, 0};
};

/// One of several samples of the pixel; its ray follows as its child.
struct SampleEvent {
  int index = 0, count = 1;
  Vec2d position{0.5, 0.5};  ///< in pixels from the pixel's top-left corner
  double weight = 1;         ///< its share of the pixel's colour
  Vec3d colour{0, 0, 0};
};

/// Adaptive sampling compared the pixel's first ray with that of a neighbour (CGFS ch. 5).
struct CompareEvent {
  Vec2i neighbour{0, 0};  ///< array position
  PixelId own, other;
  double difference = 0;  ///< largest difference of a channel on the display, 1 = white
  double threshold = 0;
  bool subdivides = false;
};

/// Subsampling: the traced pixels around saw the same, so the eye ray was not searched for (CGFS ch. 5), or they did
/// not.
struct ReuseEvent {
  std::array<Vec2i, 4> around{};  ///< array positions; two on a searched row or column, else four
  int count = 0;                  ///< of them
  PixelId seen;                   ///< by the first of them
  bool same = false;              ///< all saw the same object
  bool met = false;               ///< and the pixel's own ray meets it; else it is searched for after all
};

/// A normal read from a normal map and turned from tangent space to the world (CGFS ch. 15).
struct NormalMapEvent {
  int texture = 0;
  Vec2d uv{0, 0};
  Vec3d stored{0, 0, 1};  ///< in tangent space, as the map has it
  Vec3d tangent{1, 0, 0}, bitangent{0, 1, 0}, before{0, 0, 1}, after{0, 0, 1};
};

/// Parallax mapping: where on its texture a point of a relief is read (shade/parallax_mapping.h). Depths from 0 at the
/// surface to 1 at the bottom of the relief.
struct ParallaxEvent {
  int texture = 0;             ///< the height map
  Vec2d from{0, 0}, to{0, 0};  ///< texture coordinates of the surface, and those that are read instead
  Vec2d shift{0, 0};           ///< from the top of the relief to its bottom along the line of sight, in u and v
  double depth = 0;            ///< where the line of sight is taken to meet the relief
  std::vector<double> relief;  ///< depths that the map holds, in the order in which it was read
};

/// The finished pixel. The last event of every story.
struct PixelEvent {
  Vec3d linear{0, 0, 0};
  std::array<int, 3> display{};
};

using EventData = std::variant<RayEvent, NodeEvent, SphereTestEvent, TriangleTestEvent, HitEvent, MissEvent,
                               TextureEvent, LightEvent, ShadeEvent, ReflectionEvent, RejectEvent, FragmentEvent,
                               WriteEvent, LineEvent, PixelEvent, SolidTestEvent, RefractionEvent, CoverageEvent,
                               SampleEvent, CompareEvent, ReuseEvent, NormalMapEvent, ShadowMapEvent, StencilEvent,
                               EnvironmentEvent, ParallaxEvent, CutoffEvent, VertexLightEvent, PolygonEvent>;

/// One event with its place in the tree: `parent` is the index of the event it belongs to, -1 at the top.
struct Event {
  int parent = -1;
  EventData data;
};

}  // namespace ps
