#pragma once
#include <list>
#include <memory>
#include <optional>
#include <vector>

#include "document/document.h"
#include "frame/frame.h"
#include "frame/prepared.h"
#include "frame/region.h"

namespace ps {

/// The state that measurements share which follow one another: the newest pictures, the scene that was loaded last and
/// what was prepared for it. For one thread at a time.
class MeasuredPictures {
 public:
  /// The document's scene rendered with these settings and channels: kept from before, if it was among the newest.
  /// Throws InputError and Cancelled as render() does.
  std::shared_ptr<const Frame> frame(const Document& document, const Settings& settings, Channel channels,
                                     Progress& progress);
  /// The document of the newest picture, whose scene state_document() need not load again.
  const Document& last() const { return last_; }
  /// How many pictures were rendered so far.
  int rendered() const { return rendered_; }

 private:
  /// All that the picture depends on.
  struct Key {
    SceneRevision base;
    std::vector<SceneEdit> edits;
    View view;
    std::optional<TileRect> region;
    Settings settings;
    Channel channels = Channel::none;
    bool operator==(const Key&) const = default;
  };
  struct Kept {
    Key key;
    std::shared_ptr<const Frame> frame;
  };

  std::list<Kept> kept_;  // newest first
  Prepared prepared_;
  Document last_;
  int rendered_ = 0;
};

}  // namespace ps
