#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "document/document.h"

namespace ps {

/// Undo and redo as a list of Documents with a place in it. A drag makes many documents but one entry.
class History {
 public:
  struct Entry {
    Document document;
    std::string label;     ///< what led to it: "shadow-epsilon = 0"
    std::uint64_t id = 0;  ///< no two states that were ever pushed share one
  };
  /// Older entries than this are forgotten.
  static constexpr std::size_t limit = 1000;
  /// So are older ones than those whose meshes and textures take this many bytes together.
  static constexpr std::size_t byte_limit = std::size_t{512} << 20;

  explicit History(Document start, std::string label = "start", std::size_t most_bytes = byte_limit);

  const Document& current() const { return entries_[place_].document; }
  /// Makes `document` the current one and drops what could be redone. A document equal to the current one changes
  /// nothing. While `drag` is not empty and the same as in the call before, the entry is replaced, not added.
  void push(Document document, std::string label, const std::string& drag = {});
  /// Ends a drag: the next push is an entry of its own.
  void end_drag() { drag_.clear(); }
  /// Takes back the entry that the steps of this drag have made, as if it had never begun. False where the newest entry
  /// is not this drag's, or the drag has ended.
  bool cancel_drag(const std::string& drag);

  bool can_undo() const { return place_ > 0; }
  bool can_redo() const { return place_ + 1 < entries_.size(); }
  /// Step back or forth; without effect where there is no such step.
  void undo();
  void redo();

  /// All entries, oldest first, and the place of the current one; for a list to jump in.
  const std::vector<Entry>& entries() const { return entries_; }
  std::size_t place() const { return place_; }
  void go_to(std::size_t place);

 private:
  void forget_oldest();

  std::vector<Entry> entries_;
  std::size_t most_bytes_;
  std::size_t place_ = 0;
  std::string drag_;
  std::uint64_t next_id_ = 1;
};

}  // namespace ps
