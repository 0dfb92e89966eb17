#include "base/spelling.h"

#include <array>

#include <gtest/gtest.h>

namespace ps::spelling_test {
namespace {

constexpr std::array<std::string_view, 6> words{"near", "gamma", "reflection-depth", "bvh-holes", "z-vs-1-z", "x"};

TEST(Spelling, OnlyWordsNearEnoughAreOffered) {
  EXPECT_EQ(similar_word("gama", words), "gamma");
  EXPECT_EQ(similar_word("reflection-dept", words), "reflection-depth");
  EXPECT_EQ(similar_word("reflection", words), "reflection-depth") << "a part of it";
  EXPECT_EQ(similar_word("the-gamma", words), "gamma") << "with something around it";
  EXPECT_EQ(similar_word("bhv-holes", words), "bvh-holes");
  EXPECT_EQ(similar_word("naer", words), "near");
  EXPECT_EQ(similar_word("X", words), "x");
  for (const char* far : {"nosuch", "banana", "q-q-q", "", "gum", "magma and more"})
    EXPECT_EQ(similar_word(far, words), "") << far;
  EXPECT_EQ(similar_word("gamma", {}), "");
  EXPECT_EQ(similar_word(std::string(100000, 'g'), words), "");
}

TEST(Spelling, WhatIsFarFromAllPointsToTheList) {
  EXPECT_EQ(did_you_mean("gama", words, "; see the list"), "; did you mean 'gamma'?");
  EXPECT_EQ(did_you_mean("nosuch", words, "; see the list"), "; see the list");
}

}  // namespace
}  // namespace ps::spelling_test
