#pragma once
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/parallel.h"
#include "document/pin.h"
#include "document/scene_edits.h"
#include "document/story_view.h"
#include "frame/slow_motion.h"
#include "frame/view.h"
#include "options/settings.h"
#include "record/field_query.h"
#include "render/channel_picture.h"
#include "scene/scene.h"

namespace ps {

/// The two pictures that are compared.
enum class Side { a, b };
inline Side other_side(Side side) { return side == Side::a ? Side::b : Side::a; }

/// How the two pictures are arranged on the screen.
enum class CompareMode { side_by_side, split, difference, only_a, only_b };

/// Settings and display of one of the pictures.
struct SideState {
  Settings settings;
  ShownChannel show{};
  std::optional<SlowMotion> slow_motion;  ///< the picture is shown as far as that; empty = whole
  bool operator==(const SideState&) const = default;
};

/// The range of a false-colour scale, in place of the one that follows from the pictures' values.
struct HeatRange {
  ShownChannel channel{};  ///< it does not act on other channels
  ValueRange values;       ///< high > low
  bool operator==(const HeatRange&) const = default;
};

/// The part of the pictures that is shown, and its zoom.
struct PictureView {
  std::optional<Camera> camera;  ///< instead of the scene's own
  int width = 0, height = 0;     ///< pixels; 0 = the scene's canvas size
  double zoom = 0;               ///< screen pixels for one picture pixel; 0 = the whole picture fits
  Vec2d middle{0.5, 0.5};  ///< the place of the picture at the centre of its view; (0, 0) top left, (1, 1) its end
  std::optional<TileRect> region;  ///< only these pixels are rendered (CGPP 15.4.4); empty = all
  bool operator==(const PictureView&) const = default;
};

/// The purpose of the window, which decides how it is divided. A lesson has its text beside large pictures; a
/// study one long tool beside small ones; the presenter shows pictures alone with the text as a caption.
enum class ScreenMode { lesson, explore, study, presenter };

/// How the window is divided. Sizes are shares of the window, 0..1; 0 = what suits the window's size.
struct Layout {
  double left = 0, right = 0, bottom = 0;  ///< bottom: 0 = folded
  bool panels = true;                      ///< false: only the pictures
  std::string right_tab = "story";   ///< the part of the pixel's stories that is shown, by the window's name for it
  std::string bottom_tab = "space";  ///< the tool below the pictures, the same
  bool story_open = true;            ///< exploring: the column with the pixel's story
  bool options_open = false;         ///< exploring: the column with all options
  std::string stage;                 ///< the tool below the pictures of a lesson; empty = the pixel's story
  std::string sweep;       ///< what the chart varies, as sweep_text() writes it; empty = the first named sweep
  std::string experiment;  ///< key of the one that the stability tab shows; empty = the first
  std::string filled;      ///< the region that has the window for itself, by its name; "" = none
  bool operator==(const Layout&) const = default;
};

/// Everything on the screen as a value. Copies share the scene's parts, so that keeping hundreds of them is cheap: undo
/// is a stack of Documents, a permalink is the text of one. Transient things (what the mouse is over, a picture in the
/// making) are not part of it.
struct Document {
  std::string scene_name;        ///< built-in name or path, as the user would give it
  Scene base;                    ///< as loaded
  Scene scene;                   ///< `base` with the edits
  std::vector<SceneEdit> edits;  ///< in the order in which they are applied
  PictureView view;
  SideState a, b;
  std::optional<ShownField> field;  ///< the number of the story that ShownChannel::field shows
  std::string picture_b;            ///< a picture file that is in B's place, as the user gave it; empty = B is rendered
  Vec2i pixel{-1, -1};              ///< the picked pixel, array position; (-1, -1) = none
  Side picked = Side::a;            ///< whose story is shown
  std::array<int, 2> events{-1, -1};  ///< the selected events of the stories of A and B; -1 = none
  StoryView story;                    ///< what its views show
  std::optional<Pin> pin;             ///< pinned pixel; its old numbers are shown beside the new ones
  CompareMode compare = CompareMode::side_by_side;
  double split = 0.5;  ///< where the divider is, share of the picture's width
  std::optional<HeatRange> heat_range;
  double difference_gain = 0;  ///< factor by which differences are shown; 0 = as large as shows something
  ScreenMode mode = ScreenMode::explore;
  Layout layout;
  std::string lesson;  ///< folder name; empty = none
  int step = 0;        ///< of the lesson, from 0
  /// The document before the first of several comparisons of techniques in a row (document/technique.h); nullptr = this
  /// has no such way back. Users do not see it.
  std::shared_ptr<const Document> before_technique;
};

/// Equal in everything that a user can see. Scenes are compared by their parts' revisions.
bool operator==(const Document& x, const Document& y);

/// A document that shows `scene` as its file asks: its settings on both sides; rays in A and triangles in B, unless the
/// file names a renderer or all that there is lies on the canvas, where rays find nothing; its start pixel picked.
/// Throws InputError for settings that do not exist.
Document open_document(const std::string& scene_name, Scene scene);

/// Puts a loaded scene under a document that knows only its name, and applies the document's edits. What of the
/// rectangle that limits rendering lies outside the picture is cut off. Throws InputError when an edit or the pin does
/// not fit the scene, or for a setting of the scene that does not exist.
void attach_scene(Document& document, Scene scene);

/// Adds an edit and applies it. A property's takes the place of an earlier one of the same path, unless things were
/// put into the scene or taken out of it since: then the path may mean another thing. Throws InputError, and leaves the
/// document as it was, when it does not fit.
void edit_scene(Document& document, const SceneEdit& edit);

/// Pins the picked pixel as it is now, in place of one that was pinned. Without effect where none is picked.
void pin_pixel(Document& document);

/// Cuts the rectangle that limits rendering off at the picture's edges; one outside goes.
void fit_region(Document& document);

/// Camera and picture size of the document.
View view_of(const Document& document);

/// The selected event of a side's story.
int event_of(const Document& document, Side side);
int& event_of(Document& document, Side side);

const SideState& side_of(const Document& document, Side side);
SideState& side_of(Document& document, Side side);

}  // namespace ps
