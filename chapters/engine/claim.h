#pragma once
#include <string>
#include <vector>

#include "engine/metric.h"
#include "engine/state.h"

namespace ps {

/// A change that breaks a claim: options that go back to their defaults on both sides, lines as a step has them, or
/// another thing that is measured.
struct Mutation {
  std::vector<std::string> reset;  ///< keys of options
  LessonState state;               ///< the claim's with the lines of the mutation
  Metric metric;                   ///< the claim's, or the one in its place
  bool changes_metric = false;     ///< the screen does not change
  std::string text;                ///< "default shadow-epsilon", "scene cgfs/spheres"
  std::string words;               ///< "Shadow epsilon at its default", "scene cgfs/spheres"
};

/// A statement of a lesson that a test checks: a measured number keeps a bound, and no longer does after the mutation,
/// so that this is what makes it true.
struct Claim {
  std::string text;
  LessonState state;  ///< of the step, with the claim's own lines
  LessonState own;    ///< the claim's own lines alone
  Metric metric;
  Bound bound;
  Mutation mutation;
};

/// The document that a claim speaks of. Throws InputError when it cannot be made.
Document claim_document(const Claim& claim, const Document& now);
/// The same with the mutation.
Document mutated_document(const Claim& claim, const Document& now);

/// The result of a check.
struct ClaimResult {
  double value = 0;          ///< with the step's settings
  double mutated_value = 0;  ///< with the mutation
  bool holds = false;        ///< the value keeps the bound
  bool has_teeth = false;    ///< the mutated value breaks it
  bool passed() const { return holds && has_teeth; }
};

/// Renders what the claim speaks of, with and without its mutation. Throws InputError when its scene cannot be loaded
/// and Cancelled. `pictures`: what earlier claims have rendered.
ClaimResult check_claim(const Claim& claim, Progress& progress, MeasuredPictures* pictures = nullptr);

}  // namespace ps
