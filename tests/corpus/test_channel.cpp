#include <sys/socket.h>

#include <memory>
#include <string>

#include "channel.h"
#include "support/catch.h"

using namespace rectilin;
using namespace rectilin::corpus;

TEST_CASE("a mesh is sent byte for byte", "[corpus]") {
  const std::string odd("a b\0\n\xff 7", 8);
  for (const NamedSource& mesh : {NamedSource{"name", "source", "class"}, NamedSource{"", "", ""},
                                  NamedSource{odd, odd + odd, ""}, NamedSource{"12 3 x", "4 5 y", odd}})
    CHECK(job_in(job_message(7, mesh)) == MeshJob{7, mesh});
  job_in("");  // what is no such message is no reason to read outside of it
  job_in("999 999 999 x");
}

TEST_CASE("messages come in their order, whole, and none after the end", "[corpus]") {
  int ends[2];
  REQUIRE(socketpair(AF_UNIX, SOCK_STREAM, 0, ends) == 0);
  auto here = std::make_unique<Channel>(ends[0]);
  Channel there(ends[1]);
  CHECK_FALSE(there.next());
  const std::string bytes("a\0b", 3);
  REQUIRE(here->send(Kind::kMesh, "first"));
  REQUIRE(here->send(Kind::kCancel, ""));
  REQUIRE(here->send(Kind::kResult, bytes));
  CHECK(there.receive()->content == "first");
  CHECK(there.next()->kind == Kind::kCancel);
  CHECK(there.receive()->content == bytes);
  CHECK(there.fill());
  CHECK_FALSE(there.next());
  here.reset();
  CHECK_FALSE(there.receive());
}
