#include "json_member.h"
#include "rectilin/base/parameters.h"
#include "support/catch.h"

using namespace rectilin;
using namespace rectilin::corpus;

TEST_CASE("a member of a JSON object that is text", "[corpus]") {
  const Json object = {{"inner", {{"x", 1}, {"deep", {{"y", "}]\\\""}}}}},
                       {"words", "a, \"x\":7, {b}"},
                       {"list", {{1, 2}, {3, {{"x", 4}}}}},
                       {"x", -2.5e-300},
                       {"nothing", nullptr},
                       {"empty", Json::object()},
                       {"last", true}};
  const std::string text = to_text(object);
  for (const auto& [key, value] : object.items()) CHECK(member_of(text, key) == to_text(value));
  CHECK(member_of(text, "y").empty());
  CHECK(member_of(text, "deep").empty());
  CHECK(member_of("{}", "x").empty());
  // What was cut off or is no object is no reason to read outside of it.
  for (std::size_t size = 0; size < text.size(); ++size) member_of(std::string_view(text).substr(0, size), "last");
}
