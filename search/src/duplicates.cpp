#include "rectilin/search/duplicates.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <numeric>
#include <optional>
#include <set>

#include "alignment.h"
#include "rectilin/base/printable.h"
#include "rectilin/mesh/source.h"
#include "rectilin/search/approximate.h"
#include "rectilin/search/nearest.h"

namespace rectilin::search {
namespace {

constexpr double kLikeR = 0.2;          // rectilinearities of a shape and of its simplified copy differ by less
constexpr double kFewShared = 16;       // vertices: a box shares seven of its eight with one whose corner is cut off
constexpr double kLikeMoments = 0.1;    // and their shares of the second moment
constexpr double kSame = 1e-3;          // surfaces that are nearer are the same without a reflection
constexpr double kClearlyNearer = 0.5;  // a reflection counts if it fits so much better

/// Members held together by pairs.
class Groups {
 public:
  explicit Groups(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), std::size_t{0}); }
  std::size_t find(std::size_t i) const {
    while (parent_[i] != i) i = parent_[i];
    return i;
  }
  bool unite(std::size_t i, std::size_t j) {
    i = find(i), j = find(j);
    parent_[std::max(i, j)] = std::min(i, j);
    return i != j;
  }

 private:
  std::vector<std::size_t> parent_;
};

struct Candidate {
  std::size_t first, second;
  double distance;
};

/// Pairs of members that are near each other; of those with the same bytes only the first. Nothing if it was stopped.
std::optional<std::vector<Candidate>> candidates_of(const NearestSearch& search, const ApproximateSearch* graph,
                                                    const std::vector<Member>& members,
                                                    const std::vector<std::size_t>& stands_for,
                                                    const DuplicateOptions& options, const LoopControl& control) {
  std::vector<std::vector<Candidate>> found(members.size());
  std::mutex mutex;
  std::size_t done = 0;
  tbb::parallel_for(std::size_t{0}, members.size(), [&](std::size_t i) {
    if (control.stop.stop_requested()) return;
    if (stands_for[i] == i) {
      const auto others = [&](std::size_t j) { return j != i && stands_for[j] == j; };
      for (const Neighbour& n : find_nearest(search, graph, search.parts_of(i), options.neighbours, others, false))
        if (n.distance <= options.widest &&
            std::abs(members[i].rectilinearity - members[n.member].rectilinearity) < kLikeR)
          found[i].push_back({std::min(i, n.member), std::max(i, n.member), n.distance});
    }
    const std::lock_guard lock(mutex);
    if (++done % 64 == 0 && control.on_progress) control.on_progress(done, members.size(), "looking for neighbours");
  });
  if (control.stop.stop_requested()) return std::nullopt;
  std::vector<Candidate> all;
  for (const auto& own : found) all.insert(all.end(), own.begin(), own.end());
  std::ranges::sort(all, [](const Candidate& a, const Candidate& b) {
    return std::pair(a.first, a.second) < std::pair(b.first, b.second);
  });
  const auto same = [](const Candidate& a, const Candidate& b) { return a.first == b.first && a.second == b.second; };
  all.erase(std::unique(all.begin(), all.end(), same), all.end());
  return all;
}

/// All groups of the pairs that were accepted; a member's reflection follows from those along the way to the first.
std::vector<DuplicateGroup> groups_of(const std::vector<DuplicateEvidence>& pairs, std::size_t members) {
  Groups groups(members);
  std::vector<std::vector<const DuplicateEvidence*>> links(members);
  for (const DuplicateEvidence& pair : pairs)
    if (groups.unite(pair.first, pair.second)) {
      links[pair.first].push_back(&pair);
      links[pair.second].push_back(&pair);
    }
  std::vector<DuplicateGroup> result;
  for (std::size_t i = 0; i < members; ++i) {
    if (groups.find(i) != i || links[i].empty()) continue;
    std::map<std::size_t, bool> mirrored{{i, false}};
    std::vector<std::size_t> open{i};
    DuplicateGroup group;
    while (!open.empty()) {
      const std::size_t at = open.back();
      open.pop_back();
      for (const DuplicateEvidence* link : links[at]) {
        const std::size_t other = link->first == at ? link->second : link->first;
        if (!mirrored.emplace(other, mirrored[at] != link->mirrored).second) continue;
        group.evidence.push_back(*link);
        open.push_back(other);
      }
    }
    for (const auto& [member, reflected] : mirrored) {
      group.members.push_back(member);
      group.mirrored.push_back(reflected);
    }
    std::ranges::sort(group.evidence, [](const DuplicateEvidence& a, const DuplicateEvidence& b) {
      return std::pair(a.first, a.second) < std::pair(b.first, b.second);
    });
    result.push_back(std::move(group));
  }
  return result;
}

}  // namespace

Duplicates find_duplicates(Database& database, const DuplicateOptions& options, const LoopControl& control) {
  Duplicates result;
  NearestSearch search(database.descriptor());
  search.reserve(database.described());
  database.for_each_signature([&](Member&& member, Parts&& parts) {
    search.add(parts);
    result.members.push_back(std::move(member));
  });
  const std::vector<Member>& members = result.members;
  std::vector<DuplicateEvidence> accepted;
  std::map<std::string, std::size_t> by_digest;
  std::vector<std::size_t> stands_for(members.size());  // of files that are the same one is compared
  for (std::size_t i = 0; i < members.size(); ++i) {
    const auto [first, is_new] = by_digest.emplace(members[i].digest, i);
    stands_for[i] = first->second;
    if (!is_new) accepted.push_back({first->second, i, 0, 0, 1, false, true, 1, {}});
  }
  std::unique_ptr<ApproximateSearch> graph;
  if (!options.graph.empty()) {
    try {
      graph = open_approximate(search, members, options.graph, control, result.note);
    } catch (const Stopped&) {
      return result;
    }
  }
  const auto near = candidates_of(search, graph.get(), members, stands_for, options, control);
  if (!near) return result;
  const std::vector<Candidate>& candidates = *near;
  result.pairs_looked_at = candidates.size();

  // Shapes that are in a candidate, read and prepared once.
  std::set<std::size_t> wanted;
  for (const Candidate& c : candidates) wanted.insert({c.first, c.second});
  const std::vector<std::size_t> list(wanted.begin(), wanted.end());
  std::vector<std::string> names;
  for (const std::size_t i : list) names.push_back(members[i].name);
  std::map<std::size_t, std::unique_ptr<AlignedShape>> shapes;
  const std::size_t steps = names.size() + candidates.size();
  LoopControl reading = control, fitting = control;
  if (control.on_progress) {
    reading.on_progress = [&](std::size_t done, std::size_t, const std::string& text) {
      control.on_progress(done, steps, text);
    };
    fitting.on_progress = [&](std::size_t done, std::size_t, const std::string& text) {
      control.on_progress(names.size() + done, steps, text);
    };
  }
  result.complete = for_each_in_order<std::unique_ptr<AlignedShape>>(
                        names,
                        [&](std::size_t k) {
                          const retrieval::Model model(load_mesh(members[list[k]].source).mesh);
                          return std::make_unique<AlignedShape>(model);
                        },
                        [&](std::size_t k, Outcome<std::unique_ptr<AlignedShape>>&& outcome) {
                          if (outcome.value) shapes[list[k]] = std::move(*outcome.value);
                          else result.errors.push_back(printable(outcome.error));
                        },
                        reading) == names.size();
  if (!result.complete) return result;

  std::vector<std::string> pair_names;
  for (const Candidate& c : candidates) pair_names.push_back(members[c.first].name);
  const auto compare = [&](std::size_t k) -> std::optional<DuplicateEvidence> {
    const Candidate& c = candidates[k];
    const auto a = shapes.find(c.first), b = shapes.find(c.second);
    if (a == shapes.end() || b == shapes.end()) return std::nullopt;
    const AlignedShape &first = *a->second, &second = *b->second;
    if ((first.moments() - second.moments()).lpNorm<Eigen::Infinity>() > kLikeMoments) return std::nullopt;
    Fit fit = best_fit(first, second, false);
    bool mirrored = false;
    if (fit.distance > kSame) {
      const Fit reflected = best_fit(first, second, true);
      mirrored = reflected.distance < kClearlyNearer * fit.distance;
      if (mirrored) fit = reflected;
    }
    if (fit.distance > options.loose) return std::nullopt;
    const bool first_is_fine = first.vertices().size() >= second.vertices().size();
    const VertexFit vertices = first_is_fine ? vertex_fit(first, second, fit) : vertex_fit(second, first, inverse(fit));
    if (fit.distance > options.tolerance) {
      const auto corners = static_cast<double>((first_is_fine ? second : first).vertices().size());
      if (vertices.share < options.shared || vertices.share * corners < kFewShared ||
          vertices.fit.distance > options.loose)
        return std::nullopt;
      fit = first_is_fine ? vertices.fit : inverse(vertices.fit);
    }
    const double scale = std::cbrt(std::abs(fit.linear.determinant()));
    return DuplicateEvidence{c.first,
                             c.second,
                             c.distance,
                             fit.distance,
                             vertices.share,
                             mirrored,
                             false,
                             second.unit() / (first.unit() * scale),
                             placement(first, second, fit)};
  };
  result.complete = for_each_in_order<std::optional<DuplicateEvidence>>(
                        pair_names, compare,
                        [&](std::size_t, Outcome<std::optional<DuplicateEvidence>>&& outcome) {
                          if (outcome.value && *outcome.value) accepted.push_back(**outcome.value);
                        },
                        fitting) == pair_names.size();
  // The surest pairs hold groups together, so that a mirror image is told by them.
  std::ranges::stable_sort(accepted, {}, &DuplicateEvidence::surface_distance);
  result.groups = groups_of(accepted, members.size());
  return result;
}

}  // namespace rectilin::search
