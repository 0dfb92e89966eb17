#pragma once
#include <string>
#include <vector>

#include "engine/text.h"

/// Lessons speak of keys, clicks and live controls, none of which paper has.

namespace ps {

/// With the blank behind it, unless it is the last one.
using Sentence = std::vector<TextSpan>;

/// The sentences of a block, in its styles; a full stop or its like with a blank behind it ends one.
std::vector<Sentence> sentences_of(const TextBlock& block);

/// A text without its sentences about keys, clicks and drags. A live control is named where the sentence needs its
/// name.
std::vector<TextBlock> on_paper(const std::vector<TextBlock>& blocks);

/// The same for hints, which go as a whole: their other sentences are about what the key or the click has shown.
std::vector<TextBlock> hints_on_paper(const std::vector<TextBlock>& hints);

/// "Click a place where B has one." becomes "Mark a place where B has one."
std::string question_on_paper(std::string text);

}  // namespace ps
