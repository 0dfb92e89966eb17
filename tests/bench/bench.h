#pragma once
#include <functional>
#include <string>
#include <vector>

/// How to add a bench: write a file with a function that returns its Benches, and name it in table.cpp.

namespace ps::bench {

/// What a prepared bench runs. Data lives in the closures and goes away with them.
struct Job {
  std::function<void()> ours;
  std::function<void()> yardstick;  ///< empty if there is nothing to compare with
  /// Run once before timing: empty if both sides did the same work, else what differs (counts of hits, pixels). Then
  /// the bench is not timed and the program ends with status 1.
  std::function<std::string()> check;
  /// Work done by one call, in millions of the unit's things (rays, pixels) or in the unit's own size (GB): the result
  /// is amount / second. 0: the result is milliseconds per call.
  double amount = 0;
  std::string note;  ///< printed behind the row: settings, counts
  double size = 0;   ///< of a point on a curve: what grows from one bench to the next
};

struct Bench {
  std::string name;              ///< "rays/primary/teapot": area, what, mesh; the mesh is teapot, 200k or 1M
  std::string unit;              ///< "ms" (less is better), or a rate such as "Mray/s" (more is better)
  std::string yardstick_name;    ///< "embree", "llvmpipe", or what else; empty if there is none
  std::function<Job()> prepare;  ///< called only if the bench is chosen
};

using Benches = std::vector<Bench>;

inline void append(Benches& all, Benches more) {
  for (Bench& bench : more) all.push_back(std::move(bench));
}

/// What a bench gave; also one row of the JSON file. Values are in the bench's unit.
struct Row {
  std::string name, unit, yardstick_name, note;
  double ours = 0, ours_q1 = 0, ours_q3 = 0;
  double yardstick = 0, yardstick_q1 = 0, yardstick_q3 = 0;  ///< 0 without a yardstick
  double ratio = 0;                                          ///< above 1: ours is faster; 0 without a yardstick
  double size = 0, milliseconds = 0;                         ///< of one call, on curves; else 0
};

/// All benches, from table.cpp.
Benches all_benches();

}  // namespace ps::bench
