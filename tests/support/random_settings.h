#pragma once
#include <random>
#include <string>

#include "options/option.h"

namespace ps::test {

/// Evenly from 0 to 1.
double share(std::mt19937& random);
/// Evenly from 0 to end - 1.
int below(std::mt19937& random, int end);

/// A value of the option that keeps a small picture cheap: no more threads, tessellations, samples or bounces than a
/// test can afford.
double random_value(const Option& option, std::mt19937& random);

/// The settings that differ from the defaults, "key=value", each with a blank before it.
std::string changed_settings(const Settings& settings);

}  // namespace ps::test
