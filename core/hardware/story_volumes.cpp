#include <epoxy/gl.h>

#include <algorithm>

#include "base/stop.h"
#include "hardware/definitions.h"
#include "hardware/story_drawer.h"

namespace ps::hardware {
namespace {

/// A side of a shadow volume as the story has it, but for what the driver reports.
VolumeCrossing crossing_of(const raster::ShadowVolume& volume, std::size_t triangle) {
  VolumeCrossing crossing;
  crossing.object = volume.object;
  if (triangle < volume.caps) {
    crossing.part = triangle % 2 == 0 ? VolumePart::lit_face : VolumePart::far_end;
    return crossing;
  }
  const raster::SilhouetteEdge& edge = volume.silhouette[volume.edge_of_side[triangle - volume.caps]];
  crossing.part = VolumePart::side;
  crossing.edge_from = edge.from;
  crossing.edge_to = edge.to;
  return crossing;
}

}  // namespace

// Halves the list until single faces are left: all that the driver reports of a draw is whether it wrote something.
void StoryDrawer::find_faces(int first, int count, unsigned sample, std::vector<int>& found) const {
  check_stop();
  const auto draw = [&] { glDrawArrays(GL_TRIANGLES, 3 * first, 3 * count); };
  if (count == 0 || count_samples(sample, draw) == 0) return;
  if (count == 1) return found.push_back(first);
  find_faces(first, count / 2, sample, found);
  find_faces(first + count / 2, count - count / 2, sample, found);
}

std::optional<VolumeCrossing> StoryDrawer::crossing(const raster::ShadowVolume& volume, const VolumeBuffers& buffers,
                                                    int face, std::size_t triangle, unsigned sample) {
  Program& story = program_of("volume_vertex.glsl", "volume_fragment.glsl",
                              volume_definitions(plan_, shop_.driver().clip_control, ProgramUse::story));
  const auto draw = [&] { glDrawArrays(GL_TRIANGLES, 3 * face, 3); };
  set_volume_state(story);
  set_object(story, buffers.object());
  const Vec4f seen = value_written(sample, draw);
  if (!(seen.w > 0)) return {};  // it covers a sample of a neighbour, see guard_neighbours()
  if (seen.z > 0) return {};     // outside the limits
  const bool front = seen.y > 0;
  const bool faces_out = 3 * face < buffers.outwards();
  VolumeCrossing found = crossing_of(volume, triangle);
  found.z = static_cast<double>(seen.x);
  found.enters = front == faces_out;
  shop_.target->bind();
  Program& program = volume_program();
  set_volume_state(program);
  set_object(program, buffers.object());
  glDisable(GL_STENCIL_TEST);
  const bool passed = count_samples(sample, draw) > 0;
  const bool fail = plan_.settings.shadows == Shadows::stencil_depth_fail;
  if (passed != fail) found.change = found.enters == fail ? -1 : 1;
  return found;
}

// The faces of the light's shadow volumes that cover the pixel, each drawn alone as count_volumes() draws all of them.
StencilEvent StoryDrawer::stencil_event(std::size_t light, unsigned sample) {
  StencilEvent event;
  event.light = static_cast<int>(light);
  const std::vector<raster::ShadowVolume>& volumes = (*plan_.volumes)[light];
  for (std::size_t i = 0; i < volumes.size(); ++i) {
    event.silhouette_edges += static_cast<int>(volumes[i].silhouette.size());
    const VolumeBuffers& buffers = volumes_[light][i];
    Program& program = volume_program();
    set_volume_state(program);
    set_object(program, buffers.object());
    begin_asking();
    buffers.bind();
    std::vector<int> covering;
    find_faces(0, (buffers.outwards() + buffers.inwards()) / 3, sample, covering);
    for (const int face : covering)
      if (const auto found =
              crossing(volumes[i], buffers, face, buffers.numbers()[static_cast<std::size_t>(face)], sample))
        event.crossings.push_back(*found);
  }
  std::stable_sort(event.crossings.begin(), event.crossings.end(),
                   [](const VolumeCrossing& a, const VolumeCrossing& b) { return a.z < b.z; });
  for (const VolumeCrossing& crossing : event.crossings) event.count += crossing.change;
  return event;
}

void StoryDrawer::report_stencil(const DrawPass& pass, const Outcome& outcome, double z) {
  if (pass.light < 0 || !outcome.stencil || volumes_[static_cast<std::size_t>(pass.light)].empty()) return;
  recorder_.event([&] {
    StencilEvent event = stencil_event(static_cast<std::size_t>(pass.light), outcome.sample);
    event.surface_z = z;
    event.stored = *outcome.stencil;
    return event;
  });
}

}  // namespace ps::hardware
