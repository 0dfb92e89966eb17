#pragma once
#include <random>
#include <string>
#include <vector>

namespace ps::fuzz {

/// One to eight changes at random places: bits, bytes, numbers and words exchanged, pieces cut out, doubled, moved, or
/// taken from another of `files`. The same for the same state of `random`.
std::string mutated(const std::string& bytes, const std::vector<std::string>& files, std::mt19937_64& random);

}  // namespace ps::fuzz
