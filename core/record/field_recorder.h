#pragma once
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "base/counters.h"
#include "image/image.h"
#include "record/field_query.h"
#include "record/story_to_world.h"

namespace ps {

/// The fifth recorder (record/recorder.h): of every pixel it keeps one number of its story. Of the rays of a pixel the
/// first event that is asked for gives it, of its fragments the one that is seen. Pixels that report none keep NaN.
class FieldRecorder {
 public:
  static constexpr bool counts = false;
  static constexpr bool records = true;
  static constexpr bool one_pixel = false;
  /// `values` and `owners` have the picture's size; several recorders may fill different pixels of them.
  FieldRecorder(const FieldQuery& query, const WorkingSpace& space, Image<float>& values, Image<PixelId>& owners)
      : query_(query), kind_(event_kind_place(query.kind)), space_(space), values_(values), owners_(owners) {}

  /// All that follows belongs to this pixel.
  void at(int x, int y) {
    if (x == x_ && y == y_) return;
    x_ = x;
    y_ = y;
    passed_ = 0;
  }
  void count(Counter, std::uint64_t = 1) {}
  static constexpr bool wants(int, int) { return true; }
  bool collects() const { return !muted_; }
  void mute(bool muted) { muted_ = muted; }
  template <class Make>
  void event(Make&& make) {
    if (!muted_ && hidden_ == 0) take(std::forward<Make>(make)());
  }
  template <class Make>
  void begin(Make&& make) {
    if (muted_) return;
    using Made = std::remove_cvref_t<std::invoke_result_t<Make>>;
    Scope scope = Scope::other;
    if constexpr (std::is_same_v<Made, RayEvent>) {
      const RayEvent ray = make();
      if (hidden_ == 0) take(ray);
      if (ray.kind != RayKind::eye) {
        path_.push_back(ray.kind);
        scope = Scope::ray;
      }
    } else if constexpr (std::is_same_v<Made, FragmentEvent>) {
      scope = fragment(make());
    } else if (!std::is_same_v<Made, VertexLightEvent> && hidden_ == 0) {
      take(make());  // that of a vertex is known at its end
    }
    scopes_.push_back(scope);
  }
  void end() {
    if (muted_) return;
    const Scope scope = scopes_.back();
    scopes_.pop_back();
    if (scope == Scope::ray) path_.pop_back();
    if (scope == Scope::hidden) --hidden_;
  }
  template <class Make>
  void end(Make&& make) {
    if (!muted_ && hidden_ == 0) take(std::forward<Make>(make)());
    end();
  }

 private:
  /// The index of `Made` among the alternatives of a variant.
  template <class Made, class... All>
  static constexpr std::size_t place_in(const std::variant<All...>*) {
    std::size_t place = 0;
    (void)((std::is_same_v<Made, All> || (++place, false)) || ...);
    return place;
  }
  enum class Scope : std::uint8_t { other, ray, hidden };

  /// A fragment that is not drawn hides all that it reports.
  Scope fragment(const FragmentEvent& event) {
    if (!is_drawn(event)) {
      ++hidden_;
      return Scope::hidden;
    }
    passed_ = 0;
    PixelId& owner = owners_.at(x_, y_);
    if (!(owner == event.id)) values_.at(x_, y_) = std::numeric_limits<float>::quiet_NaN();
    owner = event.id;
    take(event);
    return Scope::other;
  }

  template <class Made>
  void take(const Made& made) {
    if (place_in<Made>(static_cast<const EventData*>(nullptr)) != kind_ || path_ != query_.path) return;
    scratch_.assign(1, Event{-1, EventData(made)});
    if (!matches(query_, scratch_[0].data) || passed_++ != query_.order) return;
    story_to_world(space_, scratch_);
    if (const auto number = field_number(query_, scratch_[0].data)) values_.at(x_, y_) = static_cast<float>(*number);
  }

  const FieldQuery& query_;
  std::size_t kind_;  ///< of the event, as its place in EventData
  const WorkingSpace& space_;
  Image<float>& values_;
  Image<PixelId>& owners_;
  int x_ = -1, y_ = -1;
  int passed_ = 0, hidden_ = 0;
  bool muted_ = false;
  std::vector<RayKind> path_;
  std::vector<Scope> scopes_;
  std::vector<Event> scratch_;
};

}  // namespace ps
