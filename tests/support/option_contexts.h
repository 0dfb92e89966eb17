#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "frame/frame.h"
#include "options/option.h"
#include "scene/scene.h"

namespace ps::test {

/// All choices of an option; of a number the ends of its range.
std::vector<OptionNumber> values_of(const Option& option);

/// A scene that the programs can open, and settings under which some options can act.
struct OptionContext {
  std::string scene;  ///< a built-in name or a path
  std::vector<std::string> assignments;
  bool operator==(const OptionContext&) const = default;
};

/// Is there a renderer of this key that can draw here?
bool has_renderer(std::string_view key);
/// Is the option used by renderers alone that cannot draw here, such as the hardware renderer where there is no OpenGL?
bool lacks_its_renderer(const Option& option);

/// The scenes that the rows of all options name (Option::shown_by), each once, where their renderers can draw.
const std::vector<OptionContext>& option_contexts();
/// Those of one option, as indices: any two choices, and the ends of its range, differ in at least one of them, unless
/// they have the same result by design.
std::vector<std::size_t> contexts_of(const Option& option);

/// What a render of a context gives.
struct Outcome {
  Image<Rgb8> picture;
  Counters counters;
  bool operator==(const Outcome&) const = default;
};

/// An option that responds in a context.
struct OptionResponse {
  std::size_t context = 0;  ///< index into option_contexts()
  std::string value;        ///< the value that made the difference, as it is written
  Outcome before, after;
};

/// Two values of an option that give the same pictures and counters; the first one comes earlier.
struct AlikeValues {
  OptionNumber first = 0, second = 0;
};

/// Renders contexts and looks for responses; keeps what the contexts give unchanged.
class OptionResponses {
 public:
  OptionResponses(int width, int height);
  ~OptionResponses();
  /// The first of the option's contexts in which it says that it can act and some value of it changes the picture or,
  /// if none does anywhere, a counter.
  std::optional<OptionResponse> find(const Option& option);

  /// The pairs of these values of an option that none of these contexts tells apart, neither by its picture nor by a
  /// counter. Two values are compared in the contexts in which the option can act and neither of them is inactive.
  std::vector<AlikeValues> alike(const Option& option, const std::vector<OptionNumber>& values,
                                 const std::vector<std::size_t>& contexts);

  /// A context's settings, and what it gives with them.
  const Settings& settings(std::size_t context) const;
  const Outcome& unchanged(std::size_t context);

 private:
  struct Loaded;
  std::optional<OptionResponse> find_in(std::size_t context, const Option& option, bool pictures_only);
  int width_, height_;
  std::vector<std::unique_ptr<Loaded>> loaded_;
};

}  // namespace ps::test
