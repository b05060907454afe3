// What a cache keeps, and that it keeps no more than it has room for.
#include "rectilin/base/random.h"
#include "shapes/cache.h"
#include "support/catch.h"

using rectilin::serve::Cache;

TEST_CASE("What was used longest ago goes first", "[serve]") {
  Cache<int> cache(10);
  cache.put("a", 1, 4);
  cache.put("b", 2, 4);
  CHECK(cache.get("a") == 1);  // now b is older
  cache.put("c", 3, 4);
  CHECK_FALSE(cache.get("b"));
  CHECK(cache.get("a") == 1);
  CHECK(cache.get("c") == 3);
  cache.put("a", 5, 6);  // another value for a key takes the place of the first
  CHECK(cache.get("a") == 5);
  CHECK(cache.used() == 10);
  cache.put("large", 6, 11);
  CHECK_FALSE(cache.get("large"));
  CHECK(cache.get("a") == 5);
}

TEST_CASE("A cache never has more than its room", "[serve]") {
  Cache<std::uint64_t> cache(1000);
  rectilin::Random random(3);
  for (int i = 0; i < 5000; ++i) {
    const std::uint64_t key = random.below(200);
    cache.put(std::to_string(key), key, random.below(300));
    CHECK(cache.used() <= 1000);
    const std::uint64_t other = random.below(200);
    if (const auto value = cache.get(std::to_string(other))) CHECK(*value == other);
  }
}
