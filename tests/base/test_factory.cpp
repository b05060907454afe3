#include "rectilin/base/factory.h"
#include "support/catch.h"

using namespace rectilin;

namespace {

struct Sum {
  int a = 1, b = 2;
  void bind(Parameters& table) { table.integer("a", a, 0, 9, "first").integer("b", b, 0, 9, "second"); }
};

Factory<int, int> sums() {
  Factory<int, int> table("sum");
  table.add("plain", "a + b + c", Sum(), [](const Sum& s, int c) { return s.a + s.b + c; })
      .add("tenfold", "the same, times ten", Sum{.a = 5}, [](const Sum& s, int c) { return 10 * (s.a + s.b + c); });
  return table;
}

}  // namespace

TEST_CASE("a factory makes things from text, settings and context", "[factory]") {
  CHECK(sums().make("plain", 10) == 13);
  CHECK(sums().make("plain?a=4&b=0", 10) == 14);
  CHECK(sums().make("tenfold?b=3", 1) == 90);
  REQUIRE(sums().entries().size() == 2);
  CHECK(sums().entries()[1].parameters[0].value == 5);
  CHECK_THROWS_WITH(sums().make("plain?c=1", 0), Catch::Contains("plain"));
  CHECK_THROWS_AS(sums().make("plain?a=10", 0), ParameterError);
}

TEST_CASE("an unknown name suggests the nearest one, if there is one near", "[factory]") {
  CHECK_THROWS_WITH(sums().make("plian", 0), "no sum 'plian'; did you mean 'plain'? There are plain, tenfold");
  CHECK_THROWS_WITH(sums().make("TENFOLD", 0), Catch::Contains("did you mean 'tenfold'?"));
  CHECK_THROWS_WITH(sums().make("elephant", 0), "no sum 'elephant'; there are plain, tenfold");
  CHECK_THROWS_WITH(sums().make(std::string(100'000, 'x'), 0), Catch::EndsWith("'; there are plain, tenfold"));
}
