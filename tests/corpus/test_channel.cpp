#include "channel.h"

#include <sys/socket.h>

#include <string>

#include "support/catch.h"

using namespace rectilin;
using namespace rectilin::corpus;

TEST_CASE("a mesh is sent byte for byte", "[corpus]") {
  const std::string odd("a b\0\n\xff 7", 8);
  for (const NamedSource& mesh : {NamedSource{"name", "source", "class"}, NamedSource{"", "", ""},
                                  NamedSource{odd, odd + odd, ""}, NamedSource{"12 3 x", "4 5 y", odd}})
    CHECK(mesh_in(mesh_message(mesh)) == mesh);
  mesh_in("");  // what is no such message is no reason to read outside of it
  mesh_in("999 999 x");
}

TEST_CASE("messages come in their order, and the next one can be looked at first", "[corpus]") {
  int ends[2];
  REQUIRE(socketpair(AF_UNIX, SOCK_STREAM, 0, ends) == 0);
  Channel here(ends[0]), there(ends[1]);
  CHECK_FALSE(there.take(Kind::kCancel));
  REQUIRE(here.send(Kind::kMesh, "first"));
  REQUIRE(here.send(Kind::kCancel, ""));
  REQUIRE(here.send(Kind::kMesh, "second"));
  CHECK_FALSE(there.take(Kind::kCancel));  // it is not the next
  CHECK(there.receive()->content == "first");
  CHECK(there.take(Kind::kCancel));
  CHECK_FALSE(there.take(Kind::kCancel));
  CHECK(there.receive()->content == "second");
}
