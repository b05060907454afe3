// Lists of meshes.
#include <fstream>

#include "rectilin/mesh/source.h"
#include "support/catch.h"
#include "support/scratch_folder.h"

using namespace rectilin;
using namespace rectilin::test;
using Catch::Matchers::Contains;

namespace {

std::string write(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
  return file.string();
}

}  // namespace

TEST_CASE("a list of lines", "[manifest]") {
  const ScratchFolder folder;
  const std::string at = folder.path().string() + "/";
  std::filesystem::create_directories(folder.path() / "more");
  write(folder.path() / "more" / "b.off", "");
  const std::string list =
      write(folder.path() / "list.txt", "# meshes\r\na.off\tchair\r\n\nmore\tlamp # both\nshape:box\n/x#1.off\n");
  CHECK(expand_sources({list}) == std::vector<NamedSource>{{"a.off", at + "a.off", "chair"},
                                                           {"more/b.off", at + "more/b.off", "lamp"},
                                                           {"shape:box", "shape:box", ""},
                                                           {"/x#1.off", "/x#1.off", ""}});
}

TEST_CASE("a list as CSV", "[manifest]") {
  const ScratchFolder folder;
  const std::string at = folder.path().string() + "/";
  const std::string list =
      write(folder.path() / "list.csv",
            "\xEF\xBB\xBFid,Path,faces,Class\n1,a.off,12,\"a \"\"b\"\", c\"\n,\"two\nlines.off\"\n\n3,c.off,,x\n");
  CHECK(expand_sources({list}) == std::vector<NamedSource>{{"1", at + "a.off", "a \"b\", c"},
                                                           {"two\nlines.off", at + "two\nlines.off", ""},
                                                           {"3", at + "c.off", "x"}});
}

TEST_CASE("lists that are none", "[manifest]") {
  const ScratchFolder folder;
  CHECK_THROWS_WITH(expand_sources({write(folder.path() / "a.csv", "a.off,chair\n")}), Contains("a.csv:line 1: "));
  CHECK_THROWS_WITH(expand_sources({write(folder.path() / "b.csv", "path,class\na.off,x\n,y\n")}),
                    Contains("b.csv:line 3: no source"));
  CHECK_THROWS_WITH(expand_sources({write(folder.path() / "c.csv", "path\n\"a.off\n")}),
                    Contains("c.csv:line 2: a quotation"));
  const std::string mesh = write(folder.path() / "mesh.txt", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  CHECK(expand_sources({mesh})[0].source == mesh);
  CHECK(load_mesh(mesh).mesh.triangles.size() == 1);
  CHECK(expand_sources({"none.txt"})[0].source == "none.txt");
}
