#pragma once
#include <array>
#include <memory>
#include <optional>

#include "gui/panels/pictures/caption.h"
#include "gui/panels/pictures/nan_pixels.h"
#include "gui/panels/pictures/picture_before.h"
#include "gui/panels/pictures/picture_captions.h"
#include "gui/panels/pictures/picture_transform.h"
#include "gui/panels/pictures/picture_view.h"
#include "gui/panels/pictures/slow_motion.h"
#include "gui/panels/pictures/vertex_marks.h"
#include "gui/session/gizmo.h"
#include "gui/session/handles.h"
#include "gui/session/picked_object.h"
#include "gui/session/session.h"
#include "gui/work/difference_meter.h"
#include "gui/work/story_ahead.h"
#include "image/difference.h"

namespace ps::gui {

/// What the mouse is over.
struct Hover {
  Side side = Side::a;
  Vec2i pixel{0, 0};
};

/// The parts of the pictures that an open question covers.
struct PictureCovers {
  std::optional<Hover> asked;    ///< the pixel that it is about: its surroundings
  std::array<bool, 2> hidden{};  ///< pictures that would answer it: the whole
};

/// Whether two pictures side by side may give way to one that they share, where they would be small.
enum class TwoPictures { may_share, stay };

/// The place that pictures are given.
struct PicturePlace {
  PictureCaptions captions = PictureCaptions::full;
  double least_pixels = 0;  ///< of the window, that both together shall take
  TwoPictures two = TwoPictures::may_share;
  PictureCovers covers{};
};

constexpr double divider_reach = 10;  ///< pixels to both sides of the split's divider that take hold of it, at scale 1

/// What dragging in a picture does until the button is released.
enum class PictureDrag { none, undecided, pan, look, orbit, divider, handle, gizmo, region };

/// The range that a picture's false colours have by themselves, and what it was found in.
struct UsualRange {
  std::shared_ptr<const RenderResult> result;
  ShownChannel channel{};
  ValueRange values;
};

/// Facts about each side's picture.
struct SidePictures {
  std::array<bool, 2> fresh{};            ///< changed since their hash was taken
  std::array<std::uint64_t, 2> hashes{};  ///< of the pictures' levels, for tests
  std::array<NanPixels, 2> nan_pixels;
  std::array<UsualRange, 2> usual;
  std::array<PictureBefore, 2> before;      ///< the last change
  std::array<std::uint64_t, 2> taken{};     ///< the versions that `before` knows of
  std::array<CaptionChange, 2> changes;     ///< of the counts below the pictures
  std::shared_ptr<const PictureFile> file;  ///< that is in B's place
  std::array<std::uint64_t, 2> compared{};  ///< the versions that `differing` counts
  double differing = 0;                     ///< share of the pixels whose levels are not the same in A and B
};

/// B - A, and how it is shown. One thing, so it is one struct, of more than twelve members.
struct ShownDifference {
  explicit ShownDifference(const std::function<void()>& wake) : meter(std::make_unique<DifferenceMeter>(wake)) {}

  ShownPicture picture;
  bool stale = true;
  bool fresh = false;                                         ///< made since its hash was taken
  std::uint64_t hash = 0;                                     ///< of its levels, for tests
  bool identical = false;                                     ///< the levels of A and B, when it was last made
  std::array<std::weak_ptr<const Image<Vec3f>>, 2> compared;  ///< values behind pictures of equal levels
  Comparison of_values;                                       ///< of these
  AlphaDifference of_alpha;                                   ///< of a file in B's place and a render, which is opaque
  DifferenceMode mode = DifferenceMode::absolute;
  Image<float> values;  ///< what it shows of each pixel
  DifferenceNumbers numbers;
  double gain = 1;                         ///< with which it is shown
  double asked = 0;                        ///< gain that the document asked for then
  bool settled = false;                    ///< its gain is that of whole pictures
  ErrorMetric metric = ErrorMetric::rmse;  ///< beside it
  std::unique_ptr<DifferenceMeter> meter;
};

/// Keys that change what is seen; all but the last are held.
struct PictureKeys {
  bool flip = false;   ///< each picture gives way to the other
  bool loupe = false;  ///< both are enlarged around the pointer
  bool was = false;    ///< pictures as they were before the last change
  bool fly = false;    ///< letters move the camera
};

/// How the pictures were drawn last.
struct DrawnPictures {
  PictureCaptions captions = PictureCaptions::full;
  CompareMode compare = CompareMode::side_by_side;  ///< split where side by side had no room
  PictureFit fit = PictureFit::even_pixels;
  std::optional<float> split_at;             ///< the divider's place in the window, while A and B share one picture
  std::array<std::optional<Area>, 2> areas;  ///< where each side was drawn in the last frame
  std::array<std::optional<Area>, 2> notes;  ///< the row for a note below each of them
  PictureTransform transform;                ///< shared by all views
  PictureCovers covers;
};

/// The mouse in the pictures.
struct PictureMouse {
  std::optional<Hover> hover;
  PictureDrag drag = PictureDrag::none;
  ImVec2 drag_from{0, 0};
  Side drag_side = Side::a;             ///< in whose picture the drag began
  std::optional<Handle> grabbed;        ///< the handle being dragged, as it was at the start
  std::optional<GizmoDrag> gizmo_drag;  ///< the part of the gizmo being dragged
  bool on_ball = false;                 ///< the drag began on the ball that orbits
};

/// What the pictures remember of themselves. The document holds the rest.
struct PicturesState {
  /// `wake` may be called from any thread; `object` must outlive it.
  PicturesState(const std::function<void()>& wake, ObjectSelection& object) : difference(wake), selection(object) {}

  std::array<ShownPicture, 2> pictures;
  std::array<std::uint64_t, 2> versions{};  ///< one more with each change
  SidePictures sides;
  SlowMotionState slow;
  ShownDifference difference;
  StoryAhead ahead;  ///< of the picture under the mouse
  bool grid = true;
  bool handles = true;  ///< lights and spheres can be dragged
  VertexMarks vertices;
  PictureKeys keys;
  DrawnPictures drawn;
  PictureMouse mouse;
  ObjectSelection& selection;
};

/// Takes over what the renderers have made since the last frame.
void collect_pictures(Session& session, PicturesState& state);

/// Both pictures as the document's compare mode has them, with titles, times and everything the mouse can do in them.
/// Where two side by side would take fewer than place.least_pixels and one takes more, A and B may share it with a
/// divider.
void pictures_panel(Session& session, PicturesState& state, const Area& area, const PicturePlace& place = {});

/// How many pixels of the window show rendered pixels of A or B: without captions and margins, what both show counted
/// once.
double pixels_on_screen(const PicturesState& state);

/// Mouse in one picture; call right after its invisible button. `split_at` is the divider's place in the window, if
/// there is one.
void picture_input(Session& session, PicturesState& state, Side side, const Area& area, std::optional<float> split_at);

/// Lights and spheres that can be dragged, while the mouse is in the picture. `clip` is the part of the area that shows
/// this side; `prefix` names them for scripts.
void picture_handles(Session& session, PicturesState& state, Side side, const Area& area, const Area& clip,
                     const std::string& prefix, bool hovered);

/// Whether letters fly the camera now.
bool flying(const PicturesState& state);
/// The keys that then move it, by place: forward, left, back, right, down, up.
inline constexpr std::string_view fly_keys = "WASDQE";
/// Moves the camera by the keys held, for one frame. Answers whether any was.
bool fly_camera(Session& session, const PicturesState& state, double seconds);

}  // namespace ps::gui
