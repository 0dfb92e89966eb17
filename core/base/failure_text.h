#pragma once
#include <exception>
#include <string>

namespace ps {

/// The failure as a sentence for the user: what() of our own exceptions, which say it already; for those of the
/// standard library what ran out and what to do about it.
std::string failure_text(const std::exception& failure);

}  // namespace ps
