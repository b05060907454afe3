#include "rectilin/retrieval/distance_matrix.h"

#include <tbb/parallel_for.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <string>

#include "rectilin/base/system_reason.h"
#include "rectilin/base/whole_file.h"

namespace rectilin::retrieval {

static_assert(std::endian::native == std::endian::little && sizeof(float) == 4, "files are written as memory has them");

DistanceMatrix symmetric_matrix(std::size_t size, const std::function<double(std::size_t, std::size_t)>& distance) {
  DistanceMatrix matrix(size);
  tbb::parallel_for(std::size_t{0}, size, [&](std::size_t i) {
    for (std::size_t j = 0; j < i; ++j) matrix.at(i, j) = matrix.at(j, i) = static_cast<float>(distance(i, j));
  });
  return matrix;
}

void write_matrix(const std::filesystem::path& file, const DistanceMatrix& matrix) {
  write_whole_file(file, {reinterpret_cast<const char*>(matrix.values().data()), matrix.values().size() * 4});
}

DistanceMatrix read_matrix(const std::filesystem::path& file, std::size_t size) {
  if (const std::error_code error = why_unreadable(file))
    throw std::runtime_error(file.string() + ": " + system_reason(error));
  std::ifstream in(file, std::ios::binary | std::ios::ate);
  const auto bytes = static_cast<std::size_t>(in.tellg());
  if (bytes != size * size * 4)
    throw std::runtime_error(file.string() + ": has " + std::to_string(bytes) + " bytes; the distances of " +
                             std::to_string(size) + " models take " + std::to_string(size * size * 4));
  DistanceMatrix matrix(size);
  in.seekg(0);
  in.read(reinterpret_cast<char*>(matrix.values().data()), static_cast<std::streamsize>(bytes));
  if (!in) throw std::runtime_error(file.string() + ": cannot be read");
  for (std::size_t i = 0; i < size * size; ++i)
    if (std::isnan(matrix.values()[i]))
      throw std::runtime_error(file.string() + ":byte " + std::to_string(4 * i) + ": is not a number");
  return matrix;
}

}  // namespace rectilin::retrieval
