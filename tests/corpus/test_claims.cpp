#include "rectilin/corpus/claims.h"

#include <sys/wait.h>
#include <unistd.h>

#include <string>
#include <thread>
#include <vector>

#include "support/catch.h"

using rectilin::corpus::Claims;

namespace {

std::string digest(std::uint64_t number) {
  char text[32];
  std::snprintf(text, sizeof text, "fnv1a64:%016llx", static_cast<unsigned long long>(number));
  return text;
}

}  // namespace

TEST_CASE("the first who claims a mesh has it", "[corpus]") {
  Claims claims = Claims::make(3);
  for (const std::uint64_t number : {std::uint64_t{0}, std::uint64_t{5}, ~std::uint64_t{0}}) {
    CAPTURE(number);
    CHECK(claims.owner(digest(number)) == Claims::kDone);
    CHECK(claims.claim(digest(number), 7));
    CHECK(claims.claim(digest(number), 7));  // as when a job is begun again
    CHECK_FALSE(claims.claim(digest(number), 0));
    CHECK(claims.owner(digest(number)) == 7);
    claims.give(digest(number), 0);
    CHECK_FALSE(claims.claim(digest(number), 7));
    CHECK(claims.claim(digest(number), 0));
  }
  claims.claim(digest(6), Claims::kDone);
  CHECK_FALSE(claims.claim(digest(6), 1));
}

TEST_CASE("of many threads and processes one has each mesh", "[corpus]") {
  constexpr std::uint64_t kMeshes = 2000, kThreads = 4;
  Claims claims = Claims::make(kMeshes);
  std::vector<std::uint64_t> got(kThreads + 1);
  int ends[2];
  REQUIRE(pipe(ends) == 0);
  const pid_t child = fork();
  const auto claim_all = [&](Claims& table, std::uint64_t who) {
    std::uint64_t count = 0;
    for (std::uint64_t i = 0; i < kMeshes; ++i) count += table.claim(digest(i * 0x9e3779b97f4a7c15), who);
    return count;
  };
  if (child == 0) {
    Claims same = Claims::open(dup(claims.file()));
    const std::uint64_t count = claim_all(same, kThreads);
    _exit(write(ends[1], &count, sizeof count) == sizeof count ? 0 : 1);
  }
  {
    std::vector<std::jthread> threads;
    for (std::uint64_t k = 0; k < kThreads; ++k) threads.emplace_back([&, k] { got[k] = claim_all(claims, k); });
  }
  REQUIRE(read(ends[0], &got[kThreads], sizeof(std::uint64_t)) == sizeof(std::uint64_t));
  waitpid(child, nullptr, 0);
  std::vector<std::uint64_t> owned(kThreads + 1);
  for (std::uint64_t i = 0; i < kMeshes; ++i) ++owned.at(claims.owner(digest(i * 0x9e3779b97f4a7c15)));
  CHECK(got == owned);
  close(ends[0]);
  close(ends[1]);
}
