#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <thread>

#include "rectilin/base/unfinished_files.h"
#include "rectilin/base/whole_file.h"
#include "support/catch.h"
#include "support/scratch_folder.h"

using namespace rectilin;
using namespace std::string_view_literals;
namespace fs = std::filesystem;

namespace {

mode_t mode_of(const fs::path& file) {
  struct stat status {};
  REQUIRE(stat(file.c_str(), &status) == 0);
  return status.st_mode & 07777;
}

std::size_t count_files(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

}  // namespace

TEST_CASE("a file is written whole, beside whatever else there is", "[whole_file]") {
  const test::ScratchFolder scratch;
  const fs::path file = scratch.path() / "x";
  write_whole_file(scratch.path() / "x.new", "a user's");
  write_whole_file(file, "one");
  write_whole_file(file, "another");
  CHECK(read_whole_file(file) == "another");
  CHECK(read_whole_file(scratch.path() / "x.new") == "a user's");
  CHECK(count_files(scratch.path()) == 2);
  const fs::path longest = scratch.path() / std::string(255, 'n');
  write_whole_file(longest, "long");
  write_whole_file(longest, "longer");
  CHECK(read_whole_file(longest) == "longer");
  const std::string big(3'000'000, 'b');
  write_whole_file(file, big);
  CHECK(read_whole_file(file) == big);
}

TEST_CASE("a file that grows takes its name when it is whole", "[whole_file]") {
  const test::ScratchFolder scratch;
  const fs::path file = scratch.path() / "x";
  write_whole_file(file, "before");
  REQUIRE(chmod(file.c_str(), 0640) == 0);
  {
    GrowingFile never(file);
    never.write("half");
  }
  CHECK(read_whole_file(file) == "before");
  CHECK(count_files(scratch.path()) == 1);
  {
    GrowingFile grown(file);
    for (int i = 0; i < 1000; ++i) grown.write("ab\0"sv);
    CHECK(read_whole_file(file) == "before");
    grown.finish();
  }
  CHECK(read_whole_file(file).size() == 3000);
  CHECK(mode_of(file) == 0640);
  CHECK(count_files(scratch.path()) == 1);
  CHECK_THROWS_WITH(GrowingFile(file / "y"), Catch::Contains("y: cannot be written: not a directory"));
  CHECK_THROWS_WITH(GrowingFile(scratch.path()), Catch::Contains("cannot be written: is a directory"));
  CHECK(why_unreadable(file) == std::error_code());
  CHECK(why_unreadable(scratch.path()) == std::errc::is_a_directory);
  CHECK(why_unreadable(file / "y") == std::errc::not_a_directory);
}

TEST_CASE("what is replaced hands on its permissions; a link stays", "[whole_file]") {
  const test::ScratchFolder scratch;
  const fs::path file = scratch.path() / "x", link = scratch.path() / "link", nowhere = scratch.path() / "nowhere";
  write_whole_file(file, "one");
  for (const mode_t mode : {0600, 0640, 0777}) {
    REQUIRE(chmod(file.c_str(), mode) == 0);
    write_whole_file(file, "two");
    CHECK(mode_of(file) == mode);
  }
  fs::create_symlink("x", link);
  write_whole_file(link, "three");
  CHECK(fs::is_symlink(link));
  CHECK(read_whole_file(file) == "three");
  CHECK(mode_of(file) == 0777);
  fs::create_symlink("not-yet", nowhere);
  write_whole_file(nowhere, "four");
  CHECK(read_whole_file(scratch.path() / "not-yet") == "four");
}

TEST_CASE("errors have the system's reason", "[whole_file]") {
  const test::ScratchFolder scratch;
  const fs::path folder = scratch.path(), loop = folder / "loop";
  fs::create_symlink("loop", loop);
  write_whole_file(folder / "file", "");
  const std::string longer(256, 'n');
  CHECK_THROWS_WITH(write_whole_file(folder / "no" / "x", ""),
                    Catch::EndsWith(": cannot be written: no such file or directory"));
  CHECK_THROWS_WITH(write_whole_file(folder / "file" / "x", ""), Catch::EndsWith(": not a directory"));
  CHECK_THROWS_WITH(write_whole_file(folder / longer, ""), Catch::EndsWith(": file name too long"));
  CHECK_THROWS_WITH(write_whole_file(loop, ""), Catch::EndsWith(": too many levels of symbolic links"));
  CHECK_THROWS_WITH(write_whole_file(folder, ""), Catch::EndsWith(": is a directory"));
  CHECK_THROWS_WITH(read_whole_file(folder / "none"), Catch::EndsWith("none: no such file or directory"));
  CHECK_THROWS_WITH(read_whole_file(folder), Catch::EndsWith(": is a directory"));
  CHECK_THROWS_WITH(read_whole_file(loop), Catch::EndsWith(": too many levels of symbolic links"));
  CHECK_THROWS_WITH(read_whole_file("/dev/zero"), Catch::Contains("is a device"));
  if (fs::exists("/dev/full"))
    CHECK_THROWS_WITH(write_whole_file("/dev/full", "x"), Catch::EndsWith(": no space left on device"));
  CHECK(count_files(folder) == 2);
}

TEST_CASE("a pipe is read to its end", "[whole_file]") {
  const test::ScratchFolder scratch;
  const fs::path pipe = scratch.path() / "pipe";
  REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
  const std::string sent(300'000, 'p');
  std::thread writer([&] { std::ofstream(pipe, std::ios::binary) << sent; });
  CHECK(read_whole_file(pipe) == sent);
  writer.join();
}

TEST_CASE("unfinished files go away", "[whole_file]") {
  const test::ScratchFolder scratch;
  {
    UnfinishedFile unnamed(scratch.path()), named(scratch.path(), true), given(scratch.path());
    CHECK(named.named());
    CHECK(given.take_name());
    CHECK(count_files(scratch.path()) >= 2);
    remove_unfinished_files();
    CHECK(count_files(scratch.path()) == 0);
  }
  UnfinishedFile kept(scratch.path(), true);
  kept.become(scratch.path() / "kept");
  remove_unfinished_files();
  CHECK(count_files(scratch.path()) == 1);
}
