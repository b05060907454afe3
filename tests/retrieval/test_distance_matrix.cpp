// Matrices: to a file and back, and files that are none.
#include <cmath>
#include <fstream>
#include <limits>

#include "rectilin/retrieval/distance_matrix.h"
#include "support/catch.h"
#include "support/scratch_folder.h"

using namespace rectilin::retrieval;

TEST_CASE("A matrix file is rows of little-endian floats and reads back") {
  const rectilin::test::ScratchFolder folder;
  DistanceMatrix matrix(2);
  matrix.at(0, 1) = 1.5f;
  matrix.at(1, 0) = -2;
  write_matrix(folder.path() / "a.matrix", matrix);
  CHECK(rectilin::test::text_of(folder.path() / "a.matrix") ==
        std::string("\0\0\0\0\0\0\xc0\x3f\0\0\0\xc0\0\0\0\0", 16));
  CHECK(read_matrix(folder.path() / "a.matrix", 2).values() == matrix.values());
}

TEST_CASE("Files that are not the matrix asked for are refused") {
  const rectilin::test::ScratchFolder folder;
  const std::string file = (folder.path() / "a.matrix").string();
  DistanceMatrix matrix(2);
  matrix.at(1, 0) = std::numeric_limits<float>::quiet_NaN();
  write_matrix(file, matrix);
  CHECK_THROWS_WITH(read_matrix(file, 3), file + ": has 16 bytes; the distances of 3 models take 36");
  CHECK_THROWS_WITH(read_matrix(file, 2), file + ":byte 8: is not a number");
  CHECK_THROWS_WITH(read_matrix("/nowhere.matrix", 2), "/nowhere.matrix: no such file or directory");
}

TEST_CASE("A symmetric matrix asks for each pair once") {
  const DistanceMatrix m =
      symmetric_matrix(4, [](std::size_t i, std::size_t j) { return static_cast<double>(10 * i + j); });
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      CHECK(m.at(i, j) == (i == j ? 0.f : static_cast<float>(10 * std::max(i, j) + std::min(i, j))));
}
