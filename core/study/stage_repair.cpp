#include "study/stage_repair.h"

#include <algorithm>
#include <cmath>

#include "frame/display_frame.h"
#include "image/difference.h"
#include "options/option.h"
#include "render/renderer_table.h"

namespace ps {
namespace {

using raster::CoveringTriangle;
using raster::GivenFragment;
using raster::ReplayMaps;

std::shared_ptr<const StageValues> stages_of(const WorkingScene& working, Prepared& prepared, StudyControl& control) {
  return renderer_row(working.settings().renderer)
      .stage_values(working.scene(), working.view(), working.settings(), prepared, control.progress());
}

std::size_t place_of(const std::vector<CoveringTriangle>& covering, const PixelId& id) {
  const auto found =
      std::find_if(covering.begin(), covering.end(), [&](const CoveringTriangle& c) { return c.id == id; });
  return static_cast<std::size_t>(found - covering.begin());
}

}  // namespace

Settings honoured_settings(const Settings& settings, const StageValues& stages) {
  const RendererKind& kind = renderer_kind(settings.renderer);
  Settings honoured = settings;
  for (const Option& option : option_table()) {
    const bool lacks = (kind.lacks_option && kind.lacks_option(option, settings)) ||
                       (kind.lacks_value && kind.lacks_value(option, option.get(settings), settings));
    if (lacks) option.set(honoured, option.default_value());
  }
  honoured.subpixel_bits = stages.subpixel_bits;
  honoured.threads = settings.threads;
  honoured.simd = settings.simd;
  honoured.renderer = renderer_for(PictureWay::fragments);
  return honoured;
}

StageRepair::StageRepair(const StageRequest& request, Prepared& prepared, StudyControl& control)
    : request_(request), working_(request.scene, request.view, request.other, prepared), control_(control),
      stages_(stages_of(working_, prepared, control)),
      replay_(request.scene, request.view, request.ours, prepared, control.progress()) {
  replay_.give_maps(stages_->shadow_maps, stages_->environment, stages_->in_shadow);
  const Settings honoured = honoured_settings(request.other, *stages_);
  Settings ours = request.ours;
  ours.renderer = honoured.renderer;
  if (!(ours == honoured)) {
    const Frame without = render(request.scene, request.view, honoured, {}, prepared, control.progress());
    without_effects_ = display_frame(without, honoured);
  }
}

bool StageRepair::equal(const Pixel& pixel, const Vec3f& colour) const {
  const Rgb8 levels = display_pixel(Vec3d(colour), display_transform(request_.ours));
  return largest_difference(levels, pixel.wanted) <= request_.bound;
}

const CoveringTriangle* StageRepair::same_in_both(const Pixel& pixel) {
  if (!pixel.ours || *pixel.ours != pixel.theirs) return nullptr;
  return &pixel.covering[place_of(pixel.covering, *pixel.ours)];
}

std::optional<CoveringTriangle> StageRepair::piece_of(const PixelId& id, Vec2i pixel) {
  if (id.object < 0) return {};
  auto piece = replay_.nearest_piece(id, pixel);
  return piece ? piece : replay_.uncut(id, pixel);
}

/// Do these triangles show what theirs shows?
bool StageRepair::shows(const Pixel& pixel, const Covering& covering) const {
  const int winner = replay_.winner(covering);
  if (winner < 0) return pixel.theirs.object < 0 && equal(pixel, replay_.background(pixel.at));
  const CoveringTriangle& seen = covering[static_cast<std::size_t>(winner)];
  return seen.id == pixel.theirs && equal(pixel, replay_.shade(seen, pixel.at));
}

std::optional<float> StageRepair::their_depth(const PixelId& id, Vec2i pixel) {
  if (id.object < 0) return {};
  if (stages_->seen.triangles.at(pixel.x, pixel.y) == id) return stages_->seen.depth.at(pixel.x, pixel.y);
  const std::pair<int, int> key{id.object, id.triangle};
  auto found = alone_.find(key);
  if (found == alone_.end()) {
    control_.wait_here();
    StageValues::SeenAlone drawn = stages_->draw_alone(id);
    constexpr std::size_t most_kept = std::size_t{16} << 20;  // depths, 64 MiB: large triangles cover many pixels
    alone_size_ += drawn.depth.pixels().size();
    if (alone_size_ > most_kept) {
      alone_.clear();
      alone_size_ = drawn.depth.pixels().size();
    }
    found = alone_.emplace(key, std::move(drawn)).first;
  }
  return found->second.at(pixel);
}

/// Has clipping cut the triangle, or left nothing of it that is not turned away?
bool StageRepair::was_cut(const PixelId& id, Vec2i pixel) {
  if (id.object < 0) return false;
  const auto piece = replay_.nearest_piece(id, pixel);
  return piece ? piece->cut : replay_.uncut(id, pixel).has_value();
}

StageRepair::Covering StageRepair::with_their_coverage(const Pixel& pixel, Touched touched) {
  const auto counts = [&](const PixelId& id) { return was_cut(id, pixel.at) == (touched == Touched::cut); };
  Covering covering = pixel.covering;
  if (pixel.ours && counts(*pixel.ours) && !their_depth(*pixel.ours, pixel.at))
    std::erase_if(covering, [&](const CoveringTriangle& c) { return c.id == *pixel.ours; });
  if (pixel.theirs.object >= 0 && place_of(covering, pixel.theirs) == covering.size() && counts(pixel.theirs)) {
    // In drawing order, which decides between equal depths.
    if (const auto piece = piece_of(pixel.theirs, pixel.at)) {
      const auto later = std::find_if(covering.begin(), covering.end(), [&](const CoveringTriangle& c) {
        return std::pair(c.id.object, c.id.triangle) > std::pair(piece->id.object, piece->id.triangle);
      });
      covering.insert(later, *piece);
    }
  }
  return covering;
}

bool StageRepair::depths_prefer_theirs(const Pixel& pixel) {
  if (!pixel.ours) return false;
  const auto theirs = their_depth(pixel.theirs, pixel.at), ours = their_depth(*pixel.ours, pixel.at);
  if (!theirs || !ours) return false;
  if (*theirs == *ours) return true;  // whichever was drawn first
  return stages_->larger_is_nearer ? *theirs > *ours : *theirs < *ours;
}

StageRepair::Covering StageRepair::without_ours(const Pixel& pixel, const Covering& covering) {
  Covering rest = covering;
  std::erase_if(rest, [&](const CoveringTriangle& c) { return pixel.ours && c.id == *pixel.ours; });
  return rest;
}

GivenFragment StageRepair::interpolated(Vec2i pixel) const {
  const auto at = [&]<class T>(const Image<T>& image) -> std::optional<T> {
    if (image.empty()) return {};
    return image.at(pixel.x, pixel.y);
  };
  GivenFragment given;
  given.z = at(stages_->seen.z);
  given.position = at(stages_->position);
  given.normal = at(stages_->normal);
  given.uv = at(stages_->uv);
  given.light = at(stages_->light);
  given.extra = at(stages_->extra);
  return given;
}

void StageRepair::add_texels(Vec2i pixel, GivenFragment& given) const {
  const auto at = [&](const Image<Vec3f>& image) -> std::optional<Vec3f> {
    if (image.empty()) return {};
    return image.at(pixel.x, pixel.y);
  };
  given.surface = at(stages_->surface);
  given.mapped_normal = at(stages_->mapped_normal);
  given.specular = at(stages_->specular);
  given.ambient = at(stages_->ambient);
}

bool StageRepair::coverage(Pixel& pixel) {
  if (pixel.ours.value_or(PixelId{}) != pixel.theirs) {
    const Covering covering = with_their_coverage(pixel, Touched::whole);
    return covering != pixel.covering && shows(pixel, covering);
  }
  // The same triangle: its stencil, which the faces of shadow volumes have counted in.
  const CoveringTriangle* seen = same_in_both(pixel);
  return seen && !stages_->in_shadow.empty() && equal(pixel, replay_.shade(*seen, pixel.at, {}, ReplayMaps::given));
}

bool StageRepair::depth(Pixel& pixel) {
  if (pixel.ours.value_or(PixelId{}) == pixel.theirs || place_of(pixel.covering, pixel.theirs) == pixel.covering.size())
    return false;
  return depths_prefer_theirs(pixel) && shows(pixel, without_ours(pixel, pixel.covering));
}

bool StageRepair::clipping(Pixel& pixel) {
  if (pixel.ours.value_or(PixelId{}) != pixel.theirs) {
    const Covering covering = with_their_coverage(pixel, Touched::cut);
    return covering != pixel.covering && shows(pixel, covering);
  }
  const CoveringTriangle* seen = same_in_both(pixel);
  return seen && seen->cut && equal(pixel, replay_.shade(*seen, pixel.at, replay_.whole_triangle_at(*seen, pixel.at)));
}

bool StageRepair::interpolation(const Pixel& pixel) {
  const CoveringTriangle* seen = same_in_both(pixel);
  return seen && equal(pixel, replay_.shade(*seen, pixel.at, interpolated(pixel.at)));
}

bool StageRepair::filtering(const Pixel& pixel) {
  const CoveringTriangle* seen = same_in_both(pixel);
  if (!seen) return false;
  GivenFragment given;
  add_texels(pixel.at, given);
  // A stencil is not a texture: coverage() has tried it.
  const ReplayMaps maps = stages_->in_shadow.empty() ? ReplayMaps::given : ReplayMaps::own;
  return equal(pixel, replay_.shade(*seen, pixel.at, given, maps));
}

bool StageRepair::missing_effect(const Pixel& pixel) const {
  return !without_effects_.empty() &&
         largest_difference(without_effects_.at(pixel.at.x, pixel.at.y), pixel.wanted) <= request_.bound;
}

// Values of all stages up to one, from the first on.
std::optional<StageCause> StageRepair::together(Pixel& pixel) {
  if (depths_prefer_theirs(pixel) && shows(pixel, without_ours(pixel, with_their_coverage(pixel, Touched::whole))))
    return StageCause::depth_tie;
  const auto piece = piece_of(pixel.theirs, pixel.at);
  if (!piece) return {};
  if (piece->cut && equal(pixel, replay_.shade(*piece, pixel.at, replay_.whole_triangle_at(*piece, pixel.at))))
    return StageCause::clipping;
  GivenFragment given = interpolated(pixel.at);
  const bool stencil = !stages_->in_shadow.empty();
  if (equal(pixel, replay_.shade(*piece, pixel.at, given, stencil ? ReplayMaps::given : ReplayMaps::own)))
    return StageCause::interpolation;
  add_texels(pixel.at, given);
  if (equal(pixel, replay_.shade(*piece, pixel.at, given, ReplayMaps::given))) return StageCause::filtering;
  return {};
}

double StageRepair::edge_distance(const Pixel& pixel) const {
  if (same_in_both(pixel)) return 0;  // their stencils differ
  double least = INFINITY;
  for (const PixelId& id : {pixel.theirs, pixel.ours.value_or(PixelId{})})
    if (const auto piece = replay_.nearest_piece(id, pixel.at))
      least = std::min(least, std::abs(replay_.within_edges(*piece, pixel.at)));
  return least;
}

RepairedPixel StageRepair::cause_of(Vec2i at, const Rgb8& wanted) {
  Pixel pixel{at, wanted, stages_->seen.triangles.at(at.x, at.y), replay_.covering(at), {}};
  if (const int winner = replay_.winner(pixel.covering); winner >= 0)
    pixel.ours = pixel.covering[static_cast<std::size_t>(winner)].id;
  if (coverage(pixel)) return {StageCause::coverage, edge_distance(pixel)};
  if (depth(pixel)) return {StageCause::depth_tie};
  if (clipping(pixel)) return {StageCause::clipping};
  if (interpolation(pixel)) return {StageCause::interpolation};
  if (filtering(pixel)) return {StageCause::filtering};
  if (missing_effect(pixel)) return {StageCause::missing_effect};
  return {together(pixel).value_or(StageCause::unexplained)};
}

}  // namespace ps
