#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "base/check.h"
#include "engine/text.h"

namespace ps {

/// A link to a step of the same lesson, which is known to be there only once all is read.
struct StepLink {
  SourcePlace place;
  int step = 0;  ///< from 0
};

/// The text of a step, read.
struct StepText {
  std::vector<TextBlock> blocks;
  std::vector<TextBlock> hints;  ///< what follows "> "
  std::vector<StepLink> step_links;
};

/// Reads CommonMark: paragraphs, headings from "###" on, lists of one level, quotes of paragraphs, *emphasis*,
/// **strong**, `code`, [links](panel:parting), [[option-key]] for a live control, $formulas$, and $$formulas$$ that are
/// a paragraph of their own. `file` and `first_line` are where the text begins, for messages. Throws InputError with
/// file, line and column for any other construct, for a mark without its partner, and for a link that leads nowhere.
StepText read_markdown(std::string_view text, const std::string& file, int first_line);

}  // namespace ps
