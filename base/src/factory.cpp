#include "rectilin/base/factory.h"

#include <cctype>

namespace rectilin {
namespace {

/// How many insertions, deletions, replacements and swaps of neighbours turn `a` into `b`, if capitals do not matter
/// (the optimal string alignment distance).
std::size_t typing_errors(std::string_view a, std::string_view b) {
  const auto same = [](char x, char y) {
    return std::tolower(static_cast<unsigned char>(x)) == std::tolower(static_cast<unsigned char>(y));
  };
  std::vector<std::vector<std::size_t>> cost(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i)
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        cost[i][j] = i + j;
        continue;
      }
      const bool equal = same(a[i - 1], b[j - 1]);
      cost[i][j] = std::min({cost[i - 1][j] + 1, cost[i][j - 1] + 1, cost[i - 1][j - 1] + (equal ? 0 : 1)});
      if (i > 1 && j > 1 && same(a[i - 1], b[j - 2]) && same(a[i - 2], b[j - 1]))
        cost[i][j] = std::min(cost[i][j], cost[i - 2][j - 2] + 1);
    }
  return cost[a.size()][b.size()];
}

}  // namespace

void throw_unknown_name(std::string_view kind, std::string_view name, const std::vector<std::string>& known) {
  constexpr std::size_t kLongest = 100;  // longer names are no typing errors, and the table above grows with the square
  std::string nearest, all;
  std::size_t least = name.size() <= kLongest ? std::max<std::size_t>(1, name.size() / 3) + 1 : 0;
  for (const std::string& candidate : known) {
    all += (all.empty() ? "" : ", ") + candidate;
    if (least == 0 || candidate.size() > kLongest) continue;
    const std::size_t errors = typing_errors(name, candidate);
    if (errors < least) least = errors, nearest = candidate;
  }
  std::string message = "no " + std::string(kind) + " '" + std::string(name) + "'; ";
  message += nearest.empty() ? "there are " : "did you mean '" + nearest + "'? There are ";
  throw ParameterError(message + all);
}

}  // namespace rectilin
