#pragma once
#include <atomic>
#include <cstdint>
#include <memory>
#include <utility>

namespace ps {

/// A number never given out before in this process. 0 is never given out.
inline std::uint64_t next_revision() {
  static std::atomic<std::uint64_t> counter{0};
  return counter.fetch_add(1, std::memory_order_relaxed) + 1;
}

/// A shared, copy-on-write piece of a scene. Copies share the content; edit() replaces it. Equal revisions mean equal
/// content, so Prepared can use the revision as a key.
template <class T>
class Part {
 public:
  Part() : value_(std::make_shared<const T>()) {}
  explicit Part(T value) : value_(std::make_shared<const T>(std::move(value))), revision_(next_revision()) {}

  const T& operator*() const { return *value_; }
  const T* operator->() const { return value_.get(); }
  std::shared_ptr<const T> share() const { return value_; }
  /// 0 for default content, otherwise unique to this content.
  std::uint64_t revision() const { return revision_; }

  /// Applies `change(T&)` to a copy and keeps that copy under a new revision.
  template <class Change>
  void edit(Change&& change) {
    T copy = *value_;
    std::forward<Change>(change)(copy);
    value_ = std::make_shared<const T>(std::move(copy));
    revision_ = next_revision();
  }

 private:
  std::shared_ptr<const T> value_;
  std::uint64_t revision_ = 0;
};

}  // namespace ps
