#include <array>

#include "rectilin/base/parameters.h"
#include "rectilin/corpus/shard.h"
#include "support/catch.h"

using namespace rectilin;
using rectilin::corpus::Shard;

TEST_CASE("each name is in one shard, and shards are of about one size", "[corpus]") {
  std::array<int, 7> sizes{};
  constexpr int kNames = 70'000;
  for (int i = 0; i < kNames; ++i) {
    const std::string name = "models/part_" + std::to_string(i) + ".off";
    int found = 0;
    for (std::uint32_t k = 0; k < 7; ++k) {
      if (!Shard{k, 7}.contains(name)) continue;
      ++found;
      ++sizes[k];
    }
    REQUIRE(found == 1);
  }
  // Standard deviation sqrt(70000 * 6 / 49) = 92.6; five of them.
  for (const int size : sizes) CHECK(std::abs(size - kNames / 7) < 463);
}

TEST_CASE("shards do not change from one version to the next", "[corpus]") {
  // Computed by another program from the definition: FNV-1a, MurmurHash3's finalizer, upper half times count.
  CHECK(Shard{0, 1}.contains("anything"));
  std::string parts;
  for (const char* name : {"a", "b", "chair.off", "meshes/1.stl", ""}) {
    for (std::uint32_t k = 0; k < 10; ++k)
      if (Shard{k, 10}.contains(name)) parts += std::to_string(k);
  }
  CHECK(parts == "54689");
}

TEST_CASE("what is no shard is refused", "[corpus]") {
  CHECK(Shard::parse("3/4").index == 3);
  for (const char* wrong : {"4/4", "1", "/", "1/", "/2", "-1/2", "1/0", "a/b", "1/2/3", " 1/2"})
    CHECK_THROWS_AS(Shard::parse(wrong), ParameterError);
}
