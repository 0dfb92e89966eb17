#pragma once
#include <array>
#include <memory>

#include "document/document.h"
#include "gui/base/sides.h"
#include "record/story.h"

namespace ps::gui {

/// A side's newest story, with the document that it is shown in.
struct NewestStory {
  Document& document;
  Side side = Side::a;
  Side inspected = Side::a;                 ///< the side whose story is shown
  std::shared_ptr<const PixelStory> story;  ///< nullptr while there is none
  bool still_coming = false;                ///< a newer one is being made
};

/// Keeps the selected events, the picked pixel's views and the kept vertex while what they belong to changes.
class SelectedEvents {
 public:
  /// The selected event of a side's story; -1 while none is, or while the story that it belongs to is still to come.
  int selected(const Document& document, Side side) const;
  /// The document's events belong to stories that are still to come.
  void await_stories() { awaited_ = {true, true}; }
  /// When a story comes, the selected event becomes the same event in it, after a change of options for example.
  /// Answers whether the document was changed.
  bool follow(const NewestStory& newest);
  /// After a change of the document: what belonged to the pixel, or to the models, that were there before goes, unless
  /// the change itself brought it.
  void settle(const Document& before, Document& document);

 private:
  std::array<std::shared_ptr<const PixelStory>, 2> followed_;  // the stories that the selected events belong to
  std::array<bool, 2> awaited_{};  // the selected event belongs to a story that is still to come
};

}  // namespace ps::gui
