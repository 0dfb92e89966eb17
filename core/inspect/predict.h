#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "record/story.h"
#include "scene/scene.h"

/// Predict, then reveal: a question about a pixel whose story is not shown yet, and how good the answer was.

namespace ps {

enum class Question {
  colour,    ///< which display levels the pixel has
  winner,    ///< which object it shows
  rays,      ///< how many rays were traced for it
  triangle,  ///< which triangle of which object it shows
  tests      ///< how many intersections with spheres, triangles and solids were tested for it
};

/// "colour", "winner", "rays", "triangle", "tests"
std::string_view question_key(Question question);
/// Throws InputError for anything else.
Question parse_question(std::string_view text);

/// What someone says; only the member of the question counts.
struct Guess {
  std::array<int, 3> colour{};  ///< display levels, 0 to 255
  int object = -1;              ///< index into Geometry::objects; -1 = background
  int rays = 0;
  int triangle = -1;  ///< of the object; Question::triangle only
  int tests = 0;
};

/// The right answer, in words.
struct Judgement {
  double points = 0;  ///< 0 to 1
  std::string sentence;
};

/// Why the question makes no sense for this story ("fragments need no rays"), or nullopt.
std::optional<std::string_view> not_askable(Question question, const PixelStory& story);

/// Triangles of meshes that may be asked for, in the order of their objects; empty where there are too many to choose
/// among.
std::vector<PixelId> askable_triangles(const Scene& scene);

/// The object that the pixel shows; -1 = background.
int winner_of(const PixelStory& story);
/// Eye, shadow, reflected and refracted rays that were traced for the pixel.
int rays_of(const PixelStory& story);
/// Intersections of its rays with spheres, triangles and solids that were tested; those with boxes of an accelerator
/// are not among them.
int tests_of(const PixelStory& story);

/// A guess in words: "51 0 0", "'red'", "4 rays".
std::string guess_text(Question question, const Guess& guess, const Scene& scene);

/// The answer that is right, and "It is 3 rays".
Guess right_guess(Question question, const PixelStory& story);
std::string right_answer_text(Question question, const PixelStory& story, const Scene& scene);

/// Compares the guess with the story. A colour earns a full point within 4 levels in every channel, and none beyond 64;
/// a number of rays half a point if it is off by one; a number of tests a full one within 5 %, half within a factor
/// of 2.
Judgement judge(Question question, const Guess& guess, const PixelStory& story, const Scene& scene);

}  // namespace ps
