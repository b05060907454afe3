#include "features/code_book.h"

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>

namespace rectilin::retrieval {

extern const unsigned char kWordsFile[];
extern const std::size_t kWordsFileSize;

namespace {

constexpr std::array<char, 8> kWordsMark{'R', 'W', 'O', 'R', 'D', 'S', '0', '1'};

void to_unit_length(std::span<float> v) {
  double sum = 0;
  for (const float x : v) sum += static_cast<double>(x) * static_cast<double>(x);
  if (!(sum > 0)) return;
  const auto factor = static_cast<float>(1 / std::sqrt(sum));
  for (float& x : v) x *= factor;
}

}  // namespace

CodeBook CodeBook::parse(std::span<const std::uint8_t> bytes) {
  std::size_t at = 0;
  const auto take = [&](void* target, std::size_t size) {
    if (size > bytes.size() - at) throw std::runtime_error("the code book is cut off");
    if (size > 0) std::memcpy(target, bytes.data() + at, size);
    at += size;
  };
  std::array<char, 8> mark{};
  std::array<std::int32_t, 3> sizes{};
  take(mark.data(), mark.size());
  take(sizes.data(), sizeof sizes);
  CodeBook book;
  for (const std::int32_t n : sizes)
    if (mark != kWordsMark || n < 1 || n > 4096) throw std::runtime_error("not a code book");
  book.words = sizes[0];
  book.dims = sizes[1];
  book.numbers = sizes[2];
  const std::size_t n = book.residuals(), d = static_cast<std::size_t>(book.dims),
                    m = static_cast<std::size_t>(book.numbers);
  for (auto [list, size] : {std::pair{&book.mean, std::size_t{kLocal}},
                            {&book.components, d * kLocal},
                            {&book.centres, n},
                            {&book.offset, n},
                            {&book.scale, m}}) {
    list->resize(size);
    take(list->data(), 4 * size);
  }
  book.rows.resize(m * n);
  take(book.rows.data(), m * n);
  if (at != bytes.size()) throw std::runtime_error("bytes behind the code book");
  return book;
}

std::string CodeBook::to_bytes() const {
  std::string bytes(kWordsMark.begin(), kWordsMark.end());
  const auto put = [&](const void* source, std::size_t size) { bytes.append(static_cast<const char*>(source), size); };
  for (const std::int32_t n : {words, dims, numbers}) put(&n, 4);
  for (const auto* list : {&mean, &components, &centres, &offset, &scale}) put(list->data(), 4 * list->size());
  put(rows.data(), rows.size());
  return bytes;
}

const CodeBook& CodeBook::built_in() {
  static const CodeBook book = parse({kWordsFile, kWordsFileSize});
  return book;
}

void project(const CodeBook& book, const LocalFeature& feature, std::span<float> components) {
  LocalFeature centred;
  for (std::size_t i = 0; i < kLocal; ++i) centred[i] = feature[i] - book.mean[i];
  for (std::size_t d = 0; d < components.size(); ++d) {
    const float* row = book.components.data() + d * kLocal;
    std::array<float, 16> sums{};  // side by side, so that the order of additions is fixed and vectors can be used
    for (std::size_t i = 0; i < kLocal; i += 16)
      for (std::size_t k = 0; k < 16; ++k) sums[k] += centred[i + k] * row[i + k];
    float sum = 0;
    for (const float s : sums) sum += s;
    components[d] = sum;
  }
}

void Residuals::add(const LocalFeature& feature) {
  const std::size_t d = static_cast<std::size_t>(book_.dims);
  std::array<float, kLocal> own{};
  project(book_, feature, std::span(own).first(d));
  float nearest = std::numeric_limits<float>::max();
  std::size_t word = 0;
  for (std::size_t w = 0; w < static_cast<std::size_t>(book_.words); ++w) {
    const float* centre = book_.centres.data() + w * d;
    std::array<float, 8> sums{};
    for (std::size_t i = 0; i + 8 <= d; i += 8)
      for (std::size_t k = 0; k < 8; ++k) {
        const float difference = own[i + k] - centre[i + k];
        sums[k] += difference * difference;
      }
    float sum = 0;
    for (const float s : sums) sum += s;
    if (sum < nearest) {
      nearest = sum;
      word = w;
    }
  }
  for (std::size_t i = 0; i < d; ++i) sums_[word * d + i] += own[i] - book_.centres[word * d + i];
}

std::vector<float> Residuals::finished() const {
  std::vector<float> v = sums_;
  const std::size_t d = static_cast<std::size_t>(book_.dims);
  for (std::size_t w = 0; w < static_cast<std::size_t>(book_.words); ++w)
    to_unit_length(std::span(v).subspan(w * d, d));
  for (float& x : v) x = std::copysign(std::sqrt(std::abs(x)), x);
  to_unit_length(v);
  return v;
}

std::vector<float> project(const CodeBook& book, std::span<const float> residuals) {
  const std::size_t n = book.residuals();
  std::vector<float> centred(n), result(static_cast<std::size_t>(book.numbers));
  for (std::size_t i = 0; i < n; ++i) centred[i] = residuals[i] - book.offset[i];
  for (std::size_t m = 0; m < result.size(); ++m) {
    const std::int8_t* row = book.rows.data() + m * n;
    std::array<float, 16> sums{};
    for (std::size_t i = 0; i + 16 <= n; i += 16)
      for (std::size_t k = 0; k < 16; ++k) sums[k] += centred[i + k] * static_cast<float>(row[i + k]);
    float sum = 0;
    for (const float s : sums) sum += s;
    result[m] = sum * book.scale[m];
  }
  to_unit_length(result);
  return result;
}

}  // namespace rectilin::retrieval
