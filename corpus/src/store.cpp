#include "rectilin/corpus/store.h"

#include <sys/vfs.h>
#include <unistd.h>

#include <chrono>
#include <map>

#include "rectilin/base/printable.h"
#include "rectilin/base/system_reason.h"
#include "rectilin/base/version.h"
#include "rectilin/base/whole_file.h"
#include "rectilin/corpus/file_kind.h"
#include "rectilin/corpus/writer_lock.h"
#include "store_access.h"

namespace rectilin::corpus {
namespace {

namespace fs = std::filesystem;

constexpr const char* kTables = R"(
CREATE TABLE meshes(
  name TEXT PRIMARY KEY NOT NULL, source TEXT NOT NULL, class TEXT NOT NULL, status INTEGER NOT NULL, digest TEXT,
  faces INTEGER, area REAL, rectilinearity REAL, lower REAL, upper REAL,
  result TEXT, report TEXT, error TEXT, version TEXT, finished REAL, seconds REAL);
CREATE INDEX digests ON meshes(digest) WHERE status = 3;
CREATE TABLE facts(key TEXT PRIMARY KEY NOT NULL, value TEXT NOT NULL) WITHOUT ROWID;
CREATE TABLE runs(
  id INTEGER PRIMARY KEY, shard TEXT NOT NULL, host TEXT NOT NULL, process INTEGER NOT NULL, version TEXT NOT NULL,
  started REAL NOT NULL, ended REAL);
)";

constexpr FileKind kStore = {0x7265637, 1, kTables, "a store of results"};

double now() { return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count(); }

std::string host_name() {
  char name[256] = "";
  return gethostname(name, sizeof name - 1) == 0 ? name : "?";
}

/// Is the file on a disk of this machine? SQLite's write-ahead log needs memory shared by all who use the file, which
/// different machines do not have. Elsewhere the older rollback journal is used, which costs a few milliseconds a row.
bool is_local(const fs::path& file) {
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  struct statfs about {};
  if (statfs(folder.c_str(), &about) != 0) return true;
  switch (static_cast<std::uint32_t>(about.f_type)) {
    case 0x6969:      // NFS
    case 0x517B:      // SMB
    case 0xFF534D42:  // CIFS
    case 0xFE534D42:  // SMB2
    case 0x0BD00BD0:  // Lustre
    case 0x47504653:  // GPFS
    case 0x19830326:  // BeeGFS
    case 0x00C36400:  // Ceph
    case 0x65735546:  // FUSE
    case 0x01021997:  // 9P
    case 0xAAD7AAEA:  // PanFS
      return false;
    default:
      return true;
  }
}

/// A number of a result that has a column of its own; nothing if the result lacks it.
std::optional<double> number(const Json& result, const char* key) {
  const auto found = result.find(key);
  return found != result.end() && found->is_number() ? std::optional(found->get<double>()) : std::nullopt;
}

std::optional<std::string_view> unless_empty(const std::string& text) {
  return text.empty() ? std::nullopt : std::optional<std::string_view>(text);
}

}  // namespace

const char* to_string(RowStatus status) {
  switch (status) {
    case RowStatus::kLeft:
      return "left";
    case RowStatus::kDone:
      return "done";
    case RowStatus::kFailed:
      return "failed";
    case RowStatus::kLimited:
      return "limited";
  }
  return "";
}

std::string difference(const Task& found, const Task& wanted) {
  if (found.name != wanted.name) return "'" + found.name + "', not of '" + wanted.name + "'";
  Json theirs = Json::object(), ours = Json::object();
  for (const auto& [key, value] : found.settings.items())
    if (!wanted.settings.contains(key) || wanted.settings[key] != value) theirs[key] = value;
  for (const auto& [key, value] : wanted.settings.items())
    if (!found.settings.contains(key) || found.settings[key] != value) ours[key] = value;
  constexpr std::size_t kShown = 120;
  return "'" + found.name + "' with " + shortened(to_text(theirs), kShown) + ", not with " +
         shortened(to_text(ours), kShown);
}

Row read_row(const Statement& s) {
  Row row;
  row.name = s.text(0);
  row.source = s.text(1);
  row.group = s.text(2);
  row.status = static_cast<RowStatus>(s.integer(3));
  row.digest = s.text(4);
  row.result = s.text(5);
  row.report = s.text(6);
  row.error = s.text(7);
  row.version = s.text(8);
  row.finished = s.is_null(9) ? 0 : s.real(9);
  row.seconds = s.is_null(10) ? 0 : s.real(10);
  return row;
}

struct Store::Implementation {
  Implementation(const fs::path& path, Database::Mode mode)
      : lock(mode == Database::Mode::kWrite ? std::make_unique<WriterLock>(path) : nullptr), database(path, mode) {}

  std::unique_ptr<WriterLock> lock;
  Database database;
  std::optional<Statement> put, find_digest, find;
  std::int64_t run = 0;
};

Store::Store(const fs::path& file, const Task& task)
    : implementation_(std::make_unique<Implementation>(file, Database::Mode::kWrite)) {
  Database& database = implementation_->database;
  if (!is_empty(database)) check_kind(database, kStore);  // before anything is changed
  // Each commit is handed to the operating system at once, so that it survives the end of the program, but does not
  // wait for the disk.
  database.execute(is_local(file) ? "PRAGMA journal_mode = WAL; PRAGMA synchronous = NORMAL"
                                  : "PRAGMA journal_mode = TRUNCATE; PRAGMA synchronous = NORMAL");
  database.execute("PRAGMA cache_size = -65536");
  make_tables(database, kStore, {{"task", task.name}, {"settings", to_text(task.settings)}});
  const Task found = this->task();
  if (found != task) throw ParameterError(file.string() + ": the store holds results of " + difference(found, task));
}

Store::Store(const fs::path& file) {
  if (std::error_code error = why_unreadable(file))
    throw std::runtime_error(file.string() + ": " + system_reason(error));
  implementation_ = std::make_unique<Implementation>(file, Database::Mode::kRead);
  check_kind(implementation_->database, kStore);
}

Store::~Store() = default;
Store::Store(Store&&) noexcept = default;

bool is_store(const fs::path& file) { return is_of_kind(file, kStore); }

Database& StoreAccess::database(Store& store) { return store.implementation_->database; }

Task Store::task() const {
  Database& database = implementation_->database;
  return {fact(database, "task"), parse_json(fact(database, "settings"))};
}

std::vector<std::size_t> Store::begin_run(std::span<const NamedSource> meshes, const Shard& shard, bool retry) {
  Database& database = implementation_->database;
  Transaction transaction(database);
  database.execute("DELETE FROM meshes WHERE status = 0");
  Statement insert(database, "INSERT OR IGNORE INTO meshes(name, source, class, status) VALUES(?1, ?2, ?3, 0)");
  Statement look(database, "SELECT status, source FROM meshes WHERE name = ?1");
  Statement again(database, "UPDATE meshes SET status = 0, error = NULL WHERE name = ?1 AND status IN (1, 2)");
  std::map<std::string_view, std::string_view> source_of;
  std::vector<std::size_t> left;
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    const NamedSource& mesh = meshes[i];
    const auto [known, is_new] = source_of.try_emplace(mesh.name, mesh.source);
    if (!is_new && known->second != mesh.source)
      throw ParameterError("two meshes have the name '" + mesh.name + "': " + std::string(known->second) + " and " +
                           mesh.source);
    if (!is_new) continue;
    insert.bind(1, std::string_view(mesh.name))
        .bind(2, std::string_view(mesh.source))
        .bind(3, std::string_view(mesh.group))
        .run();
    if (retry) again.bind(1, std::string_view(mesh.name)).run();
    look.bind(1, std::string_view(mesh.name)).step();
    if (look.integer(0) == static_cast<std::int64_t>(RowStatus::kLeft)) left.push_back(i);
    look.reset();
  }
  Statement run(database, "INSERT INTO runs(shard, host, process, version, started) VALUES(?1, ?2, ?3, ?4, ?5)");
  const std::string part = shard.to_string(), host = host_name(), program = version();
  run.bind(1, std::string_view(part)).bind(2, std::string_view(host)).bind(3, static_cast<std::int64_t>(getpid()));
  run.bind(4, std::string_view(program)).bind(5, now()).run();
  Statement last(database, "SELECT max(id) FROM runs");
  last.step();
  implementation_->run = last.integer(0);
  last.reset();
  transaction.commit();
  return left;
}

void Store::end_run() {
  Statement end(implementation_->database, "UPDATE runs SET ended = ?1 WHERE id = ?2");
  end.bind(1, now()).bind(2, implementation_->run).run();
}

void Store::put(const Row& row) {
  if (!implementation_->put)
    implementation_->put.emplace(implementation_->database,
                                 "INSERT OR REPLACE INTO meshes(name, source, class, status, digest, faces, area, "
                                 "rectilinearity, lower, upper, result, report, error, version, finished, seconds) "
                                 "VALUES(?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8, ?9, ?10, ?11, ?12, ?13, ?14, ?15, ?16)");
  Statement& s = *implementation_->put;
  s.bind(1, std::string_view(row.name)).bind(2, std::string_view(row.source)).bind(3, std::string_view(row.group));
  s.bind(4, static_cast<std::int64_t>(row.status)).bind(5, unless_empty(row.digest));
  if (!row.result.empty()) {
    const Json result = parse_json(row.result);
    if (const auto faces = number(result, "faces")) s.bind(6, static_cast<std::int64_t>(*faces));
    s.bind(7, number(result, "area")).bind(8, number(result, "rectilinearity"));
    s.bind(9, number(result, "lower")).bind(10, number(result, "upper"));
  }
  s.bind(11, unless_empty(row.result)).bind(12, unless_empty(row.report)).bind(13, unless_empty(row.error));
  s.bind(14, unless_empty(row.version)).bind(15, row.finished).bind(16, row.seconds).run();
}

std::vector<std::string> Store::digests() {
  Statement all(implementation_->database, "SELECT digest FROM meshes WHERE status = 3");
  std::vector<std::string> digests;
  while (all.step()) digests.emplace_back(all.text(0));
  return digests;
}

std::optional<Row> Store::find_digest(std::string_view digest) {
  if (!implementation_->find_digest)
    implementation_->find_digest.emplace(
        implementation_->database,
        std::string("SELECT ") + kRowColumns + " FROM meshes WHERE digest = ?1 AND status = 3");
  Statement& s = *implementation_->find_digest;
  if (!s.bind(1, digest).step()) return std::nullopt;
  Row row = read_row(s);
  s.reset();
  return row;
}

std::optional<Row> Store::find(std::string_view name) {
  if (!implementation_->find)
    implementation_->find.emplace(implementation_->database,
                                  std::string("SELECT ") + kRowColumns + " FROM meshes WHERE name = ?1");
  Statement& s = *implementation_->find;
  if (!s.bind(1, name).step()) return std::nullopt;
  Row row = read_row(s);
  s.reset();
  return row;
}

void Store::for_each(const std::function<void(const Row&)>& take) {
  Statement all(implementation_->database, std::string("SELECT ") + kRowColumns + " FROM meshes ORDER BY name");
  while (all.step()) take(read_row(all));
}

std::size_t Store::size() {
  Statement count(implementation_->database, "SELECT count(*) FROM meshes");
  count.step();
  return static_cast<std::size_t>(count.integer(0));
}

}  // namespace rectilin::corpus
