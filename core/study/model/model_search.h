#pragma once
#include <functional>
#include <string>
#include <vector>

#include "study/model/evidence.h"
#include "study/model/model_needs.h"
#include "study/model/reduce.h"

namespace ps::model {

/// Indices of what may go.
using Candidates = std::vector<std::size_t>;

/// How a step is judged before it is drawn in full.
enum class Worth {
  unseen,     ///< a whole thing that shows nowhere: whatever it saves counts
  unchanged,  ///< the picture should stay: it must save 1 % of the work or the bytes, and add no work
  lossy,      ///< it may change a picture: it must save least_saving of the work or the bytes
  halved,     ///< one kind of work takes the place of another: only half the count is surely less
  uncounted,  ///< it saves what is not counted, such as half the size of each number
};

/// A scene on its way from the full to the reduced one.
class ModelSearch {
 public:
  ModelSearch(const ModelRequest& request, StudyControl& control);

  const ModelRequest& request() const { return request_; }
  const Scene& scene() const { return needs_.scene; }
  const Settings& settings() const { return needs_.settings; }
  Evidence& evidence() { return evidence_; }
  HeldPictures& held() { return held_; }
  ModelNeeds& needs() { return needs_; }

  /// Does the scene with these settings stay within the tolerance, and is it worth it? The change is kept for take().
  bool holds(const Scene& scene, const Settings& settings, Worth worth);
  /// Goes on from what the last holds() said yes to. Fills what the saving measures.
  void take(ModelSaving saving);
  /// Drops the evidence of objects that are gone from `before`, and of textures that only they had.
  void forget(const Scene& before, const Candidates& gone);
  /// Tries all at once, then halves of what is too much: those that hold together. `reduced` makes the scene without
  /// them. The last scene that held is the one with all of the result.
  Candidates hold_together(const Candidates& candidates, Worth worth,
                           const std::function<Scene(const Candidates&)>& reduced);

  /// From the geometry to the settings. One file each.
  void weigh_objects();
  void weigh_shapes();
  void weigh_triangles();
  void weigh_small_objects();
  void weigh_textures();
  void weigh_detail();
  void weigh_lights();
  void weigh_settings();
  void weigh_depth_buffer();

 private:
  /// The same for maps that no fragment's level of detail speaks of: normals, heights, highlights, surroundings.
  void weigh_unread_textures(const Scene& before, std::vector<int>& levels);
  void halve(const Candidates& candidates, Worth worth, const std::function<Scene(const Candidates&)>& reduced,
             Candidates& held);

  const ModelRequest& request_;
  StudyControl& control_;
  HeldPictures held_;
  Evidence evidence_;
  ModelNeeds needs_;
  /// The last scene to which holds() said yes.
  struct Held {
    Scene scene;
    Settings settings;
    Change change;
    std::uint64_t work = 0, bytes = 0;
  };
  Held last_;
};

bool is_worth_it(Worth worth, const ModelNeeds& now, std::uint64_t work, std::uint64_t bytes);

/// "object 'floor'", or "object 3" where it has no name.
std::string object_name(const Scene& scene, std::size_t object);
/// "three", up to twelve; "13".
std::string number_word(std::size_t number);
/// "three of twelve lights", "both lights", "the light"
std::string part_of_all(std::size_t some, std::size_t all, std::string_view one, std::string_view many);

}  // namespace ps::model
