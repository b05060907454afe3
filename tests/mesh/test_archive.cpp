// Members of archives as meshes.
#include <atomic>
#include <fstream>
#include <thread>

#include "archive/members.h"
#include "archive/unpack.h"
#include "archive/zip_index.h"
#include "rectilin/mesh/source.h"
#include "support/archives.h"
#include "support/catch.h"
#include "support/gltf_file.h"
#include "support/scratch_folder.h"

using namespace rectilin;
using namespace rectilin::test;
using Catch::Matchers::Contains;

namespace {

/// A fan of `faces` triangles as OFF text.
std::string fan(int faces) {
  std::string text = "OFF\n" + std::to_string(faces + 2) + " " + std::to_string(faces) + " 0\n0 0 0\n";
  for (int i = 0; i <= faces; ++i) text += "1 " + std::to_string(i) + " 0\n";
  for (int i = 1; i <= faces; ++i) text += "3 0 " + std::to_string(i) + " " + std::to_string(i + 1) + "\n";
  return text;
}

}  // namespace

TEST_CASE("archives of every kind are folders", "[archive]") {
  const ScratchFolder folder;
  for (const char* extension : {"zip", "7z", "tar", "tar.gz", "tar.xz"}) {
    const std::string file = (folder.path() / (std::string("a.") + extension)).string();
    write_archive(file,
                  {{"z/two.off", fan(2)}, {"readme.txt", "hello"}, {"a/\xc3\xbc.off", fan(3)}, {"a/._two.off", "x"}});
    const auto sources = expand_folders({file, "shape:box"});
    CHECK(sources == std::vector<std::string>{file + "::z/two.off", file + "::a/\xc3\xbc.off", "shape:box"});
    CHECK(load_mesh(sources[1]).mesh.triangles.size() == 3);
    CHECK(load_mesh(sources[0]).mesh.triangles.size() == 2);  // backward
    CHECK_THROWS_WITH(load_mesh(file + "::none.off"), Contains("none.off: no such member"));
    CHECK_THROWS_WITH(load_mesh(file), Contains("an archive of 2 meshes"));
  }
  CHECK(expand_folders({folder.path().string()}).size() == 10);  // archives within a folder
}

TEST_CASE("a compressed file is a mesh", "[archive]") {
  const ScratchFolder folder;
  for (const char* name : {"fan.off.gz", "fan.off.xz"}) {
    const std::string file = (folder.path() / name).string();
    write_archive(file, {{"ignored", fan(5)}});
    CHECK(load_mesh(file).mesh.triangles.size() == 5);
    CHECK(load_mesh(file + "::fan.off").mesh.triangles.size() == 5);
    CHECK(expand_folders({file}) == std::vector<std::string>{file + "::fan.off"});
  }
}

TEST_CASE("a glTF file in an archive finds its buffer there", "[archive]") {
  const ScratchFolder folder;
  const std::string file = (folder.path() / "a.zip").string();
  Json json = cube_json();
  json["buffers"][0]["uri"] = "../data/cube.bin";
  write_archive(file, {{"data/cube.bin", cube_buffer()},
                       {"models/cube.gltf", json.dump()},
                       {"cube.glb", glb(cube_json(), cube_buffer())}});
  const auto sources = expand_folders({file});
  REQUIRE(sources.size() == 2);
  for (const std::string& source : sources) CHECK(load_mesh(source).mesh.triangles.size() == 12);
  json["buffers"][0]["uri"] = "/etc/passwd";
  write_archive(file, {{"cube.gltf", json.dump()}});
  CHECK_THROWS_WITH(load_mesh(file + "::cube.gltf"), Contains("is not in the archive"));
}

TEST_CASE("members in any order, from many threads", "[archive]") {
  const ScratchFolder folder;
  const std::string file = (folder.path() / "a.tar.gz").string();
  Members members;
  for (int i = 1; i <= 60; ++i) members.emplace_back(std::to_string(i) + ".off", fan(i));
  write_archive(file, members);
  std::vector<std::thread> threads;
  std::atomic<int> wrong = 0;
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([&, t] {
      for (int k = 0; k < 60; ++k) {
        const int i = 1 + (t % 2 ? k : 59 - k);
        const auto loaded = load_mesh(file + "::" + std::to_string(i) + ".off");
        wrong += loaded.mesh.triangles.size() != static_cast<std::size_t>(i);
      }
    });
  for (std::thread& thread : threads) thread.join();
  CHECK(wrong == 0);

  SECTION("and anew when the file has changed") {
    write_archive(file, {{"1.off", fan(9)}});
    CHECK(load_mesh(file + "::1.off").mesh.triangles.size() == 9);
  }
}

TEST_CASE("what unpacks to too much is refused", "[archive]") {
  const ScratchFolder folder;
  const std::string bomb = "OFF" + std::string(70'000'000, '\n');
  for (const char* extension : {"zip", "tar.gz", "off.gz"}) {
    const std::string file = (folder.path() / (std::string("a.") + extension)).string();
    write_archive(file, {{"a.off", bomb}});
    CHECK_THROWS_WITH(load_mesh(file + "::a.off"), Contains("300 times its size"));
  }
  const std::string file = (folder.path() / "b.tar.gz").string();
  write_archive(file, {{"skipped.txt", bomb}, {"a.off", fan(1)}});  // skipping unpacks, too
  CHECK_THROWS_WITH(load_mesh(file + "::a.off"), Contains("300 times its size"));
}

TEST_CASE("broken archives are one error", "[archive]") {
  const ScratchFolder folder;
  for (const char* extension : {"zip", "7z", "tar.gz", "off.gz"}) {
    const auto file = folder.path() / (std::string("a.") + extension);
    write_archive(file, {{"a.off", fan(200)}});
    const std::string whole = text_of(file);
    for (const std::size_t size : {std::size_t{0}, whole.size() / 3, whole.size() / 2}) {
      std::ofstream(file, std::ios::binary) << whole.substr(0, size);
      CHECK_THROWS_AS(load_mesh(file.string() + "::a.off"), MeshError);
      CHECK_THROWS_AS(load_mesh(file.string()), MeshError);
      CHECK(expand_folders({file.string()}) == std::vector<std::string>{file.string()});
    }
  }
}

TEST_CASE("the parts of a member's name", "[archive]") {
  CHECK(parse_member("a.zip::b/c.obj")->archive == "a.zip");
  CHECK(parse_member("a.zip::b/c.obj")->member == "b/c.obj");
  CHECK(parse_member("x::y.tar.gz::c::d.obj")->archive == "x::y.tar.gz");
  CHECK_FALSE(parse_member("a::b.obj"));
  CHECK_FALSE(parse_member("a.zip"));
}

TEST_CASE("the table of a zip archive", "[archive]") {
  const ScratchFolder folder;
  const auto file = folder.path() / "a.zip";
  Members members;
  for (int i = 1; i <= 40; ++i) members.emplace_back("folder/" + std::to_string(i) + ".off", fan(i * i));
  members.emplace_back("empty.off", "");
  write_archive(file.string(), members);

  SECTION("reads what going through the archive reads") {
    const ZipIndex index(file);
    CHECK(index.size() == members.size());
    Unpacker unpacker(file);
    std::size_t seen = 0;
    for (; unpacker.next(); ++seen) CHECK(index.read(unpacker.member()) == unpacker.read());
    CHECK(seen == members.size());
    CHECK_FALSE(index.read("folder/41.off"));
    CHECK_FALSE(index.read("folder"));
  }
  SECTION("leaves what is not ordinary to libarchive") {
    write_archive(file.string(), {{"\xc3\xbc.off", fan(3)}, {"same.off", fan(1)}, {"same.off", fan(2)}});
    const ZipIndex index(file);
    CHECK_FALSE(index.read("\xc3\xbc.off"));
    CHECK_FALSE(index.read("same.off"));
    CHECK(load_mesh(file.string() + "::\xc3\xbc.off").mesh.triangles.size() == 3);
    // The same where the table says that the first of the two is encrypted.
    std::string text = text_of(file);
    const std::size_t first = text.find("PK\x01\x02", text.find("PK\x01\x02") + 1);
    text[first + 8] = static_cast<char>(text[first + 8] | 1);
    std::ofstream(file, std::ios::binary) << text;
    CHECK_FALSE(ZipIndex(file).read("same.off"));
    CHECK(ZipIndex(folder.path() / "none.zip").size() == 0);
    CHECK(ZipIndex(folder.path()).size() == 0);
  }
  SECTION("never gives content that was changed or is of another member") {
    write_archive(file.string(), {{"a.off", fan(7)}, {"b.off", fan(8)}});
    const std::string whole = text_of(file);
    const auto other = folder.path() / "b.zip";
    std::size_t read = 0, wrong = 0;
    for (std::size_t i = 0; i < whole.size(); ++i) {
      for (const int flip : {1, 0x80, 0xFF}) {
        std::string changed = whole;
        changed[i] = static_cast<char>(changed[i] ^ flip);
        std::ofstream(other, std::ios::binary) << changed;
        const ZipIndex index(other);
        const auto a = index.read("a.off"), b = index.read("b.off");
        read += a.has_value() + b.has_value();
        wrong += (a && *a != fan(7)) + (b && *b != fan(8));
      }
      std::ofstream(other, std::ios::binary) << whole.substr(0, i);
      const auto a = ZipIndex(other).read("a.off");
      wrong += a && *a != fan(7);
    }
    CHECK(wrong == 0);
    CHECK(read > whole.size());  // most changes are in the other member or in fields that do not matter
  }
}
