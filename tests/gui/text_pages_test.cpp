// Where a lesson's text is parted into pages.
#include "gui/panels/lesson/text_pages.h"

#include <gtest/gtest.h>

namespace text_pages_test {
namespace {

using ps::gui::page_starts;
using ps::gui::PagePart;
using Starts = std::vector<std::size_t>;

PagePart line() { return {0, 10, false, false}; }
PagePart block() { return {5, 10, true, false}; }
PagePart heading() { return {5, 10, true, true}; }

TEST(TextPages, WhatFitsIsOnePage) {
  EXPECT_EQ(page_starts({}, 30), Starts{0});
  EXPECT_EQ(page_starts({block(), line(), line()}, 30), Starts{0});  // no gap at the top
}

TEST(TextPages, PagesEndBetweenBlocksUnlessTheyWouldBeMuchTooShort) {
  EXPECT_EQ(page_starts({block(), line(), line(), block(), line()}, 45), (Starts{0, 3}));
  // The second block begins after a fifth of the page: it is parted.
  EXPECT_EQ(page_starts({block(), block(), line(), line(), line(), line()}, 50), (Starts{0, 4}));
}

TEST(TextPages, HeadingsStayWithWhatFollows) {
  EXPECT_EQ(page_starts({block(), line(), line(), heading(), block(), line()}, 50), (Starts{0, 3}));
}

TEST(TextPages, PartsHigherThanAPageHaveOneEach) {
  const PagePart high{0, 100, true, false};
  EXPECT_EQ(page_starts({high, high, line()}, 30), (Starts{0, 1, 2}));
}

}  // namespace
}  // namespace text_pages_test
