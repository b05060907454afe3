#include <atomic>
#include <vector>

#include "rectilin/base/batch.h"
#include "support/catch.h"

using namespace rectilin;

namespace {

std::vector<std::string> names(std::size_t count) {
  std::vector<std::string> list;
  for (std::size_t i = 0; i < count; ++i) list.push_back("item" + std::to_string(i));
  return list;
}

}  // namespace

TEST_CASE("results come in order and failures cost their own item", "[batch]") {
  const auto list = names(200);
  std::vector<std::string> seen;
  std::vector<std::size_t> progress;
  LoopControl control;
  control.on_progress = [&](std::size_t done, std::size_t total, const std::string&) {
    CHECK(total == 200);
    progress.push_back(done);
  };
  const auto work = [&](std::size_t i) -> std::size_t {
    if (i % 50 == 7) throw std::runtime_error("no luck");
    if (i % 50 == 8) throw std::runtime_error(list[i] + ":3: its own line");
    return i * i;
  };
  const auto deliver = [&](std::size_t i, Outcome<std::size_t>&& outcome) {
    CHECK(i == seen.size());
    CHECK(outcome.value.has_value() == outcome.error.empty());
    if (outcome.value) CHECK(*outcome.value == i * i);
    seen.push_back(outcome.error);
  };
  CHECK(for_each_in_order<std::size_t>(list, work, deliver, control) == 200);
  CHECK(seen[7] == "item7: no luck");
  CHECK(seen[58] == "item58:3: its own line");
  CHECK(std::ranges::is_sorted(progress));
  CHECK(progress.back() == 200);
}

TEST_CASE("a stop delivers what is in work and begins nothing else", "[batch]") {
  std::stop_source stop;
  std::atomic<std::size_t> begun = 0;
  std::size_t delivered = 0;
  const auto work = [&](std::size_t i) {
    ++begun;
    if (i == 5) stop.request_stop();
    return i;
  };
  const auto list = names(10'000);
  const std::size_t count = for_each_in_order<std::size_t>(
      list, work, [&](std::size_t, Outcome<std::size_t>&&) { ++delivered; }, {.stop = stop.get_token()});
  CHECK(count == delivered);
  CHECK(count == begun);
  CHECK(count < 10'000);
}

TEST_CASE("Stopped and errors of the receiver end the loop", "[batch]") {
  const auto list = names(20);
  const auto ignore = [](std::size_t, Outcome<int>&&) {};
  CHECK_THROWS_AS(for_each_in_order<int>(
                      list, [](std::size_t) -> int { throw Stopped(); }, ignore),
                  Stopped);
  const auto full = [](std::size_t, Outcome<int>&&) { throw std::runtime_error("disk full"); };
  CHECK_THROWS_WITH(for_each_in_order<int>(
                        list, [](std::size_t) { return 1; }, full),
                    "disk full");
}
