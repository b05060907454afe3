// The table from the ids of claims to their tests.
#include <set>
#include <string>
#include <utility>

#include "claims/definition.h"
#include "claims/inequalities.h"
#include "claims/known_values.h"
#include "claims/lemma1.h"
#include "claims/range_of_r.h"
#include "claims/rectilinear.h"
#include "claims/retrieval.h"
#include "claims/robustness.h"
#include "claims/search_cost.h"
#include "claims/search_domain.h"
#include "claims/views.h"

namespace rectilin::paper::claims {
namespace {

std::vector<tables::Row> only(std::vector<tables::Row> rows, const std::set<std::string>& labels) {
  std::erase_if(rows, [&](const tables::Row& row) { return !labels.contains(row.label); });
  return rows;
}

std::vector<tables::Row> gsmd_and_lfd() { return only(tables::table2_rows(), {"GSMD_66", "LFD"}); }

std::vector<tables::Row> gsmd_of_more_views() { return only(tables::table2_rows(), {"GSMD_66", "GSMD_258"}); }

std::vector<tables::Row> tables_4_and_5() {
  std::vector<tables::Row> rows = tables::table4_rows();
  for (tables::Row& row : tables::table5_rows()) rows.push_back(std::move(row));
  return rows;
}

std::vector<tables::Row> tables_4_to_6() {
  std::vector<tables::Row> rows = tables_4_and_5();
  for (tables::Row& row : tables::table6_rows()) rows.push_back(std::move(row));
  return rows;
}

}  // namespace

const std::vector<ClaimTest>& claim_tests() {
  using S = const TestMesh&;
  using Found = std::optional<Finding>;
  using Several = std::vector<Finding>;
  static const std::vector<ClaimTest> tests{
      {"definition", [](S s, Random r) -> Found { return check_definition(s, std::move(r), rotation_from_euler); }},
      {"euler-angles", nullptr,
       [](Random r) -> Several { return {check_convention(std::move(r), rotation_from_euler)}; }},
      {"eq-22", [](S s, Random r) -> Found { return check_angles(s, std::move(r)); }},
      {"eq-8", [](S s, Random r) -> Found { return check_lower_per_face(s, std::move(r)); }},
      {"eq-9", [](S s, Random r) -> Found { return check_upper_per_face(s, std::move(r)); }},
      {"eq-12", [](S s, Random r) -> Found { return check_bounds_of_mesh(s, std::move(r)); }},
      {"theorem-1-if", [](S s, Random) -> Found { return check_rectilinear_gives_equality(s); }},
      {"theorem-1-only-if", [](S s, Random) -> Found { return check_equality_gives_rectilinear(s); }},
      {"near-rectilinear", nullptr, check_tilted_top},
      {"theorem-2-1", [](S s, Random) -> Found { return check_positive(s); }},
      {"theorem-2-2", nullptr, check_octahedral_spheres},
      {"eq-24", [](S s, Random) -> Found { return check_mean(s); }},
      {"theorem-3-1", [](S s, Random) -> Found { return check_range(s); }},
      {"theorem-3-2", [](S s, Random) -> Found { return check_one_iff_rectilinear(s); }, check_known_shapes},
      {"theorem-3-3", nullptr, check_even_spheres},
      {"theorem-3-4", [](S s, Random r) -> Found { return check_similarity(s, std::move(r)); }},
      {"lemma-1", [](S s, Random r) -> Found { return check_not_constant(s, std::move(r)); }},
      {"eq-41", [](S s, Random r) -> Found { return check_second_difference(s, std::move(r)); }},
      {"eq-28", [](S s, Random) -> Found { return check_paper_box(s); }},
      {"eq-28-turned", [](S s, Random r) -> Found { return check_paper_box_in_another_pose(s, std::move(r)); }},
      {"eq-28-cubes", nullptr, check_cubes_on_paper_box},
      {"eq-28-share", nullptr, check_three_quarters},
      {"eq-28-covering",
       [](S s, Random r) -> Found { return check_domain_on_mesh(s, std::move(r), covering_domain()); },
       [](Random r) -> Several { return {check_domain_on_frames(std::move(r), covering_domain())}; }},
      {"eq-28-zone", [](S s, Random r) -> Found { return check_domain_on_mesh(s, std::move(r), zone_domain()); },
       [](Random r) -> Several { return {check_domain_on_frames(std::move(r), zone_domain())}; }},
      {"linear-cost", nullptr, check_linear_cost},
      {"stable-150", [](S s, Random r) -> Found { return check_stable(s, std::move(r)); }, check_stable_on_shapes, 0.5},
      {"stable-150-always", nullptr, check_always_stable},
      {"stability", [](S s, Random r) -> Found { return check_stability(s, std::move(r)); }},
      {"noise-at-any-scale", nullptr, check_noise_on_fine_box},
      {"deletion", check_deletion, check_deletion_on_large_shapes},
      {"deletion-law", check_deletion_law},
      {"deletion-small", nullptr, check_deletion_on_small_shape},
      {"simplification", nullptr, check_simplification},
      {"pyramid", nullptr, check_pyramid},
      {"stepped-pyramid", nullptr, check_stepped_pyramids},
      {"closed-forms", nullptr, check_closed_forms},
      {"table-1", nullptr, check_table_1},
      {"eq-29", nullptr, check_sphere_sizes},
      {"eq-33-permutations", nullptr, check_permutations},
      {"storage-44", nullptr, check_storage},
      {"view-pairs-70", nullptr, check_view_pairs},
      {"time-70", nullptr, check_times_quicker},
      {"gsmd-beats-lfd", nullptr, nullptr, 0, check_gsmd_beats_lfd, gsmd_and_lfd},
      {"views-saturate", nullptr, nullptr, 0, check_views_saturate, gsmd_of_more_views},
      {"cpn-beats-pca", nullptr, nullptr, 0, check_cpn_beats_pca, tables::table3_rows},
      {"more-matches", nullptr, nullptr, 0, check_more_matches, tables::table3_rows},
      {"r-improves", nullptr, nullptr, 0, check_r_improves, tables_4_and_5},
      {"best-sum", nullptr, nullptr, 0, check_best_sum, tables_4_to_6},
  };
  return tests;
}

}  // namespace rectilin::paper::claims
