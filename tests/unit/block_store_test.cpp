#include "base/block_store.h"

#include <algorithm>
#include <set>
#include <thread>

#include <gtest/gtest.h>

#include "image/image.h"
#include "math/vec.h"

namespace ps::block_store_test {
namespace {

TEST(BlockStore, HandsOutTheSameBlockAgainForTheSameSize) {
  constexpr std::size_t size = (1 << 20) + 64 * 7;  // a size that nothing else here has
  void* const block = take_block(size);
  give_block(block, size);
  EXPECT_GE(kept_block_bytes(), size);
  void* const other_size = take_block(size + 64);
  EXPECT_NE(other_size, block);
  void* const again = take_block(size);
  EXPECT_EQ(again, block);
  void* const second = take_block(size);
  EXPECT_NE(second, again);
  for (void* each : {again, second}) give_block(each, size);
  give_block(other_size, size + 64);
}

TEST(BlockStore, KeepsNoMoreThanItsLimit) {
  constexpr std::size_t size = 24 << 20;
  std::set<void*> blocks;
  for (int i = 0; i < 10; ++i) blocks.insert(take_block(size));
  EXPECT_EQ(blocks.size(), 10u);
  for (void* block : blocks) give_block(block, size);
  EXPECT_GE(kept_block_bytes(), size);
  EXPECT_LE(kept_block_bytes(), std::size_t{192} << 20);
  for (std::size_t i = 1; i < 100; ++i) give_block(take_block((1 << 18) + 64 * i), (1 << 18) + 64 * i);
  EXPECT_LE(kept_block_bytes(), std::size_t{192} << 20);
}

/// Every thread writes its own blocks as a whole and finds them unchanged.
TEST(BlockStore, GivesEachThreadBlocksOfItsOwn) {
  std::vector<std::thread> threads;
  threads.reserve(4);
  std::vector<int> wrong(4, 0);
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([t, &wrong] {
      for (int round = 0; round < 200; ++round) {
        const Image<int> image(256, 256, t);
        for (const int value : image.pixels()) wrong[static_cast<std::size_t>(t)] += value != t;
      }
    });
  for (auto& thread : threads) thread.join();
  EXPECT_EQ(wrong, std::vector<int>(4, 0));
}

TEST(Image, CopiesAreValues) {
  Image<Vec3f> first(300, 200, Vec3f(1, 2, 3));
  const Image<Vec3f> copy = first;
  first.at(299, 199) = {4, 5, 6};
  EXPECT_EQ(copy.at(299, 199), Vec3f(1, 2, 3));
  EXPECT_FALSE(first == copy);
  Image<Vec3f> unfilled(300, 200, Unfilled{});
  std::ranges::copy(copy.pixels(), unfilled.pixels().begin());
  EXPECT_TRUE(unfilled == copy);
}

}  // namespace
}  // namespace ps::block_store_test
