#pragma once
#include <fmt/format.h>

#include <optional>
#include <string>

#include "inspect/parting/parting.h"
#include "inspect/parting/sighting.h"
#include "options/option.h"
#include "options/renderer_kind.h"

namespace ps::parting {

/// Both sides and what they are about, as the steps of the comparison hand it on.
struct StoryPair {
  const Scene& scene;
  const StorySide& a;
  const StorySide& b;
  double slack = 0;  ///< least tolerance; for a first look at what is far more than rounding
  SceneTraits traits = scene_traits(scene);
  /// One of the two is a textbook listing, with the events of the renderer whose steps it takes.
  bool with_listing() const { return a.story.listing || b.story.listing; }
  bool both_rays() const { return sends_rays(a.story.renderer) && sends_rays(b.story.renderer); }
  bool both_fragments() const { return draws_fragments(a.story.renderer) && draws_fragments(b.story.renderer); }
  /// Two renderers that share their triangles but not their arithmetic.
  bool two_rasterizers() const { return both_fragments() && !with_listing() && a.story.renderer != b.story.renderer; }
  /// Two renderers that make the same surface of different things.
  bool two_ways() const { return a.story.renderer != b.story.renderer && !two_rasterizers(); }
  /// Relative difference below which two numbers count as the same. Renderers that share their arithmetic must agree to
  /// the last bit; other arithmetic, or a ray that starts a little elsewhere, moves all that follows in the last
  /// digits; a ray and a fragment see a point through other roundings, and snapped vertices move it a little more.
  double tolerance() const;
  bool same(double x, double y) const;
  bool same(const Vec3d& x, const Vec3d& y) const;
};

template <class T>
const T* event_at(const PixelStory& story, int index) {
  return index < 0 ? nullptr : std::get_if<T>(&story.events[static_cast<std::size_t>(index)].data);
}

/// Can the option with this key be what makes A and B different? It has another value in B, and both sides act on
/// theirs. An option that one side alone acts on counts where its value there is not the default; elsewhere it is the
/// renderer that makes the difference, or the option that keeps the other side from acting on it.
bool explains(const StoryPair& c, std::string_view key);
/// "fill-rule is top-left in A and inclusive in B", or "mip-bias is 2 in B, and A does not use it".
std::string option_difference(const StoryPair& c, std::string_view key);
/// The same for the first of `keys` that explains a difference, after ": "; nothing if none does.
std::string because(const StoryPair& c, std::initializer_list<std::string_view> keys);
/// ": " and the difference of this option; nothing for nullptr.
std::string because(const StoryPair& c, const Option* option);
/// The first option of these groups of the table that changes pictures and explains a difference, else nullptr. What
/// two renderers do differently is no cause where there is such an option.
const Option* differing_option(const StoryPair& c, std::initializer_list<std::string_view> groups);
/// That of the options that decide visibility: those of the camera, of samples, visibility and drawing. Nullptr
/// beside a listing, which has rules of its own for them.
const Option* differing_in_what_is_seen(const StoryPair& c);
/// All options that change pictures and explain a difference: "draw is filled in A and points in B, ...".
std::string all_differences(const StoryPair& c);

/// The steps, each in a file of its own; nullopt if that step does not part the stories.
std::optional<Parting> part_at_winner(const StoryPair& c, const Sighting& a, const Sighting& b);
std::optional<Parting> part_at_point(const StoryPair& c, const Sighting& a, const Sighting& b);
std::optional<Parting> part_at_texture(const StoryPair& c, const Sighting& a, const Sighting& b);
std::optional<Parting> part_at_light(const StoryPair& c, const Sighting& a, const Sighting& b);

/// Where the light of a pixel was computed: at the pixel, at the vertices of its triangle or at the triangle's centre.
struct LightPlaces {
  bool differ = false;      ///< not at the same places in A and B
  bool same_light = false;  ///< but with the same result
  std::string text;         ///< what each side does, with its numbers; without a full stop
};
LightPlaces light_places(const StoryPair& c, const Sighting& a, const Sighting& b);

/// Why two rays saw different things, two fragments won, or a ray and a fragment differ.
Parting rays_saw_different_things(const StoryPair& c, const Sighting& a, const Sighting& b);
Parting fragments_won_differently(const StoryPair& c, const Sighting& a, const Sighting& b);
Parting ray_and_fragment_differ(const StoryPair& c, const Sighting& a, const Sighting& b);

}  // namespace ps::parting
