// What the graph of neighbours finds and costs, against the exact search.
//
//     bench_approximate SHAPES.db MEMBERS between|copies [QUERIES]
//     bench_approximate SHAPES.db 0 real        each model of the database among the others
//
// between: mixtures of models and their neighbours; copies: models perturbed. Times are of one thread's processor.
#include <sys/resource.h>
#include <tbb/global_control.h>
#include <time.h>

#include <iostream>

#include "grown.h"
#include "rectilin/search/approximate.h"

namespace {

using namespace rectilin;
using namespace rectilin::bench;
using namespace rectilin::search;

double processor_seconds() {
  timespec t;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

double megabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

int measure(const std::string& file, std::size_t count, const std::string& kind, std::size_t queries) {
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const Originals originals(file);
  const Between between(originals);
  const bool real = kind == "real";
  if (real) count = queries = originals.parts.size();
  const auto member = [&](std::uint64_t seed) {
    if (kind != "copies") return between.make(seed);
    Random random(seed);
    return perturbed(originals.parts[random.below(originals.parts.size())], random);
  };
  NearestSearch search(originals.descriptor);
  search.reserve(count);
  std::vector<std::int64_t> ids;
  for (std::size_t i = 0; i < count; ++i) {
    search.add(real ? originals.parts[i] : member(1000 + i));
    ids.push_back(static_cast<std::int64_t>(i));
  }
  std::cout << kind << ", " << count << " members: " << megabytes() << " MB with the signatures\n";

  double begin = processor_seconds();
  ApproximateSearch graph(search, ids);
  std::cout << "prepared in " << processor_seconds() - begin << " s\n";
  begin = processor_seconds();
  graph.build({{}, [&](std::size_t done, std::size_t total, const std::string&) {
                 if (done > 0 && done % (total / 10 / 64 * 64) == 0)
                   std::cout << "  " << done << " after " << processor_seconds() - begin << " s" << std::endl;
               }});
  std::cout << "built in " << processor_seconds() - begin << " s; " << graph.bytes().size() / count
            << " bytes a member; " << megabytes() << " MB in all at most\n";

  // Real models are members, and each is left out of what is found for it.
  const std::size_t wanted = real ? 21 : 20;
  std::vector<Parts> asked;
  std::vector<std::vector<Neighbour>> exact;
  double compared = 0;
  begin = processor_seconds();
  for (std::size_t q = 0; q < queries; ++q) {
    asked.push_back(real ? originals.parts[q] : member(77 + q * 1'000'000'007));
    NearestCosts costs;
    exact.push_back(search.nearest(asked.back(), wanted, {}, &costs));
    if (real) std::erase_if(exact.back(), [&](const Neighbour& n) { return n.member == q; });
    compared += static_cast<double>(costs.compared);
  }
  const double n = static_cast<double>(queries);
  std::cout << "exact " << 1e3 * (processor_seconds() - begin) / n << " ms a query, " << compared / n
            << " compared in full\n";
  for (const std::size_t width : {32, 64, 128, 256, 512, 1024}) {
    double seconds = 0, same = 0, near = 0, ratio = 0, worst = 1;
    for (std::size_t q = 0; q < queries; ++q) {
      begin = processor_seconds();
      auto found = graph.walk(asked[q], wanted, width);
      seconds += processor_seconds() - begin;
      if (real) std::erase_if(found, [&](const Neighbour& f) { return f.member == q; });
      double own = 0;
      for (std::size_t k = 0; k < 20; ++k) {
        same += std::ranges::find(exact[q], found[k]) != exact[q].end();
        near += found[k].distance <= 1.01 * exact[q][19].distance;
        own += found[k].distance > 0 ? exact[q][k].distance / found[k].distance : 1;
      }
      ratio += own / 20;
      worst = std::min(worst, own / 20);
    }
    std::cout << "width " << width << ": " << 100 * same / (20 * n) << " % of the 20 nearest found, "
              << 100 * near / (20 * n) << " % as near within 1 %; true distances are " << ratio / n
              << " of those found (worst query " << worst << "), " << 1e3 * seconds / n << " ms" << std::endl;
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string kind = argc > 3 ? argv[3] : "";
  if (kind != "between" && kind != "copies" && kind != "real") {
    std::cerr << "usage: bench_approximate SHAPES.db MEMBERS between|copies|real [QUERIES]\n";
    return 2;
  }
  try {
    return measure(argv[1], std::stoul(argv[2]), kind, argc > 4 ? std::stoul(argv[4]) : 100);
  } catch (const std::exception& e) {
    std::cerr << e.what() << '\n';
    return 1;
  }
}
