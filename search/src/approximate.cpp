#include "rectilin/search/approximate.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <numeric>
#include <stdexcept>
#include <unordered_map>

#include "rectilin/base/fnv1a.h"
#include "rectilin/base/random.h"
#include "rectilin/base/whole_file.h"
#include "rectilin/search/diffusion.h"

// The intrinsics are for distances of hnswlib's own, which are not used, and prefetch beyond the end of lists.
#define NO_MANUAL_VECTORIZATION
#include <hnswlib/hnswlib.h>

namespace rectilin::search {
namespace {

// How these were chosen: papers/search.md.
constexpr std::size_t kLinks = 10;        // of a member that is added; at most twice as many on the lowest level
constexpr std::size_t kBuildWidth = 100;  // candidates among which its links are chosen
constexpr std::size_t kWalkWidth = 512;   // candidates that a search ends with
constexpr std::size_t kWorthWalking = 8;  // a walk looks at about so many members for each of these
constexpr double kLengthened = 1.5;       // see MembersSpace
constexpr std::uint64_t kLevelSeed = 1;
constexpr double kFloatSlack = 1e-6;  // the walk's distances are of single precision
constexpr std::uint32_t kNobody = 0xffffffff;

using Graph = hnswlib::HierarchicalNSW<float>;

/// What the walk takes for a member that is none. Members are their numbers, 32 bits.
struct WalkQuery {
  std::uint32_t nobody = kNobody;
  const Parts* parts;
  const Parts* rough;
};

/// The distance between two nodes' numbers, or a WalkQuery and a number: signatures stay where they are.
///
/// hnswlib links a new node to a candidate only if none of its links so far is nearer to the candidate than it is. Of a
/// shape and its variations, each of which is nearer to that shape than to all others, this leaves one link, and most
/// of them cannot be reached. So a link counts as further from the candidate than it is. hnswlib has no setting for
/// that; but it is for these distances, and for lists that are full, in which all are lengthened alike, that it asks
/// with two places in its own memory.
class MembersSpace final : public hnswlib::SpaceInterface<float> {
 public:
  explicit MembersSpace(const NearestSearch& search) : search_(search) {}
  std::size_t get_data_size() override { return sizeof(std::uint32_t); }
  hnswlib::DISTFUNC<float> get_dist_func() override { return &distance; }
  void* get_dist_func_param() override { return this; }
  void set_lengthening(bool on) { factor_ = on ? kLengthened : 1; }
  void set_memory(const char* begin, std::size_t size) { begin_ = begin, end_ = begin + size; }

 private:
  static float distance(const void* a, const void* b, const void* of) {
    const MembersSpace& space = *static_cast<const MembersSpace*>(of);
    std::uint32_t first, second;  // not aligned
    std::memcpy(&first, a, sizeof first);
    std::memcpy(&second, b, sizeof second);
    if (first != kNobody) {
      const char* at = static_cast<const char*>(a);
      const bool between_nodes = !std::less<>()(at, space.begin_) && std::less<>()(at, space.end_);
      return static_cast<float>((between_nodes ? space.factor_ : 1) * space.search_.rough_distance(first, second));
    }
    const WalkQuery& query = *static_cast<const WalkQuery*>(a);
    return static_cast<float>(space.search_.rough_distance(*query.parts, *query.rough, second));
  }
  const NearestSearch& search_;
  double factor_ = 1;
  const char *begin_ = nullptr, *end_ = nullptr;
};

bool nearer_by_walk(const Neighbour& a, const Neighbour& b) {
  return a.distance < b.distance || (a.distance == b.distance && a.member < b.member);
}

// A file: the kind, the header's numbers, the level of each node in a byte, for each node and each of its levels the
// number of links in a byte and the links, and the hash of all that. Numbers are little-endian.
constexpr std::string_view kGraphKind = "rectilin graph 1";
struct GraphHeader {
  std::uint64_t nodes, key, entry, bytes;  // bytes: of the whole file
};
constexpr std::size_t kHashBytes = 8;
constexpr std::size_t kSmallest = kGraphKind.size() + sizeof(GraphHeader) + kHashBytes;

/// Reads numbers from bytes and notices where they end.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : rest_(bytes) {}
  template <class Number>
  bool read(Number* out, std::size_t count = 1) {
    if (count > rest_.size() / sizeof(Number)) return false;
    if (count > 0) std::memcpy(out, rest_.data(), count * sizeof(Number));
    rest_.remove_prefix(count * sizeof(Number));
    return true;
  }
  bool at_end() const { return rest_.empty(); }

 private:
  std::string_view rest_;
};

template <class Number>
void append(std::string& bytes, const Number* numbers, std::size_t count = 1) {
  bytes.append(reinterpret_cast<const char*>(numbers), count * sizeof(Number));
}

}  // namespace

struct ApproximateSearch::Implementation {
  const NearestSearch& search;
  std::unique_ptr<hnswlib::SpaceInterface<float>> space;
  std::vector<std::uint32_t> first;   ///< of each node the member that is first by id
  std::vector<std::uint32_t> next;    ///< of each member another one with the same signature, or kNobody
  std::vector<std::uint64_t> hashes;  ///< of each node's signature
  std::unique_ptr<Graph> graph;

  Implementation(const NearestSearch& s, const std::vector<std::int64_t>& ids)
      : search(s), space(std::make_unique<MembersSpace>(s)) {
    if (ids.size() != s.size()) throw std::invalid_argument("an id for each member");
    if (ids.size() >= kNobody) throw std::invalid_argument("too many members for a graph");
    std::vector<std::uint32_t> order(ids.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::sort(order, {}, [&](std::uint32_t i) { return ids[i]; });
    std::vector<std::uint64_t> hash_of(ids.size());
    tbb::parallel_for(std::size_t{0}, ids.size(), [&](std::size_t i) {
      Fnv1aWords hash;
      for (const retrieval::Signature& part : s.parts_of(i)) hash.add(part.data(), part.size());
      hash_of[i] = hash.value();
    });
    next.assign(ids.size(), kNobody);
    std::unordered_map<std::uint64_t, std::uint32_t> member_with;
    std::vector<std::uint32_t> last(ids.size());  // of the members that have one's signature
    for (const std::uint32_t i : order) {
      last[i] = i;
      const auto [found, is_new] = member_with.emplace(hash_of[i], i);
      if (!is_new && s.parts_of(found->second) == s.parts_of(i)) {
        next[last[found->second]] = i;
        last[found->second] = i;
        continue;
      }
      first.push_back(i);
      hashes.push_back(hash_of[i]);
    }
    clear();
  }

  void clear() {
    graph.reset();  // before another takes as much memory
    graph = std::make_unique<Graph>(space.get(), std::max<std::size_t>(first.size(), 1), kLinks, kBuildWidth);
    static_cast<MembersSpace&>(*space).set_memory(graph->data_level0_memory_,
                                                  graph->max_elements_ * graph->size_data_per_element_);
  }

  std::size_t built() const { return graph->cur_element_count; }

  /// Of the first so many nodes: what a graph of them depends on.
  std::uint64_t key(std::size_t nodes) const {
    Fnv1aWords hash;
    hash.add(search.descriptor().data(), search.descriptor().size());
    hash.add(kLinks).add(kBuildWidth).add(kLevelSeed).add(std::bit_cast<std::uint64_t>(kLengthened));
    for (std::size_t k = 0; k < nodes; ++k) hash.add(hashes[k]);
    return hash.value();
  }

  /// The highest level of a node: a function of its number, so that a graph can be gone on with.
  static int level_of(std::size_t node) {
    const double u = 1 - Random(kLevelSeed).fork(node).uniform();  // above 0
    return static_cast<int>(-std::log(u) / std::log(static_cast<double>(kLinks)));
  }

  void add_node(std::size_t node) {
    // hnswlib draws a level unless it is given one above zero; with this factor it draws zero.
    graph->mult_ = 0;
    // The tenth of the nodes that is on higher levels, too, keeps hnswlib's rule: their links lead far.
    static_cast<MembersSpace&>(*space).set_lengthening(level_of(node) == 0);
    graph->addPoint(&first[node], node, level_of(node));
  }

  std::size_t most_links(int level) const { return level == 0 ? graph->maxM0_ : graph->maxM_; }

  std::string bytes() const {
    std::string out(kGraphKind);
    GraphHeader header{built(), key(built()), built() > 0 ? graph->enterpoint_node_ : 0, 0};
    const std::size_t at = out.size();
    append(out, &header);
    for (std::size_t k = 0; k < built(); ++k) out.push_back(static_cast<char>(graph->element_levels_[k]));
    for (std::uint32_t k = 0; k < built(); ++k)
      for (int level = 0; level <= graph->element_levels_[k]; ++level) {
        std::uint32_t* list = graph->get_linklist_at_level(k, level);
        const auto count = static_cast<std::uint8_t>(graph->getListCount(list));
        append(out, &count);
        append(out, list + 1, count);
      }
    header.bytes = out.size() + kHashBytes;
    std::memcpy(out.data() + at, &header, sizeof header);
    const std::uint64_t hash = Fnv1aWords().add(out.data(), out.size()).value();
    append(out, &hash);
    return out;
  }

  /// Takes all numbers after the header; false if one of them cannot be.
  bool take(const GraphHeader& header, Reader reader) {
    std::vector<std::uint8_t> levels(header.nodes);
    if (!reader.read(levels.data(), levels.size())) return false;
    for (std::size_t k = 0; k < levels.size(); ++k)
      if (levels[k] != level_of(k)) return false;
    if (levels.empty() ? header.entry != 0
                       : header.entry >= levels.size() || levels[header.entry] != std::ranges::max(levels))
      return false;
    std::vector<std::uint32_t> links(most_links(0));
    for (std::uint32_t k = 0; k < levels.size(); ++k) {
      // In this order, so that the graph can be destroyed after each step.
      if (levels[k] > 0) {
        graph->linkLists_[k] = static_cast<char*>(std::calloc(levels[k], graph->size_links_per_element_));
        if (!graph->linkLists_[k]) throw std::bad_alloc();
      }
      graph->element_levels_[k] = levels[k];
      graph->cur_element_count = k + 1;
      std::memset(graph->get_linklist0(k), 0, graph->size_data_per_element_);
      std::memcpy(graph->getDataByInternalId(k), &first[k], sizeof first[k]);
      graph->setExternalLabel(k, k);
      for (int level = 0; level <= levels[k]; ++level) {
        std::uint8_t count;
        if (!reader.read(&count) || count > most_links(level) || !reader.read(links.data(), count)) return false;
        for (std::size_t i = 0; i < count; ++i)
          if (links[i] >= levels.size() || links[i] == k || levels[links[i]] < level) return false;
        std::uint32_t* list = graph->get_linklist_at_level(k, level);
        graph->setListCount(list, count);
        std::copy_n(links.begin(), count, list + 1);
      }
    }
    if (!reader.at_end()) return false;
    if (levels.empty()) return true;
    graph->enterpoint_node_ = static_cast<std::uint32_t>(header.entry);
    graph->maxlevel_ = levels[header.entry];
    return true;
  }
};

ApproximateSearch::ApproximateSearch(const NearestSearch& search, const std::vector<std::int64_t>& ids)
    : implementation_(std::make_unique<Implementation>(search, ids)) {}

ApproximateSearch::~ApproximateSearch() = default;

std::size_t ApproximateSearch::nodes() const { return implementation_->built(); }
bool ApproximateSearch::complete() const { return implementation_->built() == implementation_->first.size(); }
std::string ApproximateSearch::bytes() const { return implementation_->bytes(); }
void ApproximateSearch::save(const std::filesystem::path& file) const { write_whole_file(file, bytes()); }

bool ApproximateSearch::build(const LoopControl& control) {
  const std::size_t total = implementation_->first.size();
  for (std::size_t k = implementation_->built(); k < total; ++k) {
    if (control.stop.stop_requested()) return false;
    if (control.on_progress && k % 64 == 0) control.on_progress(k, total, "building the graph of neighbours");
    implementation_->add_node(k);
  }
  return true;
}

GraphFile ApproximateSearch::load(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) return GraphFile::kMissing;
  const std::string content = read_whole_file(file);
  const std::string_view bytes = content;
  const std::string_view kind = bytes.substr(0, kGraphKind.size());
  if (kind != kGraphKind.substr(0, kind.size()))
    throw std::runtime_error(file.string() + ": is no graph of neighbours, and is in the place of one");
  if (bytes.size() < kSmallest) return GraphFile::kDamaged;
  const std::string_view hashed = bytes.substr(0, bytes.size() - kHashBytes);
  std::uint64_t hash;
  GraphHeader header;
  Reader reader(hashed.substr(kGraphKind.size()));
  std::memcpy(&hash, bytes.data() + hashed.size(), sizeof hash);
  if (hash != Fnv1aWords().add(hashed.data(), hashed.size()).value() || !reader.read(&header) ||
      header.bytes != bytes.size())
    return GraphFile::kDamaged;
  if (header.nodes > implementation_->first.size() || header.key != implementation_->key(header.nodes))
    return GraphFile::kOther;
  implementation_->clear();
  if (implementation_->take(header, reader)) return GraphFile::kTaken;
  implementation_->clear();
  return GraphFile::kDamaged;
}

std::vector<Neighbour> ApproximateSearch::candidates(const Parts& query, std::size_t width,
                                                     const std::function<bool(std::size_t)>& keep) const {
  const Parts rough = implementation_->search.rough(query);
  const WalkQuery asked{kNobody, &query, &rough};
  std::vector<Neighbour> found;
  for (auto nodes = implementation_->graph->searchKnn(&asked, width); !nodes.empty(); nodes.pop())
    for (std::uint32_t i = implementation_->first[nodes.top().second]; i != kNobody; i = implementation_->next[i])
      if (!keep || keep(i)) found.push_back({i, static_cast<double>(nodes.top().first)});
  return found;
}

std::vector<Neighbour> ApproximateSearch::nearest_of(const Parts& query, std::vector<Neighbour> candidates,
                                                     std::size_t n) const {
  // Compared in full in the order of their bounds, as in the exact search.
  std::ranges::sort(candidates, nearer_by_walk);
  std::vector<Neighbour> best;
  for (const Neighbour& candidate : candidates) {
    if (best.size() == n && candidate.distance > best.back().distance * (1 + kFloatSlack)) break;
    const Neighbour exact{candidate.member, implementation_->search.distance(query, candidate.member)};
    best.insert(std::ranges::upper_bound(best, exact, nearer_by_walk), exact);
    if (best.size() > n) best.pop_back();
  }
  return best;
}

std::vector<Neighbour> ApproximateSearch::walk(const Parts& query, std::size_t n, std::size_t width) const {
  return n == 0 ? std::vector<Neighbour>() : nearest_of(query, candidates(query, std::max(width, n), {}), n);
}

std::vector<Neighbour> ApproximateSearch::nearest(const Parts& query, std::size_t n,
                                                  const std::function<bool(std::size_t)>& keep) const {
  if (!complete()) throw std::logic_error("the graph is not complete");
  if (n == 0) return {};
  // A filter leaves fewer of those that a walk finds, so wider walks follow until enough are left.
  for (std::size_t width = kWalkWidth; n < nodes(); width *= 4) {
    width = std::max(width, 3 * n);
    if (width * kWorthWalking >= nodes()) break;
    std::vector<Neighbour> found = candidates(query, width, keep);
    if (found.size() >= std::max(2 * n, kWalkWidth / 2)) return nearest_of(query, std::move(found), n);
  }
  return implementation_->search.nearest(query, n, keep);
}

std::vector<Neighbour> find_nearest(const NearestSearch& search, const ApproximateSearch* graph, const Parts& query,
                                    std::size_t n, const std::function<bool(std::size_t)>& keep, bool by_diffusion) {
  const std::size_t wanted = by_diffusion ? std::max(n, DiffusionOptions().pool) : n;
  std::vector<Neighbour> found = graph ? graph->nearest(query, wanted, keep) : search.nearest(query, wanted, keep);
  return by_diffusion ? diffused_pool(search, std::move(found), n) : found;
}

std::filesystem::path graph_file(const std::filesystem::path& database) {
  std::filesystem::path file = database;
  return file += "-graph";
}

std::unique_ptr<ApproximateSearch> open_approximate(const NearestSearch& search, std::span<const Member> members,
                                                    const std::filesystem::path& file, const LoopControl& control,
                                                    std::string& note) {
  std::vector<std::int64_t> ids;
  for (const Member& member : members) ids.push_back(member.id);
  return open_approximate(search, ids, file, control, note);
}

std::unique_ptr<ApproximateSearch> open_approximate(const NearestSearch& search, const std::vector<std::int64_t>& ids,
                                                    const std::filesystem::path& file, const LoopControl& control,
                                                    std::string& note) {
  auto graph = std::make_unique<ApproximateSearch>(search, ids);
  if (graph->load(file) == GraphFile::kDamaged) note = file.string() + ": is damaged; the graph is built anew";
  const std::size_t loaded = graph->nodes();
  const bool complete = graph->build(control);
  if (graph->nodes() > loaded) {
    try {
      graph->save(file);
    } catch (const std::runtime_error& e) {
      note = std::string(e.what()) + "; the graph has to be built again next time";
    }
  }
  if (!complete) throw Stopped();
  return graph;
}

}  // namespace rectilin::search
