#include "server/threads/memory_return.h"

#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <thread>
#include <vector>

#include "tests/unit/server/resident_bytes.h"

namespace race::server {
namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kHasOwnAllocator = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
constexpr bool kHasOwnAllocator = true;
#else
constexpr bool kHasOwnAllocator = false;
#endif
#else
constexpr bool kHasOwnAllocator = false;
#endif

using Blocks = std::vector<std::unique_ptr<char[]>>;

/// Small blocks of `bytes` together, and then one of a hundred: the allocator keeps the rest, as it is in pieces.
Blocks left_of(std::size_t bytes) {
  constexpr std::size_t kBlock = 512;
  Blocks all(bytes / kBlock);
  for (auto& block : all) {
    block = std::make_unique<char[]>(kBlock);
    block[0] = 1;
  }
  Blocks left;
  for (std::size_t i = 0; i < all.size(); i += 100) left.push_back(std::move(all[i]));
  return left;
}

TEST(MemoryReturn, GivesBackWhatIsFreeBetweenWhatIsNot) {
  if (kHasOwnAllocator) GTEST_SKIP() << "the sanitizer has an allocator of its own";
  const Blocks left = left_of(4 * MemoryReturn::kFree);
  const std::size_t kept = resident_bytes();
  const MemoryReturn memory_return(std::chrono::milliseconds(20));
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  while (resident_bytes() + 2 * MemoryReturn::kFree > kept && std::chrono::steady_clock::now() < end)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_LT(resident_bytes() + 2 * MemoryReturn::kFree, kept);
}

}  // namespace
}  // namespace race::server
