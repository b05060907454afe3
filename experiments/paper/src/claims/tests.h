// The tests of the claims, by id. Each group of claims is a file of its own.
#pragma once

#include <string_view>
#include <vector>

#include "claims/test_mesh.h"
#include "rectilin/base/random.h"
#include "rectilin/paper/claims.h"
#include "tables/retrieval_table.h"

namespace rectilin::paper::claims {

class TestCollection;

/// How a claim is tested. Tests are pure functions of their arguments and safe to call from many threads.
struct ClaimTest {
  std::string_view claim;
  /// The test on any mesh; may be null. It returns nothing if the claim does not apply to the mesh.
  std::optional<Finding> (*on_mesh)(const TestMesh& tested, Random random) = nullptr;
  /// The test on shapes that the claim is about; may be null.
  std::vector<Finding> (*on_shapes)(Random random) = nullptr;
  /// The share of the findings that may be worse than the decisive one: 0 if the claim is about every case.
  double quantile = 0;
  /// The test on a folder of models with classes; may be null. `rows` lists what must be computed for it.
  std::vector<Finding> (*on_collection)(const TestCollection& collection) = nullptr;
  std::vector<tables::Row> (*rows)() = nullptr;
};

const std::vector<ClaimTest>& claim_tests();

}  // namespace rectilin::paper::claims
