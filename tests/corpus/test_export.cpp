#include <cstring>
#include <sstream>

#include "corpus/fixtures.h"
#include "rectilin/corpus/export_store.h"

using namespace rectilin;
using namespace rectilin::corpus;
using namespace rectilin::test;

namespace {

void fill(const std::filesystem::path& file) {
  Store store(file, {"test", Json::object()});
  Row row;
  row.name = "b,1";
  row.source = "b.off";
  row.group = "chairs";
  row.status = RowStatus::kDone;
  row.digest = "d";
  row.result = R"({"faces":12,"area":0.1,"rectilinearity":0.30000000000000004,"lower":0.25,"upper":null,)"
               R"("rotation":[[1,2,3],[4,5,-6.5],[7,8,1e-300]]})";
  row.report = R"({"vertices":8})";
  row.version = "1";
  row.seconds = 2;
  store.put(row);
  row = {};
  row.name = row.source = "a";
  row.status = RowStatus::kFailed;
  row.error = "a: no \"such\" file";
  store.put(row);
  row.name = "left";
  row.status = RowStatus::kLeft;
  store.put(row);
}

}  // namespace

TEST_CASE("a store as CSV, JSON lines and an array", "[corpus]") {
  const ScratchFolder folder;
  fill(folder.path() / "store.db");
  Store store(folder.path() / "store.db");

  export_store(store, folder.path() / "rows.csv");
  CHECK(text_of(folder.path() / "rows.csv") ==
        "name,class,status,digest,faces,area,rectilinearity,lower,upper,seconds,version,error\n"
        "a,,failed,,,,,,,0,,\"a: no \"\"such\"\" file\"\n"
        "\"b,1\",chairs,done,d,12,0.1,0.30000000000000004,0.25,,2,1,\n");

  export_store(store, folder.path() / "rows.jsonl");
  std::istringstream lines(text_of(folder.path() / "rows.jsonl"));
  std::string line;
  REQUIRE(std::getline(lines, line));
  CHECK(Json::parse(line)["error"] == "a: no \"such\" file");
  REQUIRE(std::getline(lines, line));
  const Json json = Json::parse(line);
  CHECK(json["rectilinearity"] == 0.30000000000000004);
  CHECK(json["report"]["vertices"] == 8);
  CHECK(json["class"] == "chairs");
  CHECK(json["upper"].is_null());
  CHECK_FALSE(std::getline(lines, line));

  export_store(store, folder.path() / "rows.npy");
  const std::string npy = text_of(folder.path() / "rows.npy");
  const std::size_t record = 3 + 6 + 1 + 8 + 5 * 8 + 9 * 8;  // the longest name is "b,1", the longest class "chairs"
  REQUIRE(npy.size() % 64 == 2 * record % 64);
  const char* last = npy.data() + npy.size() - record;
  CHECK(std::string(last, 3) == "b,1");
  CHECK(last[9] == 3);
  double r = 0, corner = 0;
  std::memcpy(&r, last + 26, sizeof r);
  std::memcpy(&corner, last + record - 8, sizeof corner);
  CHECK(r == 0.30000000000000004);
  CHECK(corner == 1e-300);

  CHECK_THROWS_AS(export_store(store, folder.path() / "rows.xls"), ParameterError);
  CHECK_THROWS_AS(export_store(store, folder.path() / "no" / "rows.csv"), std::runtime_error);
}
