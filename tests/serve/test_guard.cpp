// Which requests are refused because of who sends them.
#include "http/guard.h"
#include "support/catch.h"

using namespace rectilin::serve;

TEST_CASE("The server goes by addresses, localhost and the names it is given", "[serve]") {
  for (const char* host : {"127.0.0.1", "127.0.0.1:8000", "192.168.1.20:8737", "[::1]:8000", "[::1]", "localhost",
                           "LocalHost:1", "Printer.local:8737"})
    CHECK(is_own_host(host, {"printer.LOCAL"}));
  for (const char* host :
       {"", "evil.example", "127.0.0.1.evil.example", "localhost.evil.example", "127.0.0.1:8000@evil.example",
        "localhost:80:80", "[::1", "[::1]x", "::1", "127.1", "localhost:123456", "printer.local"})
    CHECK_FALSE(is_own_host(host, {}));
}

TEST_CASE("Requests by pages of other sites are refused", "[serve]") {
  Request request{"GET", "/api/shapes", {}, {{"host", "localhost:8000"}}};
  CHECK_FALSE(refused_by_guard(request, {}));
  request.headers["sec-fetch-site"] = "same-origin";
  CHECK_FALSE(refused_by_guard(request, {}));
  request.headers["sec-fetch-site"] = "cross-site";
  REQUIRE(refused_by_guard(request, {}));
  CHECK(refused_by_guard(request, {})->status == 403);
  request.path = "/";  // a link to the page
  CHECK_FALSE(refused_by_guard(request, {}));
  request = {"POST", "/api/search", {}, {{"host", "localhost:8000"}, {"origin", "http://localhost:8000"}}};
  CHECK_FALSE(refused_by_guard(request, {}));
  for (const char* origin : {"http://localhost:8001", "https://localhost:8000", "http://evil.example", "null", ""}) {
    request.headers["origin"] = origin;
    CHECK(refused_by_guard(request, {}));
  }
}
