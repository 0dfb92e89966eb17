#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "options/option.h"
#include "render/frame.h"
#include "scene/scene.h"

namespace ps::test {

/// A scene that the programs can open, and settings under which some options can act.
struct OptionContext {
  std::string scene;  ///< a built-in name or a path
  std::vector<std::string> assignments;
};

/// Enough of them that every option responds in at least one.
const std::vector<OptionContext>& option_contexts();

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

/// Renders contexts and looks for responses; keeps what the contexts give unchanged.
class OptionResponses {
 public:
  OptionResponses(int width, int height);
  ~OptionResponses();
  /// The first context, in their order, in which the option says that it can act and some value of it changes the
  /// picture or, if none does anywhere, a counter.
  std::optional<OptionResponse> find(const Option& option);

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
