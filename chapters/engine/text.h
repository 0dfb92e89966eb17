#pragma once
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "document/document.h"
#include "engine/maths.h"

/// The text of a lesson as a value: blocks of spans, without a widget. chapters/README.md describes how it is written.

namespace ps {

struct Figure;

enum class TextStyle { plain, emphasis, strong, code };

/// Where a span leads. `control` is not a link but a live control of an option, in the middle of the text.
enum class LinkKind { none, option, panel, step, lesson, term, control };

struct TextLink {
  LinkKind kind = LinkKind::none;
  std::string target;        ///< key of the option, name of the panel, folder of the lesson, term of the glossary
  int step = 0;              ///< from 0; of this lesson, or of the one named
  std::optional<Side> side;  ///< of a control; absent: one for each picture
  bool operator==(const TextLink&) const = default;
};

/// Text in one style with one link. That of a control is the option's label, that of a formula its plain form.
struct TextSpan {
  std::string text;
  TextStyle style = TextStyle::plain;
  TextLink link = {};
  std::optional<Formula> formula = {};
  bool operator==(const TextSpan&) const = default;
};

enum class BlockKind { paragraph, heading, bullet, numbered, figure };

struct TextBlock {
  BlockKind kind = BlockKind::paragraph;
  int number = 0;  ///< of a numbered block
  std::vector<TextSpan> spans;
  std::shared_ptr<const Figure> figure = {};  ///< of a figure (engine/figure.h), whose description is the text
  bool operator==(const TextBlock&) const = default;
};

/// The words alone, in one line.
std::string plain_text(const TextBlock& block);

/// The formula of a block that is only a formula on a line of its own; else nullptr.
const Formula* display_formula(const TextBlock& block);

/// Beside the tools a link can name this panel, with all options, the pixel's story (story_names::one) and in it the
/// place where the stories of A and B part (story_names::parting).
inline constexpr std::string_view options_panel_name = "options";

/// "option:KEY", "panel:NAME", "step:N", "lesson:FOLDER" or "lesson:FOLDER/N", with N from 1, or "term:TERM". Throws an
/// InputError without a place for anything else, or if there is no such option, panel, lesson or term.
TextLink parse_link(std::string_view target);

/// "KEY", "a.KEY" or "b.KEY" of a live control. Throws an InputError without a place if there is no such option.
TextLink parse_control(std::string_view target);

/// The target of a name in bold: the option, the first option of the group, or the panel of that name, in whatever
/// case. No link for other words.
TextLink link_of_name(std::string_view name);

}  // namespace ps
