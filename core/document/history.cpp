#include "document/history.h"

#include <algorithm>
#include <unordered_set>

#include "base/check.h"
#include "base/memory_size.h"

namespace ps {
namespace {

/// Counts meshes and textures, each once however many documents share it.
class ContentBytes {
 public:
  void add(const Scene& scene) {
    if (scenes_.insert(&*scene.geometry).second)
      for (const auto& mesh : scene.geometry->meshes)
        if (mesh && contents_.insert(mesh.get()).second)
          sum_ += owned_bytes(mesh->positions, mesh->normals, mesh->uvs, mesh->triangles, mesh->patches);
    if (scenes_.insert(&*scene.textures).second)
      for (const Texture& texture : *scene.textures)
        if (texture.texels && contents_.insert(texture.texels.get()).second)
          sum_ += texture.texels->pixels().size_bytes();
  }
  std::size_t sum() const { return sum_; }

 private:
  std::unordered_set<const void*> scenes_, contents_;
  std::size_t sum_ = 0;
};

}  // namespace

History::History(Document start, std::string label, std::size_t most_bytes) : most_bytes_(most_bytes) {
  entries_.push_back({std::move(start), std::move(label), 0});
}

void History::forget_oldest() {
  std::size_t kept = 0;
  ContentBytes bytes;
  while (kept < std::min(entries_.size(), limit)) {
    const Document& document = entries_[entries_.size() - 1 - kept].document;
    bytes.add(document.base);
    bytes.add(document.scene);
    if (kept > 0 && bytes.sum() > most_bytes_) break;
    ++kept;
  }
  entries_.erase(entries_.begin(), entries_.end() - static_cast<std::ptrdiff_t>(kept));
}

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
  forget_oldest();
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
