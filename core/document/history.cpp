#include "document/history.h"

#include "base/check.h"

namespace ps {

History::History(Document start, std::string label) { entries_.push_back({std::move(start), std::move(label), 0}); }

void History::push(Document document, std::string label, const std::string& drag) {
  if (document == current()) return;
  const bool continues = !drag.empty() && drag == drag_ && !can_redo();
  drag_ = drag;
  if (continues) {
    entries_[place_] = {std::move(document), std::move(label), next_id_++};
    return;
  }
  entries_.resize(place_ + 1, entries_.front());
  entries_.push_back({std::move(document), std::move(label), next_id_++});
  if (entries_.size() > limit) entries_.erase(entries_.begin());
  place_ = entries_.size() - 1;
}

bool History::cancel_drag(const std::string& drag) {
  if (drag.empty() || drag != drag_ || !can_undo() || can_redo()) return false;
  entries_.pop_back();
  --place_;
  end_drag();
  return true;
}

void History::undo() {
  if (can_undo()) go_to(place_ - 1);
}

void History::redo() {
  if (can_redo()) go_to(place_ + 1);
}

void History::go_to(std::size_t place) {
  PS_ASSERT(place < entries_.size(), "a place in the history");
  place_ = place;
  end_drag();
}

}  // namespace ps
