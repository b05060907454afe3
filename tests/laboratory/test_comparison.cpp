// Plans, runs that survive interruption, and what is made of them.
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "comparison_fixtures.h"
#include "rectilin/base/journal.h"
#include "rectilin/laboratory/comparison.h"
#include "rectilin/laboratory/report.h"
#include "rectilin/laboratory/summary.h"
#include "rectilin/measure/projected_area.h"
#include "rectilin/mesh/source.h"
#include "support/catch.h"

namespace rectilin::laboratory {
namespace {

using test::mesh_with;
using test::run_with;
using test::ScratchFolder;
using test::test_registry;
using test::text_of;

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::vector<std::string> labels(const std::vector<Entry>& entries) {
  std::vector<std::string> result;
  for (const Entry& entry : entries) result.push_back(entry.label);
  return result;
}

Plan small_plan() {
  Plan plan;
  plan.meshes = {"shape:box", "shape:pyramid"};
  plan.entries = parse_entries({"random, ga?population=20", "grid@zone"}, {"covering"}, test_registry());
  plan.runs = 3;
  plan.budget = 200;
  plan.seed = 7;
  plan.certificate = "known";
  return plan;
}

/// Lines of runs.jsonl in a fixed order and without times.
std::multiset<std::string> timeless_lines(const std::filesystem::path& folder) {
  std::multiset<std::string> lines;
  for (Json line : recover_journal(folder / "runs.jsonl")) {
    for (const char* key : {"seconds", "cpu_seconds", "threads"}) line.erase(key);
    line["trace"].erase("seconds");
    lines.insert(line.dump());
  }
  return lines;
}

TEST_CASE("a list of optimizers") {
  const Registry registry = test_registry();
  const std::vector<Entry> entries =
      parse_entries({"ga?population=20,random grid@zone", "best=grid?keep=1"}, {"paper"}, registry);
  CHECK(labels(entries) == std::vector<std::string>{"ga?population=20", "random", "grid@zone", "best"});
  CHECK(entries[2] == Entry{"grid@zone", "grid", "zone"});
  CHECK(entries[3] == Entry{"best", "grid?keep=1", "paper"});
  // Only optimizers that search a box are run on every box, unless they name one.
  CHECK(labels(parse_entries({"ga,random,grid@zone"}, {"paper", "covering"}, registry)) ==
        std::vector<std::string>{"ga@paper", "ga@covering", "random", "grid@zone"});
  CHECK_THROWS_AS(parse_entries({"gaa"}, {"paper"}, registry), ParameterError);
  CHECK_THROWS_AS(parse_entries({"ga@moon"}, {"paper"}, registry), ParameterError);
  CHECK_THROWS_AS(parse_entries({"ga"}, {"moon"}, registry), ParameterError);
}

TEST_CASE("a plan is checked and read back") {
  Plan plan = small_plan();
  CHECK_NOTHROW(check(plan, test_registry()));
  CHECK(plan_from_json(to_json(plan)) == plan);
  plan.entries.push_back(plan.entries.front());
  CHECK_THROWS_AS(check(plan, test_registry()), ParameterError);
  plan = small_plan();
  plan.meshes.push_back("shape:box");
  CHECK_THROWS_AS(check(plan, test_registry()), ParameterError);
}

TEST_CASE("an instance depends on seed, mesh and run") {
  const auto same = [](const Instance& a, const Instance& b) {
    return a.rotation.matrix() == b.rotation.matrix() && a.run_seed == b.run_seed;
  };
  CHECK(same(instance(1, "a", 0), instance(1, "a", 0)));
  CHECK_FALSE(same(instance(1, "a", 0), instance(1, "a", 1)));
  CHECK_FALSE(same(instance(1, "a", 0), instance(1, "b", 0)));
  CHECK_FALSE(same(instance(1, "a", 0), instance(2, "a", 0)));
}

TEST_CASE("a turned mesh has the values of the mesh at turned rotations") {
  const AreaVectors vectors = area_vectors(load_mesh("shape:blob?faces=500").mesh);
  Random random(3);
  const Rotation turn = random_rotation(random);
  const ProjectedArea straight(vectors), turned(rotated(vectors, turn));
  CHECK(turned.vectors().area() == straight.vectors().area());
  for (int i = 0; i < 10; ++i) {
    const Rotation r = random_rotation(random), back = r * turn;
    double a = 0, b = 0;
    turned.values({&r, 1}, {&a, 1});
    straight.values({&back, 1}, {&b, 1});
    CHECK(a == Approx(b).epsilon(1e-13));  // rounding of 500 terms
  }
}

TEST_CASE("every run of a plan is there, and none is better than the proof") {
  const ScratchFolder folder;
  const Plan plan = small_plan();
  const ComparisonOutcome outcome = run_comparison(plan, folder.path(), test_registry());
  CHECK(outcome.complete);
  CHECK(outcome.failed_runs == 0);
  const Results results = load_results(folder.path());
  CHECK(results.runs.size() == 2 * 3 * 3);
  const std::string lines = text_of(folder.path() / "runs.jsonl");
  std::ofstream(folder.path() / "runs.jsonl", std::ios::app) << lines;
  CHECK(load_results(folder.path()).runs.size() == results.runs.size());  // a run that is there twice counts once
  CHECK(results.meshes[0].upper == Approx(1).margin(1e-10));              // a box
  CHECK(results.meshes[1].lower == Approx(3 * (1 + std::sqrt(5.0)) / 4 - 2).margin(1e-10));  // THE pyramid
  for (const RunResult& run : results.runs) {
    CHECK(run.trace.final_gap() >= results.meshes[run.mesh].width());
    CHECK(std::ranges::is_sorted(run.trace.gap, std::greater<>()));
    CHECK(run.evaluations <= 200);
    // The rotation found, turned back, gives the same R on the mesh as it is.
    const ProjectedArea objective(area_vectors(load_mesh(results.meshes[run.mesh].name).mesh));
    double value = 0;
    objective.values({&run.rotation, 1}, {&value, 1});
    CHECK(rectilinearity(value) == Approx(run.merit).margin(1e-12));
  }
}

TEST_CASE("an interrupted comparison goes on where it stopped") {
  const ScratchFolder whole, broken;
  const Plan plan = small_plan();
  const Registry registry = test_registry();
  run_comparison(plan, whole.path(), registry);

  std::stop_source stop;
  ComparisonSettings settings;
  settings.stop = stop.get_token();
  settings.on_progress = [&](const ComparisonProgress& progress) {
    if (progress.done >= 5) stop.request_stop();
  };
  CHECK_FALSE(run_comparison(plan, broken.path(), registry, settings).complete);
  const std::size_t kept = recover_journal(broken.path() / "runs.jsonl").size();
  CHECK(kept >= 5);
  CHECK(kept < 18);

  // As if the power had failed in the middle of a line.
  const auto file = broken.path() / "runs.jsonl";
  std::filesystem::resize_file(file, std::filesystem::file_size(file) - 20);
  std::size_t found = 0;
  settings = {};
  settings.on_progress = [&](const ComparisonProgress& progress) {
    if (found == 0 && progress.total == 18) found = progress.done;
  };
  CHECK(run_comparison(plan, broken.path(), registry, settings).complete);
  CHECK(found == kept - 1);
  CHECK(timeless_lines(broken.path()) == timeless_lines(whole.path()));
}

TEST_CASE("results are the same for any number of threads") {
  const ScratchFolder one, four;
  {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
    run_comparison(small_plan(), one.path(), test_registry());
  }
  {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 4);
    run_comparison(small_plan(), four.path(), test_registry());
  }
  CHECK(timeless_lines(one.path()) == timeless_lines(four.path()));
}

TEST_CASE("a folder keeps to its plan") {
  const ScratchFolder folder;
  Plan plan = small_plan();
  plan.meshes = {"shape:box"};
  run_comparison(plan, folder.path(), test_registry());
  plan.budget = 300;
  try {
    run_comparison(plan, folder.path(), test_registry());
    FAIL("another plan was accepted");
  } catch (const ParameterError& e) {
    CHECK(contains(e.what(), "budget 200, not 300"));
  }
}

TEST_CASE("failures are rows") {
  const ScratchFolder folder;
  Plan plan = small_plan();
  plan.meshes = {"shape:box", "no-such-file.off"};
  plan.entries = parse_entries({"crash random"}, {"covering"}, test_registry());
  const ComparisonOutcome outcome = run_comparison(plan, folder.path(), test_registry());
  CHECK(outcome.complete);
  CHECK(outcome.failed_runs == 3);
  REQUIRE(outcome.mesh_errors.size() == 1);
  CHECK(contains(outcome.mesh_errors.front(), "no-such-file.off"));
  write_report(folder.path());
  const std::string page = text_of(folder.path() / "index.html");
  CHECK(contains(page, "it &lt;crashed&gt;"));
  CHECK(contains(page, "no-such-file.off"));
  CHECK(contains(text_of(folder.path() / "runs.csv"), "failed,it <crashed>"));
}

TEST_CASE("the report agrees with the runs") {
  const ScratchFolder folder;
  const Plan plan = small_plan();
  run_comparison(plan, folder.path(), test_registry());
  write_report(folder.path());
  const Results results = load_results(folder.path());
  const Json summary = Json::parse(text_of(folder.path() / "summary.json"));
  CHECK(summary["meshes"][1]["upper"].get<double>() == results.meshes[1].upper);
  const Json& cell = summary["optimizers"][0]["meshes"][1];
  CHECK(cell["runs"] == 3);
  CHECK(cell["failures"] == 0);
  std::vector<double> gaps;
  for (const RunResult* run : results.of(1, 0)) gaps.push_back(run->trace.final_gap());
  CHECK(cell["median_final_gap"].get<double>() == Approx(median(gaps)).epsilon(1e-12));
  const std::string page = text_of(folder.path() / "index.html");
  CHECK_FALSE(contains(page, "src=\"http"));  // nothing from the network
  CHECK_FALSE(contains(page, "href=\"http"));
}

TEST_CASE("a trace is a step function") {
  const Trace trace = run_with(0, 0, 0, {2, 10, 50}, {0.5, 0.1, 0.001}, 100).trace;
  CHECK(trace.gap_after(Cost::kEvaluations, 1) == 1.25);
  CHECK(trace.gap_after(Cost::kEvaluations, 2) == 0.5);
  CHECK(trace.gap_after(Cost::kEvaluations, 49) == 0.1);
  CHECK(trace.cost_to(Cost::kEvaluations, 0.1) == 10);
  CHECK(trace.cost_to(Cost::kEvaluations, 0.09) == 50);
  CHECK(std::isinf(trace.cost_to(Cost::kEvaluations, 1e-4)));
}

TEST_CASE("a summary of runs known by hand") {
  Results results;
  results.plan.meshes = {"open", "closed"};
  results.plan.entries = {{"a", "a", "covering"}, {"b", "b", "covering"}};
  results.plan.budget = 1000;
  results.meshes = {mesh_with("open", 0.4, 0.5), mesh_with("closed", 0.5, 0.5)};
  results.runs = {run_with(0, 0, 0, {1}, {0.2}, 1000),
                  run_with(0, 1, 0, {1}, {0.3}, 1000),
                  run_with(1, 0, 0, {1, 20}, {0.2, 1e-4}, 400),
                  run_with(1, 0, 1, {1}, {0.2}, 1000),
                  run_with(1, 1, 0, {1, 500}, {0.2, 1e-8}, 1000),
                  run_with(1, 1, 1, {1, 700}, {0.2, 1e-8}, 1000)};
  const Summary summary = summarise(results);
  const auto at = [](double target) {
    return static_cast<std::size_t>(
        std::ranges::find_if(targets(), [&](double t) { return std::abs(t / target - 1) < 1e-9; }) - targets().begin());
  };
  // A certificate of width 0.1 says nothing of smaller targets.
  CHECK(summary.cells[0][0].to_target[at(1e-2)].runs == 0);
  CHECK(summary.cells[0][1].to_target[at(1e-3)].expected() == Approx(1020));
  CHECK(summary.cells[1][1].to_target[at(1e-3)].expected() == Approx(600));
  CHECK(summary.cells[0][1].to_target[at(1e-6)].success_rate() == 0);
  CHECK(summary.overall[0][at(1e-3)].runs == 2);

  CHECK(summary.budgets == std::vector<std::uint64_t>{100, 1000});
  // After 100 evaluations `a` leads on both meshes, in the end on one of them.
  CHECK(summary.standings[0][0].mean_rank == 1);
  CHECK(summary.standings[0][1].mean_rank == 2);
  CHECK(summary.standings[1][0].mean_rank == 1.5);
  CHECK(summary.order(0).front() == 0);
  CHECK(summary.order(1).front() == 1);
  CHECK(summary.tests.size() == 2);
}

}  // namespace
}  // namespace rectilin::laboratory
