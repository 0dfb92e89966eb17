#include "study/precision_map.h"

#include <algorithm>

#include "render/precision_channels.h"

namespace ps {

PrecisionMap precision_map(const Scene& scene, const View& view, const Settings& settings, Prepared& prepared,
                           Progress& progress, WorkerPriority priority) {
  RenderRequest request;
  request.channels = Channel::ids | Channel::precision | Channel::depth_gap;
  request.priority = priority;
  Frame frame = render(scene, view, settings, request, prepared, progress);
  PrecisionMap map;
  map.faults = std::move(frame.precision);
  map.gap = std::move(frame.depth_gap);
  for (const PrecisionFault fault : map.faults.pixels()) ++map.counts[static_cast<std::size_t>(fault)];
  return map;
}

Image<Rgb8> fault_picture(const PrecisionMap& map) {
  Image<Rgb8> picture(map.faults.width(), map.faults.height());
  std::transform(map.faults.pixels().begin(), map.faults.pixels().end(), picture.pixels().begin(),
                 precision_fault_colour);
  return picture;
}

Image<Rgb8> gap_picture(const PrecisionMap& map) {
  Image<Rgb8> picture(map.gap.width(), map.gap.height());
  std::transform(map.gap.pixels().begin(), map.gap.pixels().end(), picture.pixels().begin(), depth_gap_colour);
  return picture;
}

}  // namespace ps
