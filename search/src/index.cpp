#include "rectilin/search/index.h"

#include <tbb/parallel_for.h>
#include <time.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "rectilin/base/printable.h"
#include "rectilin/mesh/edits.h"
#include "rectilin/mesh/source.h"
#include "rectilin/search/digest.h"

namespace rectilin::search {
namespace {

namespace fs = std::filesystem;

/// From the root, without dots; archives keep the name of their member.
std::string from_root(const std::string& source) {
  const std::string file = file_of(source);
  if (file.empty()) return source;
  return fs::absolute(file).lexically_normal().string() + source.substr(file.size());
}

/// Whether a source is `top` or in the folder or archive of that name.
bool is_within(const std::string& source, const std::string& top) {
  if (!source.starts_with(top)) return false;
  if (source.size() == top.size() || top.ends_with('/')) return true;
  return source[top.size()] == '/' || source.substr(top.size(), 2) == "::";
}

double seconds_of_thread() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// A file with what is known of it before it is read as a mesh.
struct Found {
  Member member;
  std::string error;  ///< why there is no digest
};

std::vector<Found> find_files(const std::vector<std::string>& sources) {
  std::vector<Found> found;
  std::set<std::string> seen;
  for (NamedSource& source : expand_sources(sources)) {
    Found f;
    f.member.name = std::move(source.name);
    f.member.source = from_root(source.source);
    if (seen.insert(f.member.source).second) found.push_back(std::move(f));
  }
  tbb::parallel_for(std::size_t{0}, found.size(), [&](std::size_t i) {
    try {
      found[i].member.digest = source_digest(found[i].member.source);
    } catch (const std::exception& e) {
      found[i].error = e.what();
    }
  });
  std::ranges::stable_sort(found, {}, [](const Found& f) -> const std::string& { return f.member.name; });
  for (std::size_t i = 1; i < found.size(); ++i)  // two lists may use one name
    if (found[i].member.name == found[i - 1].member.name) found[i].member.name = found[i].member.source;
  return found;
}

}  // namespace

std::vector<retrieval::DescriptorPointer> make_terms(const std::string& descriptor) {
  std::vector<retrieval::DescriptorPointer> terms;
  for (const retrieval::Term& term : retrieval::parse_composite(descriptor))
    terms.push_back(retrieval::descriptors().make(term.spec));
  return terms;
}

DescribedMesh describe_model(const retrieval::Model& model, const std::vector<retrieval::DescriptorPointer>& terms) {
  DescribedMesh described;
  for (const auto& term : terms) described.parts.push_back(term->describe(model));
  Member& m = described.member;
  m.status = MemberStatus::kDone;
  m.faces = model.mesh().triangles.size();
  m.rectilinearity = model.rectilinearity();
  m.size = largest_extent(model.mesh());
  return described;
}

DescribedMesh describe_source(const std::string& source, const std::vector<retrieval::DescriptorPointer>& terms) {
  const double begin = seconds_of_thread();
  DescribedMesh described = describe_model(retrieval::Model(load_mesh(source).mesh), terms);
  described.member.seconds = seconds_of_thread() - begin;
  return described;
}

IndexSummary update_index(Database& database, const std::vector<std::string>& sources, const LoopControl& control) {
  IndexSummary summary;
  std::vector<Found> found = find_files(sources);
  std::map<std::string, Member> by_source;
  std::set<std::string> names;
  for (Member& member : database.members()) {
    names.insert(member.name);
    by_source.emplace(member.source, std::move(member));
  }
  std::map<std::string, std::int64_t> by_digest;  // members whose rows stay as they are
  const auto stays = [&](const Member& member, const std::string& digest) {
    if (!digest.empty()) by_digest.emplace(digest, member.id);
  };

  // What is there, what moved, what is gone: all at once, so that a name is never taken twice.
  std::set<std::string> present;
  for (const Found& f : found) present.insert(f.member.source);
  std::vector<std::string> tops;
  for (const std::string& source : sources) tops.push_back(from_root(source));
  std::map<std::string, std::vector<Member>> gone_by_digest;
  std::map<std::int64_t, Member> gone;
  for (const auto& [source, member] : by_source) {
    const bool within = std::ranges::any_of(tops, [&](const std::string& top) { return is_within(source, top); });
    if (present.contains(source)) continue;
    // Outside of what is looked at, only a file that is not there any more can have moved into it.
    if (!within && (is_shape_source(source) || fs::exists(file_of(source)))) {
      if (member.status == MemberStatus::kDone) stays(member, member.digest);
      continue;
    }
    if (!member.digest.empty()) gone_by_digest[member.digest].push_back(member);
    if (within) gone.emplace(member.id, member);
  }
  std::vector<std::size_t> todo;
  database.begin();
  for (std::size_t i = 0; i < found.size(); ++i) {
    Member& own = found[i].member;
    const auto known = by_source.find(own.source);
    if (known != by_source.end()) {
      own.id = known->second.id;
      own.name = known->second.name;
      if (known->second.digest == own.digest && !own.digest.empty() && known->second.status != MemberStatus::kLeft) {
        if (known->second.status == MemberStatus::kFailed) summary.errors.push_back(known->second.error);
        if (known->second.status == MemberStatus::kDone) stays(own, own.digest);
        ++summary.unchanged;
        continue;
      }
      todo.push_back(i);
      continue;
    }
    const auto moved = gone_by_digest.find(own.digest);
    if (!own.digest.empty() && moved != gone_by_digest.end() && !moved->second.empty()) {
      const Member old = moved->second.back();
      moved->second.pop_back();
      own.id = old.id;
      gone.erase(old.id);
      if (old.status == MemberStatus::kDone) {
        names.erase(old.name);
        if (names.contains(own.name)) own.name = own.source;
        names.insert(own.name);
        database.rename(own);
        stays(own, own.digest);
        ++summary.moved;
        continue;
      }
    }
    if (names.contains(own.name)) own.name = own.source;
    names.insert(own.name);
    todo.push_back(i);
  }
  for (const auto& [id, member] : gone) {
    database.remove(id);
    ++summary.removed;
  }
  database.commit();

  const std::vector<retrieval::DescriptorPointer> terms = make_terms(database.descriptor());
  std::vector<std::string> texts;
  for (const std::size_t i : todo) texts.push_back(found[i].member.name);
  // Of files with the same bytes the first is described, and only if no member is.
  std::map<std::string, std::size_t> first;
  for (std::size_t k = 0; k < todo.size(); ++k)
    if (const std::string& digest = found[todo[k]].member.digest; !digest.empty()) first.emplace(digest, k);
  std::vector<char> is_copy(todo.size());
  for (std::size_t k = 0; k < todo.size(); ++k) {
    const std::string& digest = found[todo[k]].member.digest;
    is_copy[k] = !digest.empty() && (by_digest.contains(digest) || first.at(digest) != k);
  }
  const auto work = [&](std::size_t k) {
    const Found& f = found[todo[k]];
    if (!f.error.empty()) throw std::runtime_error(f.error);
    if (is_copy[k]) return DescribedMesh();
    return describe_source(f.member.source, terms);
  };
  const auto deliver = [&](std::size_t k, Outcome<DescribedMesh>&& outcome) {
    Member member = found[todo[k]].member;
    const bool known = member.id != 0;
    Parts parts;
    std::string error = printable(outcome.error);
    if (outcome.value && is_copy[k]) {  // the first of its kind is in the database, done or failed
      Member copy = *database.find_id(by_digest.at(member.digest));
      parts = database.signature(copy.id);
      copy.id = member.id;
      copy.name = member.name;
      copy.source = member.source;
      member = std::move(copy);
      if (member.status == MemberStatus::kFailed) error = member.error;
      if (error.empty()) ++summary.copied;
    } else if (outcome.value) {
      Member& made = outcome.value->member;
      made.id = member.id;
      made.name = member.name;
      made.source = member.source;
      made.digest = member.digest;
      member = std::move(made);
      parts = std::move(outcome.value->parts);
    }
    if (!error.empty()) {
      member.status = MemberStatus::kFailed;
      member.error = error;
      summary.errors.push_back(error);
    } else if (!is_copy[k]) {
      ++(known ? summary.changed : summary.added);
    }
    const std::int64_t id = database.put(member, parts.empty() ? nullptr : &parts);
    if (!member.digest.empty()) by_digest.emplace(member.digest, id);
  };
  summary.complete = for_each_in_order<DescribedMesh>(texts, work, deliver, control) == texts.size();
  return summary;
}

}  // namespace rectilin::search
