// JSON to text and back.
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include "rectilin/base/json_text.h"
#include "support/catch.h"
#include "support/scratch_folder.h"

using namespace rectilin;

TEST_CASE("numbers read back as they were") {
  for (const double x : {0.1, 1.0 / 3, -2.5e-300, 1e22, std::numeric_limits<double>::denorm_min()})
    REQUIRE(parse_json(to_text(x)).get<double>() == x);
  REQUIRE(to_text(0.1) == "0.1");
}

TEST_CASE("bytes that are not UTF-8 become text that can be read") {
  REQUIRE(parse_json(to_text("a\xFFz")).get<std::string>() == "a\xEF\xBF\xBDz");
}

TEST_CASE("what is not one JSON value is refused, or null") {
  for (const char* text : {"", "{", "[1] 2", "nul", "{\"a\":1,}"}) {
    CAPTURE(text);
    REQUIRE_THROWS_AS(parse_json(text), Json::parse_error);
    REQUIRE(parse_json_or_null(text).is_null());
  }
  REQUIRE(parse_json_or_null(" [1, 2]\n") == Json({1, 2}));
}

TEST_CASE("a file of JSON, or null") {
  const test::ScratchFolder folder;
  const auto file = folder.path() / "note.json";
  REQUIRE(read_json_or_null(file).is_null());
  std::ofstream(file) << "{\"a\": ";
  REQUIRE(read_json_or_null(file).is_null());
  std::ofstream(file) << "{\"a\": 1}\n";
  REQUIRE(read_json_or_null(file) == Json({{"a", 1}}));
}
