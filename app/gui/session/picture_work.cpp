#include "gui/session/picture_work.h"

#include <algorithm>
#include <utility>

namespace ps::gui {

PictureWork::PictureWork(std::function<void()> wake) : wake_(std::move(wake)) {
  for (const Side side : both_sides) {
    begin_anew(side);
    inspectors_[index_of(side)] = std::make_unique<InspectWorker>(prepared_, wake_);
  }
}

void PictureWork::begin_anew(Side side) {
  renderers_[index_of(side)] = std::make_unique<RenderWorker>(prepared_, wake_);
}

void PictureWork::draw_again() {
  prepared_->clear();
  for (const Side side : both_sides) {
    begin_anew(side);
    inspectors_[index_of(side)] = std::make_unique<InspectWorker>(prepared_, wake_);
  }
}

void PictureWork::take_news() {
  for (const auto& inspector : inspectors_) inspector->take_news();
}

bool PictureWork::rendering() const {
  return std::any_of(renderers_.begin(), renderers_.end(), [](const auto& renderer) {
    const RenderState state = renderer->status().state;
    return state == RenderState::coarse || state == RenderState::full;
  });
}

bool PictureWork::busy() const {
  return std::any_of(renderers_.begin(), renderers_.end(), [](const auto& renderer) { return renderer->busy(); }) ||
         std::any_of(inspectors_.begin(), inspectors_.end(), [](const auto& inspector) { return inspector->busy(); });
}

bool PictureWork::has_news() const {
  return std::any_of(both_sides.begin(), both_sides.end(), [&](Side side) {
    return renderers_[index_of(side)]->has_news() || inspectors_[index_of(side)]->has_news();
  });
}

void PictureWork::request(const Document& document, const SceneTraits& traits, bool renders_b) {
  const View view = view_of(document);
  const Vec2i picked = document.pixel;
  const bool inside = picked.x >= 0 && picked.y >= 0 && picked.x < view.width && picked.y < view.height;
  if (!renders_b) renderers_[1]->cancel();
  const auto common = common_range(document);
  const auto field = document.field ? std::make_shared<const ShownField>(*document.field) : nullptr;
  for (const Side side : both_sides) {
    InspectWorker& inspector = *inspectors_[index_of(side)];
    if (side == Side::b && !renders_b) {
      inspector.clear();
      continue;
    }
    const auto& [settings, shown, slow] = side_of(document, side);
    const auto& asked = document.heat_range;  // of a side's false colours: what was asked for, else what both share
    PictureRequest request{
        document.scene,       view, settings, shown, asked && asked->channel == shown ? asked->values : common,
        document.view.region, field};
    if (inside)
      inspector.request({request, picked});
    else
      inspector.clear();
    request.slow = given_slow_motion(slow, settings, traits, shown);
    renderers_[index_of(side)]->request(request);
  }
}

/// Two heat maps of the same kind share one scale, so that equal colours mean equal numbers.
std::optional<ValueRange> PictureWork::common_range(const Document& document) {
  const ShownChannel shown = document.a.show;
  if (shown != document.b.show || shown == ShownChannel::colour) {
    ranged_ = {};
    return {};
  }
  const std::array results{renderers_[0]->result(), renderers_[1]->result()};
  if (results == ranged_) return range_;
  const auto needs = shown_channel(shown).needs;
  std::optional<ValueRange> common;
  for (const auto& result : results) {
    if (!result || (result->channels | needs) != result->channels) return range_;
    const auto range = channel_range(result->frame, shown);
    if (!range) continue;
    common = common ? ValueRange{std::min(common->low, range->low), std::max(common->high, range->high)} : *range;
  }
  ranged_ = results;
  range_ = common;
  return range_;
}

}  // namespace ps::gui
