#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "study/model/model_search.h"

namespace ps::model {
namespace {

/// The coarsest level that all pixels could be drawn from: what fragments read of it, or how far it can be halved.
int coarsest_level(const Texture& texture, std::optional<float> finest_read) {
  const int smaller = std::min(texture.texels->width(), texture.texels->height());
  const int most = static_cast<int>(std::floor(std::log2(std::max(smaller, 1))));
  return finest_read ? std::min(most, static_cast<int>(std::floor(*finest_read))) : most;
}

Scene with_levels(const Scene& scene, const std::vector<int>& levels) {
  Scene coarser = scene;
  for (std::size_t i = 0; i < levels.size(); ++i)
    if (levels[i] > 0) coarser = with_coarser_texture(coarser, i, levels[i]);
  return coarser;
}

/// The cross of a folded-out cube: a mean across its cells mixes directions.
bool is_cross(const Texture& texture) { return !texture.faces.empty(); }

std::string size_text(const Texture& texture) {
  return fmt::format("{} x {}", texture.texels->width(), texture.texels->height());
}

/// "the 4096 x 4096 texture 'bricks'", "62 % of the texels of three textures"
std::string textures_that_go(const Scene& before, const Scene& after, const std::vector<std::size_t>& changed) {
  if (changed.size() == 1) {
    const Texture& texture = (*before.textures)[changed.front()];
    return fmt::format("the {} texture '{}'", size_text(texture), texture.name);
  }
  double all = 0, left = 0;
  for (std::size_t i = 0; i < before.textures->size(); ++i) {
    all += static_cast<double>(texture_bytes((*before.textures)[i]));
    left += static_cast<double>(texture_bytes((*after.textures)[i]));
  }
  return fmt::format("{:.0f} % of the texels", 100 * (1 - left / all));
}

}  // namespace

void ModelSearch::weigh_textures() {
  if (!settings().textures || scene().textures->empty()) return;
  const Scene before = scene();
  std::vector<int> levels;
  for (std::size_t i = 0; i < before.textures->size(); ++i) {
    const Texture& texture = (*before.textures)[i];
    const bool read = evidence_.finest_level[i].has_value();
    levels.push_back(is_cross(texture) || !read ? 0 : coarsest_level(texture, evidence_.finest_level[i]));
  }
  const auto any = [&] { return std::any_of(levels.begin(), levels.end(), [](int level) { return level > 0; }); };
  // Fragments show the same by the levels that they read; rays read the finest texel wherever they land, so theirs are
  // held against means.
  if (any() && !holds(with_levels(before, levels), settings(), Worth::unchanged)) {
    held_.allow_means();
    while (any() && !holds(with_levels(before, levels), settings(), Worth::unchanged))
      for (int& level : levels) level = std::max(0, level - 1);
  }
  weigh_unread_textures(before, levels);
  std::vector<std::size_t> changed;
  for (std::size_t i = 0; i < levels.size(); ++i)
    if (levels[i] > 0) changed.push_back(i);
  if (changed.empty()) return;
  ModelSaving saving{.part = ModelPart::textures, .goes = textures_that_go(before, last_.scene, changed)};
  if (changed.size() == 1)
    saving.kept = fmt::format("{} texels do", size_text((*last_.scene.textures)[changed.front()]));
  for (const std::size_t i : changed) {
    const Texture &whole = (*before.textures)[i], &less = (*last_.scene.textures)[i];
    saving.things.push_back(
        {.name = fmt::format("texture '{}': {} texels do for {}", whole.name, size_text(less), size_text(whole)),
         .bytes = texture_bytes(whole) - texture_bytes(less)});
  }
  take(std::move(saving));
}

void ModelSearch::weigh_unread_textures(const Scene& before, std::vector<int>& levels) {
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const Texture& texture = (*before.textures)[i];
    if (evidence_.finest_level[i] || is_cross(texture)) continue;
    const int most = coarsest_level(texture, {});
    for (int level = 1; level <= most; ++level) {
      std::vector<int> tried = levels;
      tried[i] = level;
      const double allowed = needs_.change.increase + request_.tolerance / 10;  // a map is a small part of a picture
      const Held before_this = last_;
      if (!holds(with_levels(before, tried), settings(), Worth::unchanged)) break;
      if (last_.change.increase > allowed) {
        last_ = before_this;
        break;
      }
      levels = tried;
    }
  }
}

}  // namespace ps::model
