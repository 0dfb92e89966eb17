#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "record/value_text.h"
#include "render/story/display_lines.h"
#include "render/story/finish_story.h"
#include "render/story/light_terms.h"
#include "render/story/names.h"
#include "render/story/story_tree.h"
#include "render/story/write_mixing.h"

namespace ps {
namespace {

using Term = LedgerTerm;
using Lines = std::vector<LedgerLine>;

void append(Lines& lines, Lines more) {
  for (LedgerLine& line : more) lines.push_back(std::move(line));
}

void add_ray(const PixelStory& story, const Scene& scene, int ray, double share, int level, Lines& lines);

void add_rays_of_kind(const PixelStory& story, const Scene& scene, int ray, RayKind kind, double share, int level,
                      Lines& lines) {
  for (const int child : events_of_ray<RayEvent>(story.events, ray))
    if (event_as<RayEvent>(story.events, child).kind == kind) add_ray(story, scene, child, share, level, lines);
}

/// "reflected colour", or the picture that it was read from. `texture` is the event of that reading, or -1.
std::string reflected_text(const PixelStory& story, const Scene& scene, int texture, const std::string& otherwise) {
  if (texture < 0) return otherwise;
  const int map = event_as<TextureEvent>(story.events, texture).texture;
  return "colour from its reflection map " + scene.textures->at(static_cast<std::size_t>(map)).name;
}

/// The reading of a reflection map for the surface that a ray has hit, or -1.
int reflection_read(const std::vector<Event>& events, int ray) {
  for (const int read : events_of_ray<TextureEvent>(events, ray))
    if (event_as<TextureEvent>(events, read).use == TextureUse::reflection) return read;
  return -1;
}

/// A transparent surface: local, reflected and transmitted colour, each times its share (CGFS ch. 5).
void add_boundary(const PixelStory& story, const Scene& scene, int ray, int index, const ShadingEvents& shading,
                  double share, int level, Lines& lines) {
  const auto& event = event_as<RefractionEvent>(story.events, index);
  const std::string name = primitive_name(scene, shading.id);
  if (event.own_share > 0) {
    lines.push_back({level, Term::local, fmt::format("{}: {} x local colour", name, number_text(event.own_share)),
                     share * event.own_share * event.local, shading.shade});
    append(lines, light_terms(story, scene, shading, share * event.own_share, level + 1));
  }
  if (event.mirrored_share > 0) {
    lines.push_back({level, Term::reflected,
                     fmt::format("{}: {} x {}{}", name, number_text(event.mirrored_share),
                                 reflected_text(story, scene, reflection_read(story.events, ray), "reflected colour"),
                                 event.total ? " (total internal reflection)" : ""),
                     share * event.mirrored_share * event.mirrored, index});
    add_rays_of_kind(story, scene, ray, RayKind::reflection, share * event.mirrored_share, level + 1, lines);
  }
  if (event.refracted_share > 0) {
    lines.push_back({level, Term::transmitted,
                     fmt::format("{}: {} x transmitted colour", name, number_text(event.refracted_share)),
                     share * event.refracted_share * event.refracted, index});
    add_rays_of_kind(story, scene, ray, RayKind::refraction, share * event.refracted_share, level + 1, lines);
  }
}

/// The colour returned by ray `ray`, as it reaches the pixel: local colour * (1 - r) + reflected colour * r (CGFS
/// ch. 4), the second term unfolded ray by ray.
void add_ray(const PixelStory& story, const Scene& scene, int ray, double share, int level, Lines& lines) {
  const auto& events = story.events;
  const auto hits = events_of_ray<HitEvent>(events, ray);
  const auto shades = events_of_ray<ShadeEvent>(events, ray);
  if (hits.empty() || shades.empty()) {
    for (const int miss : events_of_ray<MissEvent>(events, ray))
      lines.push_back({level, Term::background,
                       fmt::format("background{}", share == 1 ? "" : " x " + number_text(share)),
                       share * event_as<MissEvent>(events, miss).background, miss});
    return;
  }
  const ShadingEvents shading{
      shades.back(), events_of_ray<LightEvent>(events, ray), {}, event_as<HitEvent>(events, hits.back()).id};
  const Vec3d local = event_as<ShadeEvent>(events, shading.shade).local;
  const std::string name = primitive_name(scene, shading.id);
  const auto boundaries = events_of_ray<RefractionEvent>(events, ray);
  if (!boundaries.empty()) return add_boundary(story, scene, ray, boundaries.back(), shading, share, level, lines);
  const auto mirrors = events_of_ray<ReflectionEvent>(events, ray);
  if (mirrors.empty()) {
    lines.push_back({level, Term::local, fmt::format("{}: local colour", name), share * local, shading.shade});
    append(lines, light_terms(story, scene, shading, share, level + 1));
    return;
  }
  const auto& mirror = event_as<ReflectionEvent>(events, mirrors.back());
  const double own = 1 - mirror.reflective;
  lines.push_back({level, Term::local, fmt::format("{}: {} x local colour", name, number_text(own)),
                   share * own * local, shading.shade});
  append(lines, light_terms(story, scene, shading, share * own, level + 1));
  lines.push_back({level, Term::reflected,
                   fmt::format("{}: {} x {}", name, number_text(mirror.reflective),
                               reflected_text(story, scene, reflection_read(events, ray), "reflected colour")),
                   share * mirror.reflective * mirror.reflected, mirrors.back()});
  add_rays_of_kind(story, scene, ray, RayKind::reflection, share * mirror.reflective, level + 1, lines);
}

/// A pixel of a row is a mix of the row's ends (LAB 4).
Lines row_lines(const PixelStory& story, int polygon, double share, int level) {
  const auto& event = event_as<PolygonEvent>(story.events, polygon);
  const PolygonRowSpan& row = *event.row;
  const auto end = [&](Term kind, std::size_t i, std::string_view name, int column, double weight) {
    return LedgerLine{level, kind,
                      fmt::format("{} end of the row, x = {} on edge {} at {}: {} x {}", name, column, row.edges[i],
                                  number_text(row.along_edges[i]), number_text(weight),
                                  vector_text(row.end_colours[i])),
                      share * weight * row.end_colours[i], polygon};
  };
  return {end(Term::left_end, 0, "left", row.left, 1 - row.along_row),
          end(Term::right_end, 1, "right", row.right, row.along_row)};
}

/// How the colour that write `index` brought was made, by what the kernel reported since its fragment began, scaled by
/// `share`.
Lines shading_of_write(const PixelStory& story, const Scene& scene, int index, double share, int level) {
  const int parent = story.events[static_cast<std::size_t>(index)].parent;
  if (parent >= 0)
    if (const auto* polygon = std::get_if<PolygonEvent>(&story.events[static_cast<std::size_t>(parent)].data);
        polygon && polygon->row)
      return row_lines(story, parent, share, level);
  ShadingEvents shading;
  int mirror = -1, reflection_map = -1;
  shading.id = event_as<WriteEvent>(story.events, index).id;
  for (int i = index - 1; i >= 0; --i) {
    const EventData& data = story.events[static_cast<std::size_t>(i)].data;
    if (std::holds_alternative<FragmentEvent>(data) || std::holds_alternative<WriteEvent>(data)) break;
    if (std::holds_alternative<ShadeEvent>(data) && shading.shade < 0) shading.shade = i;
    if (std::holds_alternative<ReflectionEvent>(data) && mirror < 0) mirror = i;
    const auto* texture = std::get_if<TextureEvent>(&data);
    if (texture && texture->use == TextureUse::reflection && reflection_map < 0) reflection_map = i;
    if (std::holds_alternative<LightEvent>(data)) shading.lights.insert(shading.lights.begin(), i);
    if (std::holds_alternative<VertexLightEvent>(data)) shading.points.insert(shading.points.begin(), i);
  }
  if (mirror < 0) return shading.shade < 0 ? Lines{} : light_terms(story, scene, shading, share, level);
  const auto& event = event_as<ReflectionEvent>(story.events, mirror);
  const double own = 1 - event.reflective;
  Lines lines{
      {level, Term::local, fmt::format("{} x local colour", number_text(own)), share * own * event.local, mirror}};
  if (shading.shade >= 0) append(lines, light_terms(story, scene, shading, share * own, level + 1));
  lines.push_back({level, Term::reflected,
                   fmt::format("{} x {}", number_text(event.reflective),
                               reflected_text(story, scene, reflection_map, "colour from its cube map")),
                   share * event.reflective * event.reflected, mirror});
  return lines;
}

/// The numbers of the samples that write `index` reached, with multisampling: the kernel reports them with it.
const CoverageEvent* written_samples(const PixelStory& story, int index) {
  const int parent = story.events[static_cast<std::size_t>(index)].parent;
  const FragmentEvent* fragment =
      parent < 0 ? nullptr : std::get_if<FragmentEvent>(&story.events[static_cast<std::size_t>(parent)].data);
  if (!fragment || fragment->samples < 2) return nullptr;
  for (int i = index - 1; i > parent; --i)
    if (const auto* coverage = std::get_if<CoverageEvent>(&story.events[static_cast<std::size_t>(i)].data))
      return coverage;
  return nullptr;
}

/// Puts a write that is blended over `lines`: they go on as what is left of them.
void add_blended(const PixelStory& story, const Scene& scene, int index, Lines& lines) {
  const auto& write = event_as<WriteEvent>(story.events, index);
  const double left = 1 - write.opacity;
  LedgerLine below{0, Term::what_was_there, fmt::format("{} x what was there", number_text(left)), Vec3d(0), index};
  for (LedgerLine& line : lines) {
    line.value *= left;
    if (line.level++ == 0) below.value += line.value;
  }
  Lines blended{{0, Term::colour,
                 fmt::format("{}: {} x colour", primitive_name(scene, write.id), number_text(write.opacity)),
                 write.opacity * write.shaded, index}};
  append(blended, shading_of_write(story, scene, index, write.opacity, 1));
  blended.push_back(below);
  append(blended, std::exchange(lines, {}));
  lines = std::move(blended);
}

/// The samples of a pixel that is drawn with multisampling, and which writes each of them shows: the last one, and what
/// it is blended with.
class SampleOwners {
 public:
  void write(const PixelStory& story, const CoverageEvent& samples, int index) {
    if (owners_.empty()) owners_.resize(static_cast<std::size_t>(samples.tests));
    const bool replaces = mixing_of(event_as<WriteEvent>(story.events, index)) != Mixing::blends;
    for (const double sample : samples.values) {
      std::vector<int>& writes = owners_.at(static_cast<std::size_t>(sample));
      if (replaces) writes.clear();
      writes.push_back(index);
    }
  }
  /// The pixel as the mean of its samples, with one line for all samples that show the same.
  Lines lines(const PixelStory& story, const Scene& scene) const {
    Lines lines;
    std::vector<std::vector<int>> order(owners_);
    std::sort(order.begin(), order.end());
    order.erase(std::unique(order.begin(), order.end()), order.end());
    for (const std::vector<int>& writes : order) {
      const auto count = std::count(owners_.begin(), owners_.end(), writes);
      const double share = static_cast<double>(count) / static_cast<double>(owners_.size());
      const std::string of = fmt::format("on {} of {} samples", count, owners_.size());
      for (LedgerLine& line : lines_of(story, scene, writes)) {
        line.value *= share;
        if (line.level == 0) line.term += " " + of;
        lines.push_back(std::move(line));
      }
    }
    return lines;
  }

 private:
  static Lines lines_of(const PixelStory& story, const Scene& scene, const std::vector<int>& writes) {
    Lines lines{{0, Term::background, "background", scene.background, -1}};
    for (const int index : writes) {
      const auto& write = event_as<WriteEvent>(story.events, index);
      if (mixing_of(write) == Mixing::blends) {
        add_blended(story, scene, index, lines);
        continue;
      }
      lines = {{0, Term::colour, fmt::format("{}: colour", primitive_name(scene, write.id)), write.shaded, index}};
      append(lines, shading_of_write(story, scene, index, 1, 1));
    }
    return lines;
  }

  std::vector<std::vector<int>> owners_;  // the writes that each sample shows
};

void add_write(const PixelStory& story, const Scene& scene, int index, Lines& lines) {
  const auto& write = event_as<WriteEvent>(story.events, index);
  const std::string name = write.id.object >= 0 ? primitive_name(scene, write.id) : "shape on the canvas";
  switch (mixing_of(write)) {
  case Mixing::replaces:
    lines.clear();
    lines.push_back({0, Term::colour, fmt::format("{}: colour", name), write.shaded, index});
    append(lines, shading_of_write(story, scene, index, 1, 1));
    return;
  case Mixing::adds:
    if (lines.empty()) lines.push_back({0, Term::background, "background", write.before, index});
    lines.push_back({0, Term::colour, fmt::format("{}: added colour", name), write.shaded, index});
    append(lines, shading_of_write(story, scene, index, 1, 1));
    return;
  case Mixing::filters:
    lines.clear();
    lines.push_back({0, Term::colour,
                     fmt::format("{}: {} multiplied by {}", name, vector_text(write.shaded), vector_text(write.before)),
                     write.after, index});
    return;
  case Mixing::blends:
    if (lines.empty()) lines.push_back({0, Term::background, "background", write.before, index});
    add_blended(story, scene, index, lines);
    return;
  }
}

/// A line for what rounding does to a sum of `lines` (level 0) that should be `total`: the kernel adds in its own
/// precision.
void add_rounding(Lines& lines, const Vec3d& total, int event) {
  Vec3d sum{0, 0, 0};
  for (const LedgerLine& line : lines)
    if (line.level == 0) sum += line.value;
  if (sum != total) lines.push_back({0, Term::rounding, "rounding of the sum", total - sum, event});
}

/// The pixel as the mean of its samples (CGFS ch. 5), those with a story of their own unfolded.
Lines sample_lines(const PixelStory& story, const Scene& scene, const std::vector<int>& samples) {
  Lines lines;
  for (const int index : samples) {
    const auto& sample = event_as<SampleEvent>(story.events, index);
    lines.push_back({0, Term::sample,
                     fmt::format("sample {} of {} at {}: weight {}, colour {}", sample.index + 1, sample.count,
                                 vector_text(sample.position), number_text(sample.weight), vector_text(sample.colour)),
                     sample.weight * sample.colour, index});
    for (int i = index + 1; i < static_cast<int>(story.events.size()); ++i) {
      const Event& event = story.events[static_cast<std::size_t>(i)];
      if (event.parent == index && std::holds_alternative<RayEvent>(event.data))
        add_ray(story, scene, i, sample.weight, 1, lines);
      if (event.parent < index) break;
    }
  }
  return lines;
}

Lines fragment_lines(const PixelStory& story, const Scene& scene) {
  Lines lines;
  bool written = false;
  SampleOwners samples;
  for (int i = 0; i < static_cast<int>(story.events.size()); ++i) {
    const EventData& data = story.events[static_cast<std::size_t>(i)].data;
    if (std::holds_alternative<WriteEvent>(data)) {
      if (const CoverageEvent* reached = written_samples(story, i)) {
        samples.write(story, *reached, i);
        lines = samples.lines(story, scene);
      } else {
        add_write(story, scene, i, lines);
      }
      written = true;
    }
    if (const auto* line = std::get_if<LineEvent>(&data)) {
      lines = {{0, Term::edge,
                line->id.object >= 0 ? fmt::format("edge of {}", primitive_name(scene, line->id)) : "line",
                line->colour, i}};
      written = true;
    }
  }
  if (!written) lines.push_back({0, Term::background, "background", story.linear, -1});
  return lines;
}

}  // namespace

std::vector<LedgerLine> story_ledger(const PixelStory& story, const Scene& scene, const Settings& settings) {
  Lines lines;
  const int eye = eye_ray(story.events);
  if (const auto samples = events_of_ray<SampleEvent>(story.events, -1); !samples.empty())
    lines = sample_lines(story, scene, samples);
  else if (eye >= 0)
    add_ray(story, scene, eye, 1, 0, lines);
  else
    lines = fragment_lines(story, scene);
  add_rounding(lines, story.linear, static_cast<int>(story.events.size()) - 1);
  append(lines, display_lines(story, settings));
  return lines;
}

}  // namespace ps
