// What sections 7.1 and 7.2 say about retrieval. All tests but the one of times need a folder of models with classes.
#pragma once

#include "claims/tests.h"
#include "tables/rows.h"

namespace rectilin::paper::claims {

/// The rows of the tables and their scores, by label.
class TestCollection {
 public:
  explicit TestCollection(tables::ScoredTable table) : table_(std::move(table)) {}

  /// Throws std::logic_error for a row that the claim did not ask for.
  const tables::ScoredRow& row(const std::string& label) const;

  /// The DCG of one row less that of another, in percentage points; the note has the 95 % interval of the difference.
  Finding difference(const std::string& better, const std::string& worse) const;

 private:
  tables::ScoredTable table_;
};

/// GSMD_66 "provides better classification than LFD".
std::vector<Finding> check_gsmd_beats_lfd(const TestCollection& collection);
/// "higher-level descriptor does not guarantee better discrimination": 258 views compared with 66.
std::vector<Finding> check_views_saturate(const TestCollection& collection);
/// Table 3: composite pose normalization compared with principal axes.
std::vector<Finding> check_cpn_beats_pca(const TestCollection& collection);
/// Table 3: 24 ways to match compared with 4, and 4 compared with 1.
std::vector<Finding> check_more_matches(const TestCollection& collection);
/// Tables 4 and 5: R added to each of six descriptors.
std::vector<Finding> check_r_improves(const TestCollection& collection);
/// Tables 4 to 6: GSMD + SHD + R compared with every other row that is computed.
std::vector<Finding> check_best_sum(const TestCollection& collection);

/// "performs about 70 times quicker": compares the times of comparing two models, in one run.
std::vector<Finding> check_times_quicker(Random random);

}  // namespace rectilin::paper::claims
