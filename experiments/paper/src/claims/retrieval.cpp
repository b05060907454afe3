#include "claims/retrieval.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <limits>
#include <stdexcept>

#include "rectilin/retrieval/descriptor.h"

namespace rectilin::paper::claims {
namespace {

/// The least time of one comparison in many tries, so that a busy machine matters little.
double seconds_to_compare(const std::string& spec, Random& random) {
  const retrieval::DescriptorPointer descriptor = retrieval::make_descriptor(spec);
  std::vector<retrieval::Signature> signatures(2, retrieval::Signature(descriptor->bytes()));
  for (auto& signature : signatures)
    for (auto& byte : signature) byte = static_cast<std::uint8_t>(random.below(256));
  using Clock = std::chrono::steady_clock;
  constexpr int kTries = 200, kTogether = 5;
  double least = std::numeric_limits<double>::infinity(), sum = 0;
  for (int i = 0; i < kTries; ++i) {
    const auto begin = Clock::now();
    for (int k = 0; k < kTogether; ++k) sum += descriptor->distance(signatures[0], signatures[1]);
    least = std::min(least, std::chrono::duration<double>(Clock::now() - begin).count() / kTogether);
  }
  return sum >= 0 ? least : 0;  // using the sum keeps the compiler from leaving the work out
}

}  // namespace

const tables::ScoredRow& TestCollection::row(const std::string& label) const {
  const auto found = std::ranges::find(table_.rows, label, [](const tables::ScoredRow& r) { return r.row.label; });
  if (found == table_.rows.end()) throw std::logic_error("no row '" + label + "'");
  return *found;
}

Finding TestCollection::difference(const std::string& better, const std::string& worse) const {
  const auto &a = row(better).scores.queries, &b = row(worse).scores.queries;
  std::vector<double> first, second;
  std::vector<std::size_t> group;
  for (std::size_t q = 0; q < a.size(); ++q) {
    if (!a[q].counts) continue;
    first.push_back(100 * a[q].measures.dcg);
    second.push_back(100 * b[q].measures.dcg);
    group.push_back(table_.class_of[q]);
  }
  if (first.empty()) throw ParameterError("no class of the collection has more than two models");
  const retrieval::PairedDifference d = retrieval::paired_difference(first, second, group);
  char note[120];
  std::snprintf(note, sizeof note, "DCG %.1f and %.1f, difference %.2f (95 %%: %.2f to %.2f)",
                100 * row(better).scores.micro.dcg, 100 * row(worse).scores.micro.dcg, d.mean, d.low, d.high);
  return {d.mean, better + " over " + worse, nullptr, {}, note};
}

std::vector<Finding> check_gsmd_beats_lfd(const TestCollection& c) { return {c.difference("GSMD_66", "LFD")}; }

std::vector<Finding> check_views_saturate(const TestCollection& c) { return {c.difference("GSMD_66", "GSMD_258")}; }

std::vector<Finding> check_cpn_beats_pca(const TestCollection& c) { return {c.difference("rect24", "pca24")}; }

std::vector<Finding> check_more_matches(const TestCollection& c) {
  return {c.difference("pca24", "pca4"), c.difference("pca4", "pca")};
}

std::vector<Finding> check_r_improves(const TestCollection& c) {
  std::vector<Finding> findings;
  for (const tables::Row& alone : tables::table4_rows())
    findings.push_back(c.difference(alone.label + " + R", alone.label));
  return findings;
}

std::vector<Finding> check_best_sum(const TestCollection& c) {
  std::vector<Finding> findings;
  const std::string best = tables::table5_rows().back().label;
  for (const auto& rows : {tables::table4_rows(), tables::table5_rows(), tables::table6_rows()})
    for (const tables::Row& row : rows)
      if (row.label != best && !row.descriptor.empty()) findings.push_back(c.difference(best, row.label));
  return findings;
}

std::vector<Finding> check_times_quicker(Random random) {
  const double gsmd = seconds_to_compare("gsmd?views=66", random), lfd = seconds_to_compare("lfd", random);
  char note[120];
  std::snprintf(note, sizeof note, "%.2g us against %.2g us, %.1f times", 1e6 * gsmd, 1e6 * lfd, lfd / gsmd);
  return {{lfd / gsmd - 70, "comparing two models", nullptr, {}, note}};
}

}  // namespace rectilin::paper::claims
