#pragma once
#include <optional>
#include <span>
#include <string_view>

#include "options/idle_reason.h"
#include "options/settings.h"

namespace ps {

struct Option;
struct SceneTraits;

/// How a renderer goes about a picture. What lies above the renderers asks for this and never for one of them by name,
/// so that another renderer needs no change there.
enum class PictureWay {
  rays,       ///< which surface does the ray of a pixel meet first?
  fragments,  ///< which pixels does a triangle cover?
  listing     ///< as the listing of a lesson does, line by line
};

/// For which renderers an option acts, by their way of making pictures. Combined with |.
enum class ActsFor : unsigned {
  readers = 0,  ///< only for listings that read it
  rays = 1u << 0,
  fragments = 1u << 1,
  listings = 1u << 2,                     ///< for every listing, whatever it reads
  picture = rays | fragments | listings,  ///< whatever makes the picture
};
constexpr ActsFor operator|(ActsFor a, ActsFor b) {
  return static_cast<ActsFor>(static_cast<unsigned>(a) | static_cast<unsigned>(b));
}
bool acts_for(ActsFor set, PictureWay way);

/// The facts about a renderer for the option table and all above it. The rest is in its row (record/renderer_row.h).
struct RendererKind {
  std::string_view key;    ///< for files and the command line: "ray-tracer"
  std::string_view label;  ///< for people: "ray tracer"
  std::string_view help;   ///< one sentence
  PictureWay way = PictureWay::rays;
  /// Whether it uses an option, whatever the option's row says of its way; nullopt: as the row says. May be nullptr.
  std::optional<bool> (*reads)(const Option&, const Settings&, const SceneTraits&) = nullptr;
  std::string_view unread{};  ///< said of options that it does not use: "the listing does not use it"
  /// Why it does not use an option that its way of making pictures knows, or nothing. May be nullptr: it uses all.
  std::optional<IdleReason> (*lacks_option)(const Option&, const Settings&) = nullptr;
  /// Why it cannot act on this value of an option that it uses, or nothing. May be nullptr: it acts on all values.
  std::optional<IdleReason> (*lacks_value)(const Option&, double value, const Settings&) = nullptr;
  /// Why it cannot make pictures on this machine, or nothing. May be nullptr: it always can.
  std::optional<IdleReason> (*inactive)(const Settings&, const SceneTraits&) = nullptr;
  bool added = false;  ///< by a program, to those of core; add_renderer_kind() says so
};

/// All renderers, in the order of their numbers.
std::span<const RendererKind> renderer_kinds();
const RendererKind& renderer_kind(Renderer renderer);

/// Adds a renderer and returns its number. Only before the option table is first asked for, whose option `renderer`
/// lists them all: add_renderer() in render/renderer_table.h is the way in for programs.
Renderer add_renderer_kind(const RendererKind& kind);

/// The first renderer that makes pictures this way.
Renderer renderer_for(PictureWay way);

inline PictureWay picture_way(Renderer renderer) { return renderer_kind(renderer).way; }
/// Its name for people: "ray tracer".
inline std::string_view renderer_label(Renderer renderer) { return renderer_kind(renderer).label; }

inline bool sends_rays(Renderer renderer) { return picture_way(renderer) == PictureWay::rays; }
inline bool draws_fragments(Renderer renderer) { return picture_way(renderer) == PictureWay::fragments; }
inline bool runs_listing(Renderer renderer) { return picture_way(renderer) == PictureWay::listing; }

}  // namespace ps
