// Classifications: what is read from good files, and the line that bad ones get.
#include <cstdlib>

#include "rectilin/retrieval/classification.h"
#include "support/catch.h"

using namespace rectilin::retrieval;

namespace {

constexpr const char* kSmall = "PSB 1\n3 3\n\nanimal 0 0\n\nbiped animal 2\nm1\nm2\n\r\nchair 0 1\n7\n\n";

std::string complaint(const std::string& text) {
  try {
    parse_classification(text, "x.cla");
  } catch (const std::runtime_error& e) {
    return e.what();
  }
  return "";
}

}  // namespace

TEST_CASE("Classes are read with parents, models and empty ones") {
  const Classification c = parse_classification(kSmall, "x.cla");
  REQUIRE(c.classes.size() == 3);
  CHECK(c.classes[0].models.empty());
  CHECK(c.classes[1].models == std::vector<std::size_t>{0, 1});
  CHECK(c.path(1) == "animal/biped");
  CHECK(c.path(2) == "chair");
  CHECK(c.models == std::vector<std::string>{"m1", "m2", "7"});
  CHECK(c.class_of == std::vector<std::size_t>{1, 1, 2});
}

TEST_CASE("A subset renumbers the models and keeps all classes") {
  const Classification c = parse_classification(kSmall, "x.cla").subset({false, true, true});
  CHECK(c.models == std::vector<std::string>{"m2", "7"});
  CHECK(c.class_of == std::vector<std::size_t>{1, 2});
  CHECK(c.classes[1].models == std::vector<std::size_t>{0});
  CHECK(c.classes[2].models == std::vector<std::size_t>{1});
}

TEST_CASE("A bad classification gets a line that says where") {
  CHECK(complaint("") == "x.cla:line 1: the file ends where 'PSB' should be");
  CHECK(complaint("OFF\n1 1\n") == "x.cla:line 1: not a classification: it does not begin with 'PSB 1'");
  CHECK(complaint("PSB 2\n") == "x.cla:line 1: only version 1 is known");
  CHECK(complaint("PSB 1\n1 x\n") == "x.cla:line 2: 'x' stands where the number of models should be");
  CHECK(complaint("PSB 1\n1 -1\n") == "x.cla:line 2: '-1' stands where the number of models should be");
  CHECK(complaint("PSB 1\n2 0\na 0 0\na 0 0\n") == "x.cla:line 4: class 'a' is there twice");
  CHECK(complaint("PSB 1\n1 0\na b 0\n") == "x.cla:line 3: class 'a': no earlier class is called 'b'");
  CHECK(complaint("PSB 1\n1 0\na a 0\n") == "x.cla:line 3: class 'a': no earlier class is called 'a'");
  CHECK(complaint("PSB 1\n2 2\na 0 1\n5\nb 0 1\n5\n") == "x.cla:line 6: model '5' is there twice, in 'a' and in 'b'");
  CHECK(complaint("PSB 1\n1 2\na 0 3\n5\n6\n") == "x.cla:line 6: the file ends where a model should be");
  CHECK(complaint("PSB 1\n1 2\na 0 1\n5\n") == "x.cla:line 5: there are 1 models, 2 are announced");
  CHECK(complaint("PSB 1\n1 1\na 0 1\n5\n6\n") == "x.cla:line 5: there is more than the 1 classes announced");
  CHECK_THROWS_WITH(read_classification("/nowhere.cla"), "/nowhere.cla: no such file or directory");
  CHECK_THROWS_WITH(read_classification("/"), "/: is a directory");
}

TEST_CASE("The training half of the Princeton Shape Benchmark") {
  const char* data = std::getenv("RECTILIN_DATA");
  if (data == nullptr) {
    WARN("skipped: RECTILIN_DATA is not set");
    return;
  }
  const Classification c = read_classification(std::string(data) + "/psb/classification/v1/base/train.cla");
  CHECK(c.classes.size() == 129);
  CHECK(c.models.size() == 907);
  CHECK(c.path(2) == "aircraft/airplane/F117");
  std::size_t leaves = 0;
  for (const auto& leaf : c.classes) leaves += !leaf.models.empty();
  CHECK(leaves == 90);
}
