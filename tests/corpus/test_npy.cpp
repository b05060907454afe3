#include "npy.h"
#include "support/catch.h"

using namespace rectilin::corpus;

TEST_CASE("the header is that of the format", "[corpus]") {
  const std::vector<std::string> fields = {"('name', '|S3')", "('x', '<f8')"};
  const std::string header = npy_header(fields, 7);
  CHECK(header.substr(0, 8) == std::string("\x93NUMPY\x01\x00", 8));
  CHECK(header.size() % 64 == 0);
  const auto length = static_cast<unsigned char>(header[8]) + 256 * static_cast<unsigned char>(header[9]);
  CHECK(header.size() == 10u + static_cast<unsigned>(length));
  CHECK(header.back() == '\n');
  CHECK(header.substr(10).starts_with(
      "{'descr': [('name', '|S3'), ('x', '<f8'), ], 'fortran_order': False, 'shape': (7,), }"));
}
