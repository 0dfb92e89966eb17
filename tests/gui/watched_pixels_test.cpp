// Pixels that are followed while options change, and results made in the background.
#include "gui/session/watched_pixels.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <future>
#include <thread>

#include "gui/work/latest_result.h"

namespace ps::gui::watched_pixels_test {
namespace {

TEST(WatchedPixels, KeepsChangesOnly) {
  WatchedPixels watched;
  watched.toggle({1, 2});
  Image<Rgb8> a(4, 4, {10, 20, 30}), b(4, 4, {1, 2, 3});
  watched.note(a, b);
  watched.note(a, b);
  ASSERT_EQ(watched.all().size(), 1u);
  EXPECT_EQ(watched.all()[0].values.size(), 1u);
  a.at(3, 3) = {0, 0, 0};  // another pixel
  watched.note(a, b);
  EXPECT_EQ(watched.all()[0].values.size(), 1u);
  b.at(1, 2) = {9, 9, 9};
  watched.note(a, b);
  ASSERT_EQ(watched.all()[0].values.size(), 2u);
  EXPECT_EQ(watched.all()[0].values[0][1], (Rgb8{1, 2, 3}));
  EXPECT_EQ(watched.all()[0].values[1][1], (Rgb8{9, 9, 9}));
  EXPECT_EQ(watched.all()[0].values[1][0], (Rgb8{10, 20, 30}));
  for (std::uint8_t i = 0; i < 200; ++i) {
    a.at(1, 2) = {i, i, 0};
    watched.note(a, b);
  }
  EXPECT_EQ(watched.all()[0].values.size(), WatchedPixels::most_values);
  EXPECT_EQ(watched.all()[0].values.back()[0], (Rgb8{199, 199, 0}));
  watched.note(Image<Rgb8>(1, 1), b);  // too small for the pixel
  EXPECT_FALSE(watched.all()[0].values.back()[0].has_value());
  watched.toggle({1, 2});
  EXPECT_TRUE(watched.all().empty());
  for (int i = 0; i < 40; ++i) watched.toggle({i, 0});
  EXPECT_EQ(watched.all().size(), WatchedPixels::most_pixels);
}

/// Asks until the newest request is answered, as the window does frame by frame.
template <class Worker>
void settle(Worker& worker, int request) {
  for (int i = 0; i < 60000; ++i) {
    worker.request(request);
    if (!worker.busy()) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  ADD_FAILURE() << "no result in a minute";
}

TEST(LatestResult, TheNewestRequestIsAnsweredAndNotMadeTwice) {
  std::atomic<int> made{0}, woken{0};
  std::promise<void> release;
  const std::shared_future<void> released = release.get_future().share();
  LatestResult<int, int> worker(
      [&](const int& request, Progress&) {
        ++made;
        if (request == 0) released.wait();
        return request * request;
      },
      [](const int& x, const int& y) { return x == y; }, [&] { ++woken; });
  EXPECT_FALSE(worker.busy());
  EXPECT_EQ(worker.result(), nullptr);
  settle(worker, 7);
  ASSERT_NE(worker.result(), nullptr);
  EXPECT_EQ(*worker.result(), 49);
  EXPECT_TRUE(worker.has_news());
  worker.take_news();
  EXPECT_FALSE(worker.has_news());
  settle(worker, 7);
  EXPECT_EQ(made, 1);
  for (int request = 0; request < 50; ++request) worker.request(request);
  EXPECT_TRUE(worker.busy());
  release.set_value();
  settle(worker, 49);
  EXPECT_EQ(*worker.result(), 49 * 49);
  EXPECT_EQ(made, 3) << "7, 0 and 49: what was replaced while 0 was being made needs no answer";
  EXPECT_GE(woken, 1);
}

TEST(LatestResult, WhatCannotBeMadeLeavesTheLastResult) {
  LatestResult<int, int> worker(
      [](const int& request, Progress&) {
        if (request < 0) throw InputError("no such thing");
        return request;
      },
      [](const int& x, const int& y) { return x == y; }, {});
  settle(worker, 3);
  settle(worker, -1);
  EXPECT_EQ(*worker.result(), 3);
}

}  // namespace
}  // namespace ps::gui::watched_pixels_test
