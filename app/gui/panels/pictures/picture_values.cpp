#include "gui/panels/pictures/picture_values.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <utility>

namespace ps::gui {
namespace {

/// FNV-1a over the displayed levels: equal pictures have equal hashes, on every machine.
std::uint64_t picture_hash(const Image<Rgb8>& levels) {
  std::uint64_t hash = 14695981039346656037ull;
  const auto add = [&](std::uint8_t byte) { hash = (hash ^ byte) * 1099511628211ull; };
  for (const Rgb8& level : levels.pixels()) {
    add(level.r);
    add(level.g);
    add(level.b);
  }
  return hash;
}

/// Hash of the picture that was shown last when no tiles were arriving: large pictures take long to add up.
std::uint64_t hash_of(Session& session, PicturesState& pictures, Side side) {
  const std::size_t index = index_of(side);
  const RenderState state = session.renderer(side).status().state;
  const bool rendering = state == RenderState::coarse || state == RenderState::full;
  if (pictures.sides.fresh[index] && !rendering) {
    pictures.sides.hashes[index] = picture_hash(pictures.pictures[index].levels);
    pictures.sides.fresh[index] = false;
  }
  return pictures.sides.hashes[index];
}

}  // namespace

void offer_picture_values(Values& out, Session& session, PicturesState& pictures) {
  for (const Side side : both_sides) {
    const std::string name = side == Side::a ? "a/" : "b/";
    out.offer(name + "picture",
              [&session, &pictures, side] { return fmt::format("{:016x}", hash_of(session, pictures, side)); });
    out.offer(name + "picture-before", [&session, &pictures, side] {
      const ShownPicture* before = pictures.sides.before[index_of(side)].before(session.change());
      return before ? fmt::format("{:016x}", picture_hash(before->levels)) : "none";
    });
    out.offer(name + "size", [&pictures, side] {
      const auto& levels = pictures.pictures[index_of(side)].levels;
      return fmt::format("{}x{}", levels.width(), levels.height());
    });
  }
  out.offer("identical", [&session, &pictures] {
    return hash_of(session, pictures, Side::a) == hash_of(session, pictures, Side::b);
  });
  out.offer("difference/levels", [&pictures] {
    if (std::exchange(pictures.difference.fresh, false))
      pictures.difference.hash = picture_hash(pictures.difference.picture.levels);
    return fmt::format("{:016x}", pictures.difference.hash);
  });
  out.offer("difference/measured", [&pictures] {
    const auto measured = pictures.difference.meter->result();
    return measured ? fmt::format("{}", error_of(measured->comparison, pictures.difference.metric)) : "none";
  });
  out.offer("zoom", [&pictures] { return pictures.drawn.transform.zoom; });
  out.offer("window/pictures-share", [&pictures] {
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    return 100 * pixels_on_screen(pictures) / std::max(static_cast<double>(window.x) * window.y, 1.0);
  });
  offer_slow_motion_values(session, pictures.slow);
  out.offer("flying", [&pictures] { return flying(pictures); });
  out.offer("flicker", [&pictures] { return pictures.keys.flip; });
}

}  // namespace ps::gui
