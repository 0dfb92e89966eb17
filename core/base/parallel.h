#pragma once
#include <functional>
#include <vector>

#include "base/progress.h"

namespace ps {

/// A rectangle of pixels, half-open: columns [x0, x1), rows [y0, y1).
struct TileRect {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  int width() const { return x1 - x0; }
  int height() const { return y1 - y0; }
  bool contains(int x, int y) const { return x >= x0 && x < x1 && y >= y0 && y < y1; }
  bool operator==(const TileRect&) const = default;
};

/// Cuts a width x height picture into tiles of at most `size` x `size` pixels, row by row from the top left.
std::vector<TileRect> make_tiles(int width, int height, int size);

enum class WorkerPriority { normal, background };

struct ParallelOptions {
  int threads = 0;  ///< Number of worker threads; 0 = one per processor.
  WorkerPriority priority = WorkerPriority::normal;
};

/// The number of threads that `options` give on this machine, at least 1.
int resolve_threads(const ParallelOptions& options);

/// Calls body(index, worker) once for each index in [0, count); indices are handed out in increasing order to the
/// workers. The first exception thrown by a body stops the rest and is rethrown here; a stop requested through
/// `progress`, or through the caller's StopScope, throws Cancelled. Advances `progress` by one per finished index. The
/// only place that starts threads for rendering; they are kept for the next call. Results must not depend on which
/// worker ran an index.
void parallel_for(int count, const ParallelOptions& options, Progress& progress,
                  const std::function<void(int index, int worker)>& body);

}  // namespace ps
