// Databases: what is added, skipped, moved and removed, and what is refused.
#include <filesystem>
#include <fstream>

#include "rectilin/mesh/mesh_io.h"
#include "rectilin/mesh/shapes.h"
#include "rectilin/mesh/source.h"
#include "rectilin/search/describe.h"
#include "rectilin/search/index.h"
#include "support/catch.h"
#include "support/scratch_folder.h"

using namespace rectilin;
using namespace rectilin::search;
namespace fs = std::filesystem;

namespace {

constexpr const char* kText = "d2?samples=1000+r";

void put_shape(const fs::path& file, const std::string& shape) { write_mesh(file, load_mesh("shape:" + shape).mesh); }

std::vector<std::string> names_of(Database& database) {
  std::vector<std::string> names;
  for (const Member& m : database.members()) names.push_back(fs::path(m.name).filename());
  return names;
}

}  // namespace

TEST_CASE("a database follows its folders") {
  const test::ScratchFolder scratch;
  const fs::path folder = scratch.path() / "meshes", file = scratch.path() / "shapes.db";
  fs::create_directories(folder / "deep");
  put_shape(folder / "a.off", "box?x=2");
  put_shape(folder / "b.off", "torus");
  put_shape(folder / "deep/c.off", "stairs");
  std::ofstream(folder / "bad.off") << "OFF\n3 1 0\n";
  const std::vector<std::string> sources{folder.string()};
  {
    Database database(file, kText);
    const IndexSummary first = update_index(database, sources);
    CHECK(first.complete);
    CHECK(first.added == 3);
    REQUIRE(first.errors.size() == 1);
    CHECK(first.errors[0].find("bad.off") != std::string::npos);
    CHECK(names_of(database) == std::vector<std::string>{"a.off", "b.off", "bad.off", "c.off"});
    const auto a = database.find((folder / "a.off").string());
    REQUIRE(a);
    CHECK(a->rectilinearity == Approx(1));
    CHECK(a->size == Approx(2));
    CHECK(a->faces == load_mesh("shape:box?x=2").mesh.triangles.size());
    const Parts parts = database.signature(a->id);
    REQUIRE(parts.size() == 2);
    CHECK(parts == describe_source((folder / "a.off").string(), make_terms(kText)).parts);
  }
  Database database(file, kText);
  const IndexSummary again = update_index(database, sources);
  CHECK(again.unchanged == 4);
  CHECK(again.added + again.changed + again.moved + again.removed == 0);
  CHECK(again.errors.size() == 1);

  // Two files change places, one moves, one goes, one is new as a copy, the bad one is mended.
  const auto before_b = database.signature(database.find((folder / "b.off").string())->id);
  fs::rename(folder / "a.off", folder / "x");
  fs::rename(folder / "b.off", folder / "a.off");
  fs::rename(folder / "x", folder / "b.off");
  fs::rename(folder / "deep/c.off", folder / "moved.off");
  fs::copy_file(folder / "moved.off", folder / "copy.off");
  put_shape(folder / "bad.off", "pyramid");
  const IndexSummary third = update_index(database, sources);
  CHECK(third.errors.empty());
  CHECK(third.removed == 0);
  CHECK(third.moved + third.copied == 2);
  CHECK(names_of(database) == std::vector<std::string>{"a.off", "b.off", "bad.off", "copy.off", "moved.off"});
  CHECK(database.signature(database.find((folder / "a.off").string())->id) == before_b);
  for (const Member& m : database.members())
    CHECK(database.signature(m.id) == describe_source(m.source, make_terms(kText)).parts);

  fs::remove(folder / "copy.off");
  CHECK(update_index(database, sources).removed == 1);
  // What lies elsewhere stays.
  fs::create_directories(scratch.path() / "other");
  put_shape(scratch.path() / "other/d.off", "cylinder");
  CHECK(update_index(database, {(scratch.path() / "other").string()}).added == 1);
  CHECK(database.members().size() == 5);
}

TEST_CASE("an index that was stopped goes on") {
  const test::ScratchFolder scratch;
  std::vector<std::string> sources;
  for (int i = 1; i <= 12; ++i) sources.push_back("shape:box?x=" + std::to_string(i));
  Database database(scratch.path() / "shapes.db", "r");
  std::stop_source stop;
  const LoopControl control{stop.get_token(), [&](std::size_t done, std::size_t, const std::string&) {
                              if (done >= 3) stop.request_stop();
                            }};
  const IndexSummary first = update_index(database, sources, control);
  CHECK_FALSE(first.complete);
  CHECK(first.added >= 3);
  const IndexSummary second = update_index(database, sources);
  CHECK(second.complete);
  CHECK(second.added + first.added == 12);
  CHECK(second.unchanged == first.added);
}

TEST_CASE("what is no database, or another, is refused and stays as it is") {
  const test::ScratchFolder scratch;
  const fs::path file = scratch.path() / "shapes.db";
  {
    Database database(file, "r");
    update_index(database, {"shape:box", "shape:torus"});
    CHECK_THROWS_WITH(Database(file, "r"), Catch::Contains("another program"));
  }
  CHECK_THROWS_AS(Database(file, "d2"), ParameterError);
  CHECK_THROWS_AS(Database(scratch.path() / "new.db", "nothing"), ParameterError);
  CHECK_FALSE(fs::exists(scratch.path() / "new.db"));
  CHECK_THROWS_WITH(Database(scratch.path() / "missing.db"), Catch::Contains("missing.db"));
  CHECK_FALSE(fs::exists(scratch.path() / "missing.db"));

  const fs::path foreign = scratch.path() / "foreign.db";
  std::ofstream(foreign) << "this is a text and no database, whatever it is called, and it is long enough\n";
  const std::string before = test::text_of(foreign);
  CHECK_THROWS_WITH(Database(foreign), Catch::Contains("foreign.db"));
  CHECK_THROWS_WITH(Database(foreign, "r"), Catch::Contains("foreign.db"));
  CHECK(test::text_of(foreign) == before);

  const std::string whole = test::text_of(file);
  for (const std::size_t size : {std::size_t{50}, whole.size() / 2, whole.size() - 4096}) {
    std::ofstream(scratch.path() / "cut.db", std::ios::binary) << whole.substr(0, size);
    const auto read = [&] {
      Database database(scratch.path() / "cut.db");
      database.for_each_signature([](Member&&, Parts&&) {});
    };
    CHECK_THROWS_WITH(read(), Catch::Contains("cut.db"));
  }
}
