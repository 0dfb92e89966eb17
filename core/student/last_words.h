#pragma once
#include <string>

namespace ps {

/// Of what a program printed before it failed, the line that says why: the last one with words, but for those that only
/// say that it ended or where to report that. Empty if there is none.
std::string last_words(const std::string& text);

}  // namespace ps
