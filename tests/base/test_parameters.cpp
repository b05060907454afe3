#include "rectilin/base/parameters.h"
#include "support/catch.h"

using namespace rectilin;

namespace {

enum class Colour { kRed, kBlue };

struct Options {
  int count = 5;
  double rate = 0.5;
  bool fast = false;
  std::uint64_t seed = 1;
  Colour colour = Colour::kRed;
  Parameters table() {
    Parameters p;
    p.integer("count", count, 1, 10, "how many")
        .real("rate", rate, 0, 1, "how often")
        .flag("fast", fast, "hurry")
        .seed("seed", seed, "seed")
        .choice("colour", colour, {{"red", Colour::kRed}, {"blue", Colour::kBlue}}, "which");
    return p;
  }
};

std::string complaint(const std::string& spec) {
  Options options;
  try {
    const Spec parsed = Spec::parse(spec);
    options.table().set(parsed.settings, parsed.name);
  } catch (const ParameterError& e) {
    return e.what();
  }
  return "";
}

}  // namespace

TEST_CASE("a spec is a name and typed settings", "[parameters]") {
  const Spec spec = Spec::parse("ga?a=1&b=0.5&c=true&d=text&e=&f=1e3&g=[1]");
  REQUIRE(spec.name == "ga");
  REQUIRE(spec.settings["a"] == 1);
  REQUIRE(spec.settings["b"] == 0.5);
  REQUIRE(spec.settings["c"] == true);
  REQUIRE(spec.settings["d"] == "text");
  REQUIRE(spec.settings["e"] == "");
  REQUIRE(spec.settings["f"] == 1000);
  REQUIRE(spec.settings["g"] == "[1]");
  REQUIRE(Spec::parse("ga").settings.empty());
  REQUIRE(Spec::parse("ga?").settings.empty());
}

TEST_CASE("settings go into the struct and come back", "[parameters]") {
  Options options;
  options.table().set(Spec::parse("x?count=7&rate=0.25&fast=true&seed=18446744073709551615&colour=blue").settings, "x");
  REQUIRE(options.count == 7);
  REQUIRE(options.rate == 0.25);
  REQUIRE(options.fast);
  REQUIRE(options.seed == ~std::uint64_t{0});
  REQUIRE(options.colour == Colour::kBlue);
  Options again;
  again.table().set(options.table().values(), "x");
  REQUIRE(again.table().values() == options.table().values());
}

TEST_CASE("wrong settings are named, with what would be right", "[parameters]") {
  REQUIRE(complaint("x?count=0") == "x: count=0 is not accepted (integer, 1 to 10)");
  REQUIRE(complaint("x?count=2.5") == "x: count=2.5 is not accepted (integer, 1 to 10)");
  REQUIRE(complaint("x?count=1e300") == "x: count=1e+300 is not accepted (integer, 1 to 10)");
  REQUIRE(complaint("x?rate=nan") == "x: rate=\"nan\" is not accepted (number, 0 to 1)");
  REQUIRE(complaint("x?fast=1") == "x: fast=1 is not accepted (true or false)");
  REQUIRE(complaint("x?seed=-1") == "x: seed=-1 is not accepted (integer, 0 or more)");
  REQUIRE(complaint("x?colour=green") == "x: colour=\"green\" is not accepted (red | blue)");
  REQUIRE(complaint("x?speed=1") == "x: no parameter 'speed'; it has count, rate, fast, seed, colour");
  REQUIRE(complaint("x?count") == "x: 'count' is not key=value");
  REQUIRE(complaint("x?count=1&count=2") == "x: 'count' is given twice");
  REQUIRE(complaint("?count=1") == "'?count=1' has no name");
  REQUIRE(complaint("x?count=3&rate=1&fast=false") == "");
}
