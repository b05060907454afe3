#include "rectilin/corpus/run_corpus.h"

#include <poll.h>

#include <chrono>
#include <map>
#include <memory>
#include <set>

#include "rectilin/base/version.h"
#include "worker_process.h"

namespace rectilin::corpus {
namespace {

using Clock = std::chrono::steady_clock;

/// How long to wait for a worker before it is killed. A search stops by itself after its `seconds`; reading a file, or
/// anything that hangs, does not.
double patience(double seconds) { return 1 + 1.1 * seconds; }

double unix_time() {
  return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

class Run {
 public:
  Run(std::vector<const NamedSource*> meshes, Store& store, const Task& task, const CorpusOptions& options,
      const LoopControl& control)
      : meshes_(std::move(meshes)), store_(store), task_(task), options_(options), control_(control) {}

  CorpusSummary run() {
    workers_.resize(std::min(meshes_.size(), static_cast<std::size_t>(std::max(1, options_.workers))));
    while (finished_ < meshes_.size() && !control_.stop.stop_requested()) {
      for (Worker& worker : workers_)
        if (!worker.busy && next_ < meshes_.size()) begin(worker);
      wait();
    }
    summary_.left = meshes_.size() - finished_;
    return summary_;
  }

 private:
  struct Worker {
    std::unique_ptr<WorkerProcess> process;
    bool busy = false, heard = false;  ///< heard: the worker has answered at least once
    bool again = false;                ///< the mesh is being tried a second time
    std::size_t mesh = 0;
    Row row;               ///< row of the mesh in work, filled in so far
    std::string left_out;  ///< what the mesh's reader left out
    Clock::time_point started;
  };

  void begin(Worker& worker) {
    worker.again = false;
    start(worker, next_++);
  }

  void start(Worker& worker, std::size_t index) {
    worker.mesh = index;
    const NamedSource& mesh = *meshes_[worker.mesh];
    worker.row = Row{};
    worker.left_out.clear();
    worker.row.name = mesh.name;
    worker.row.source = mesh.source;
    worker.row.group = mesh.group;
    worker.row.version = version();
    worker.busy = true;
    if (!worker.process) {
      worker.process = std::make_unique<WorkerProcess>(options_.worker_command);
      worker.heard = false;
      const Json setup = {{"task", task_.name},
                          {"settings", task_.settings},
                          {"seconds", options_.seconds ? Json(*options_.seconds) : Json(nullptr)},
                          {"memory", options_.memory ? Json(*options_.memory) : Json(nullptr)}};
      worker.process->channel().send(Kind::kSetup, to_text(setup));
    }
    worker.started = Clock::now();
    worker.process->channel().send(Kind::kMesh, mesh.source);  // if the worker is gone, wait() will notice
    if (control_.on_progress) control_.on_progress(finished_, meshes_.size(), mesh.name);
  }

  /// Waits until a worker has something to say or has been silent for too long.
  void wait() {
    std::vector<pollfd> sockets;
    std::vector<Worker*> who;
    double timeout = 0.2;  // seconds; short enough to notice a stop
    for (Worker& worker : workers_) {
      if (!worker.busy) continue;
      sockets.push_back({worker.process->channel().socket(), POLLIN, 0});
      who.push_back(&worker);
      if (options_.seconds) timeout = std::min(timeout, patience(*options_.seconds) - elapsed(worker));
    }
    poll(sockets.data(), sockets.size(), static_cast<int>(1000 * std::max(0.0, timeout)) + 1);
    for (std::size_t i = 0; i < who.size(); ++i) {
      Worker& worker = *who[i];
      const bool alive = sockets[i].revents == 0 || worker.process->channel().fill();
      while (worker.busy && worker.process) {
        const auto message = worker.process->channel().next();
        if (!message) break;
        worker.heard = true;
        take(worker, *message);
      }
      if (!worker.busy || !worker.process) continue;
      if (!alive) end_of(worker);
      else if (options_.seconds && elapsed(worker) > patience(*options_.seconds)) kill(worker);
    }
  }

  static double elapsed(const Worker& worker) {
    return std::chrono::duration<double>(Clock::now() - worker.started).count();
  }

  void take(Worker& worker, const Message& message) {
    switch (message.kind) {
      case Kind::kRead:
        return take_digest(worker, Json::parse(message.content));
      case Kind::kResult: {
        const Json json = Json::parse(message.content);
        worker.row.result = to_text(json["result"]);
        if (json["time_over"] == true) finish(worker, RowStatus::kLimited, limit_text("seconds"));
        else finish(worker, RowStatus::kDone, {});
        return;
      }
      case Kind::kError:
        return finish(worker, RowStatus::kFailed, error_about(worker.row.source, message.content));
      case Kind::kNoMemory:
        finish(worker, RowStatus::kLimited, limit_text("memory"));
        worker.process.reset();
        return;
      default:
        return;
    }
  }

  void take_digest(Worker& worker, const Json& json) {
    worker.row.digest = json["digest"];
    worker.row.report = to_text(json["report"]);
    worker.left_out = json["left_out"];
    Channel& channel = worker.process->channel();
    if (const auto same = store_.find_digest(worker.row.digest)) {
      channel.send(Kind::kKnown, "");
      worker.row.result = same->result;
      ++summary_.copied;
      finish(worker, RowStatus::kDone, {});
    } else if (!in_work_.insert(worker.row.digest).second) {
      channel.send(Kind::kKnown, "");  // another worker is doing the same mesh
      waiting_[worker.row.digest].emplace_back(std::move(worker.row), std::move(worker.left_out));
      worker.busy = false;
    } else {
      channel.send(Kind::kMeasure, "");
    }
  }

  /// Puts the mesh's row into the store, and the rows of equal meshes that arrived meanwhile.
  void finish(Worker& worker, RowStatus status, const std::string& error) {
    Row& row = worker.row;
    row.status = status;
    row.error = error;
    row.seconds = elapsed(worker);
    row.finished = unix_time();
    worker.busy = false;
    put(row, worker.left_out);
    if (row.digest.empty()) return;
    in_work_.erase(row.digest);
    const auto same = waiting_.find(row.digest);
    if (same == waiting_.end()) return;
    for (auto& [copy, left_out] : same->second) {
      copy.status = status;
      copy.error = error;
      copy.result = row.result;
      copy.finished = row.finished;
      summary_.copied += status == RowStatus::kDone;
      put(copy, left_out);
    }
    waiting_.erase(same);
  }

  void put(const Row& row, const std::string& left_out) {
    store_.put(row);
    if (options_.on_row) options_.on_row(row, left_out);
    ++finished_;
    (row.status == RowStatus::kDone     ? summary_.done
     : row.status == RowStatus::kFailed ? summary_.failed
                                        : summary_.limited)++;
    if (control_.on_progress) control_.on_progress(finished_, meshes_.size(), row.name);
  }

  void kill(Worker& worker) {
    worker.process.reset();
    finish(worker, RowStatus::kLimited, limit_text("seconds"));
  }

  void end_of(Worker& worker) {
    const std::string how = worker.process->wait_for_end();
    worker.process.reset();
    in_work_.erase(worker.row.digest);
    // It was killed from outside, by a person or by a system short of memory. A second try tells whether the mesh was
    // to blame.
    if (how.starts_with("signal 9,") && !worker.again) {
      worker.again = true;
      return start(worker, worker.mesh);
    }
    // A worker that ends before its first message would do so for every mesh: the mesh is not to blame.
    if (!worker.heard && how.starts_with("exit")) throw std::runtime_error("a worker process does not start: " + how);
    finish(worker, RowStatus::kLimited, worker.row.source + ": the program crashed (" + how + ")");
  }

  std::string limit_text(const std::string& limit) const {
    if (limit == "seconds" && !options_.seconds) return "its time ran out";
    if (limit == "seconds") return "more than " + Json(*options_.seconds).dump() + " seconds";
    if (!options_.memory) return "not enough memory";
    return "more than " + std::to_string(*options_.memory) + " bytes of memory";
  }

  const std::vector<const NamedSource*> meshes_;
  Store& store_;
  const Task& task_;
  const CorpusOptions& options_;
  const LoopControl& control_;
  std::vector<Worker> workers_;
  std::set<std::string> in_work_;  ///< digests of the meshes in work
  /// By digest: rows of meshes equal to one that is in work, with what was left out of them.
  std::map<std::string, std::vector<std::pair<Row, std::string>>> waiting_;
  std::size_t next_ = 0, finished_ = 0;
  CorpusSummary summary_;
};

}  // namespace

CorpusSummary run_corpus(std::span<const NamedSource> meshes, const Shard& shard, Store& store, const Task& task,
                         const CorpusOptions& options, const LoopControl& control) {
  std::vector<Store> done;
  for (const auto& file : options.done) {
    done.emplace_back(file);
    const Task other = done.back().task();
    if (other.name != task.name || other.settings != task.settings)
      throw ParameterError(file.string() + ": holds results of another task or other settings");
  }
  const auto is_done = [&](const std::string& name) {
    for (Store& other : done) {
      const auto row = other.find(name);
      if (row && (row->status == RowStatus::kDone || (row->status != RowStatus::kLeft && !options.retry))) return true;
    }
    return false;
  };
  std::vector<NamedSource> own;
  std::size_t elsewhere = 0;
  for (const NamedSource& mesh : meshes) {
    if (!shard.contains(mesh.name)) continue;
    if (is_done(mesh.name)) ++elsewhere;
    else own.push_back(mesh);
  }
  const std::vector<std::size_t> left = store.begin_run(own, shard, options.retry);
  std::vector<const NamedSource*> to_do;
  for (const std::size_t i : left) to_do.push_back(&own[i]);
  CorpusSummary summary = Run(std::move(to_do), store, task, options, control).run();
  summary.before = elsewhere + own.size() - left.size();
  store.end_run();
  return summary;
}

}  // namespace rectilin::corpus
