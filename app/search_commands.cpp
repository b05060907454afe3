// rectilin index and search: describes a collection in a database, and finds what in it is most like a mesh.
#include <fnmatch.h>

#include <cmath>
#include <iostream>
#include <memory>

#include "commands.h"
#include "corpus_run.h"
#include "options.h"
#include "rectilin/base/whole_file.h"
#include "rectilin/mesh/mesh_io.h"
#include "rectilin/search/approximate.h"
#include "rectilin/search/describe.h"
#include "rectilin/search/index.h"
#include "rectilin/search/nearest.h"
#include "rectilin/search/page.h"
#include "terminal.h"

namespace rectilin::app {
namespace {

struct IndexOptions {
  std::vector<std::string> sources;
  std::string out, descriptor;
  int threads = 0;
  std::optional<double> seconds;
  CorpusArguments corpus;
};

int index_folders(const IndexOptions& options) {
  search::IndexOptions how;
  how.shard = corpus::Shard::parse(options.corpus.shard);
  how.retry = options.corpus.retry;
  how.done.assign(options.corpus.done.begin(), options.corpus.done.end());
  how.workers = worker_options(options.corpus, options.seconds, options.threads);
  search::Database database(options.out, options.descriptor);
  search::IndexSummary summary;
  {
    std::unique_ptr<Progress> progress;
    const auto begin = std::chrono::steady_clock::now();
    summary = search::update_index(
        database, options.sources,
        {stop_on_interrupt(),
         [&](std::size_t done, std::size_t total, const std::string& text) {
           if (!progress) progress = std::make_unique<Progress>(total);
           const double spent = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
           const double left = done > 0 ? spent / static_cast<double>(done) * static_cast<double>(total - done) : NAN;
           progress->show(done, time_left(left) + text);
         }},
        how);
  }
  for (const std::string& error : summary.errors) complain(error);
  std::cout << options.out << ": " << summary.added << " added, " << summary.changed << " changed, " << summary.moved
            << " moved, " << summary.copied << " copies, " << summary.removed << " removed, " << summary.unchanged
            << " unchanged, " << summary.errors.size() << " failed";
  if (!how.done.empty()) std::cout << ", " << summary.elsewhere << " in other databases";
  std::cout << '\n';
  if (!summary.complete) complain("stopped; nothing finished is lost: the same command goes on from here");
  return summary.complete && summary.errors.empty() ? 0 : 1;
}

struct Filter {
  double least_r = -INFINITY, largest_r = INFINITY, least_size = 0, largest_size = INFINITY;
  std::string name;

  bool operator()(const search::Member& m) const {
    return m.rectilinearity >= least_r && m.rectilinearity <= largest_r && m.size >= least_size &&
           m.size <= largest_size && (name.empty() || fnmatch(name.c_str(), m.name.c_str(), 0) == 0);
  }
};

struct SearchOptions {
  std::string database, page;
  std::vector<std::string> queries, like;
  std::size_t count = 20;
  bool json = false, collection = false, approximate = false;
  Filter filter;
  int threads = 0;
};

/// A database read into memory.
struct Loaded {
  explicit Loaded(search::Database& database) : search(database.descriptor()) {
    search.reserve(database.described());
    database.for_each_signature([this](search::Member&& member, search::Parts&& parts) {
      search.add(parts);
      members.push_back(std::move(member));
    });
  }
  std::vector<search::Member> members;
  search::NearestSearch search;
};

/// The graph of --approximate, from the file beside the database or built now.
std::unique_ptr<search::ApproximateSearch> graph_of(const Loaded& loaded, const std::string& database) {
  std::unique_ptr<Progress> progress;
  std::string note;
  auto graph = search::open_approximate(loaded.search, loaded.members, search::graph_file(database),
                                        {stop_on_interrupt(),
                                         [&](std::size_t done, std::size_t total, const std::string& text) {
                                           if (!progress) progress = std::make_unique<Progress>(total);
                                           progress->show(done, text);
                                         }},
                                        note);
  progress.reset();
  if (!note.empty()) complain(note);
  return graph;
}

/// Why a member has no signature.
std::string why_without(const search::Member& member) {
  return member.status == search::MemberStatus::kLeft ? "it is still to be described" : member.error;
}

struct Query {
  std::string name, source;
  search::Parts parts;
  std::optional<std::size_t> member;  ///< set if the query is itself a member
};

void print_query(const Query& query, const std::vector<search::Neighbour>& found, const Loaded& loaded, bool json) {
  if (json) {
    Json results = Json::array();
    for (std::size_t k = 0; k < found.size(); ++k)
      results.push_back(
          {{"name", loaded.members[found[k].member].name}, {"distance", found[k].distance}, {"rank", k + 1}});
    std::cout << to_text({{"query", query.name}, {"results", results}}) << '\n';
    return;
  }
  std::cout << printable(query.name) << '\n';
  std::vector<std::string> names{"name"};
  for (const search::Neighbour& n : found) names.push_back(loaded.members[n.member].name);
  const Table table({{"name", widest(names)}, {"distance", 9}, {"R", 6}, {"faces", 8}});
  std::cout << table.header() << '\n';
  for (const search::Neighbour& n : found) {
    const search::Member& m = loaded.members[n.member];
    std::cout << table.row({m.name, fixed(n.distance, 4), fixed(m.rectilinearity, 3), std::to_string(m.faces)}) << '\n';
  }
}

int search_database(const SearchOptions& options) {
  if (options.queries.empty() && options.like.empty())
    throw ParameterError("nothing to search for: give a mesh, or a member with --like");
  const auto limit = limit_threads(options.threads);
  search::Database database(options.database);
  const Loaded loaded(database);
  std::unique_ptr<search::ApproximateSearch> graph;
  if (options.approximate) {
    try {
      graph = graph_of(loaded, options.database);
    } catch (const Stopped&) {
      complain("stopped; what was built of the graph is kept: the same command goes on from here");
      return 1;
    }
  }
  const auto terms = search::make_terms(database.descriptor());
  bool failed = false;
  std::vector<Query> queries;
  for (const std::string& name : options.like) {
    const auto found = std::ranges::find(loaded.members, name, &search::Member::name);
    if (found == loaded.members.end()) {
      const auto row = database.find(name);
      complain(options.database + ": no member '" + name + "'" +
               (row ? " with a signature: " + why_without(*row) : ""));
      failed = true;
      continue;
    }
    const auto i = static_cast<std::size_t>(found - loaded.members.begin());
    queries.push_back({name, found->source, loaded.search.parts_of(i), i});
  }
  const std::vector<std::string> sources = expand_folders(options.queries);
  for_each_in_order<search::DescribedMesh>(
      sources, [&](std::size_t i) { return search::describe_source(sources[i], terms); },
      [&](std::size_t i, Outcome<search::DescribedMesh>&& outcome) {
        if (outcome.value) {
          queries.push_back({sources[i], sources[i], std::move(outcome.value->parts), std::nullopt});
        } else {
          complain(outcome.error);
          failed = true;
        }
      });
  std::vector<search::PageSection> sections;
  for (const Query& query : queries) {
    const auto keep = [&](std::size_t i) {
      return (!query.member || *query.member != i) && options.filter(loaded.members[i]);
    };
    const std::vector<search::Neighbour> found =
        search::find_nearest(loaded.search, graph.get(), query.parts, options.count, keep, options.collection);
    if (!options.json && &query != &queries.front()) std::cout << '\n';
    print_query(query, found, loaded, options.json);
    if (options.page.empty()) continue;
    search::PageSection section{query.name, {{query.name, query.source, "query"}}};
    for (const search::Neighbour& n : found)
      section.pictures.push_back(
          {loaded.members[n.member].name, loaded.members[n.member].source, fixed(n.distance, 4)});
    sections.push_back(std::move(section));
  }
  if (!options.page.empty() && !sections.empty())
    write_whole_file(options.page,
                     search::picture_page("Shapes alike",
                                          "Of " + std::to_string(loaded.members.size()) + " shapes in " +
                                              options.database + " those nearest to each query, and how far they are.",
                                          sections));
  return failed ? 1 : 0;
}

void add_index(CLI::App& app, int& status) {
  auto options = std::make_shared<IndexOptions>();
  CLI::App* command = app.add_subcommand("index", "Describe the shapes of folders in a database to search");
  command->add_option("source", options->sources, "Folders, mesh files, archives or lists of them")->required();
  command->add_option("-o,-O,--out", options->out, "Database; made if it does not exist")->required();
  command->add_option("-d,--descriptor", options->descriptor,
                      "What shapes are compared by, as 'rectilin evaluate' takes it; fixed when the database is made "
                      "(default: best)");
  add_threads_option(*command, options->threads, "signatures are the same for any");
  add_corpus_options(*command, options->corpus, "", "");
  add_seconds_option(*command, options->seconds);
  command->footer(
      "Files that are in the database and have the same bytes are not read again; moved files are recognised by them,\n"
      "and members of the given folders that are gone are removed. After Ctrl-C or any other end the same command "
      "goes\n"
      "on. Files that fail are rows that say why; they cost the exit status (1). Databases of shards are put together "
      "by\n"
      "'rectilin merge'.\n"
      "Examples: rectilin index parts/ -o parts.db; rectilin search parts.db bracket.stl\n"
      "          rectilin index abc.zip -o abc-3.db --shard 3/16 --seconds 60 --memory 4G");
  command->callback([options, &status] { status = index_folders(*options); });
}

void add_search(CLI::App& app, int& status) {
  auto options = std::make_shared<SearchOptions>();
  CLI::App* command = app.add_subcommand("search", "Find the shapes of a database that are most like a mesh");
  command->add_option("database", options->database, "Database, made by 'rectilin index'")->required();
  command->add_option("query", options->queries, "Mesh files, or folders of them");
  command->add_option("-l,--like", options->like, "A member of the database, by its name; may be repeated")
      ->allow_extra_args(false);
  command->add_option("-n,--count", options->count, "Shapes to find for each query")
      ->check(count())
      ->capture_default_str();
  command->add_flag("-j,--json", options->json, "A JSON object a line for each query");
  command->add_flag("--collection", options->collection,
                    "Rank by diffusion through the collection: what is between two shapes makes them alike");
  command->add_flag("--approximate", options->approximate,
                    "Look at some hundreds of members instead of all, by a graph in DATABASE-graph, built when needed: "
                    "for millions of shapes or many queries");
  command->add_option("--page", options->page, "Write what was found with pictures, as a web page");
  command->add_option("--min-r", options->filter.least_r, "Only shapes of at least this rectilinearity");
  command->add_option("--max-r", options->filter.largest_r, "Only shapes of at most this rectilinearity");
  command->add_option("--min-size", options->filter.least_size, "Only shapes whose longest side is at least this");
  command->add_option("--max-size", options->filter.largest_size, "Only shapes whose longest side is at most this");
  command->add_option("--name", options->filter.name, "Only shapes whose name matches this pattern (* and ?)");
  add_threads_option(*command, options->threads, "the results are the same for any");
  command->footer(
      "The result is exact: the same as if the query were compared with every member, unless --approximate allows "
      "that\n"
      "some of the nearest are missed. The exact search takes 0.3 s of a million shapes, less time than reading them; "
      "the\ngraph takes about ten minutes to build for a million and pays for hundreds of queries at once or "
      "'rectilin serve'.\n"
      "Distances are comparable within one database only. With --json: {\"query\": NAME, \"results\": [{\"distance\": "
      "..., \"name\": ..., \"rank\": "
      "1}, "
      "...]}\n"
      "Examples: rectilin search parts.db bracket.stl -n 5 --page found.html\n"
      "          rectilin search parts.db --like parts/old/bracket.stl --json");
  command->callback([options, &status] { status = search_database(*options); });
}

}  // namespace

void add_search_commands(CLI::App& app, int& status) {
  add_index(app, status);
  add_search(app, status);
}

}  // namespace rectilin::app
