#include "rectilin/corpus/worker_pool.h"

#include <poll.h>

#include <algorithm>
#include <chrono>
#include <deque>
#include <memory>

#include "worker_process.h"

namespace rectilin::corpus {
namespace {

using Clock = std::chrono::steady_clock;

/// How long to wait for a worker before it is killed. A search stops by itself after its `seconds`; reading a file, or
/// anything that hangs, does not.
double patience(double seconds) { return 1 + 1.1 * seconds; }

class WorkerPool {
 public:
  WorkerPool(std::span<const NamedSource> jobs, const Task& task, const WorkerOptions& options, const Claims* claims,
             JobHandler& handler, const LoopControl& control)
      : jobs_(jobs), task_(task), options_(options), claims_(claims), handler_(handler), control_(control) {}

  void run() {
    workers_.resize(std::min(jobs_.size(), static_cast<std::size_t>(std::max(1, options_.workers))));
    while (over_ < jobs_.size() && !control_.stop.stop_requested()) {
      // A worker that has its next job before it has done the last need not wait for it.
      for (std::size_t depth = 1; depth <= kDepth; ++depth)
        for (Worker& worker : workers_)
          if (worker.jobs.size() < depth && next_ < jobs_.size()) give(worker, {next_++});
      for (Worker& worker : workers_)
        if (worker.jobs.empty()) take_over(worker);
      wait();
    }
  }

 private:
  static constexpr std::size_t kDepth = 2;

  struct Job {
    std::size_t index;
    bool again = false;      ///< it is tried a second time
    bool cancelled = false;  ///< another worker has taken it over: what becomes of it here does not count
  };
  struct Worker {
    std::unique_ptr<WorkerProcess> process;
    int processes = 0;          ///< how many it has had
    bool heard = false;         ///< the process has answered at least once
    std::deque<Job> jobs;       ///< the first is in work; the second waits in the worker's socket
    Clock::time_point started;  ///< the first job
  };

  void give(Worker& worker, Job job) {
    worker.jobs.push_back(job);
    if (worker.jobs.size() == 1) worker.started = Clock::now();
    if (!worker.process) {
      worker.process = std::make_unique<WorkerProcess>(options_.worker_command, claims_ ? claims_->file() : -1);
      ++worker.processes;
      worker.heard = false;
      const Json setup = {{"task", task_.name},
                          {"settings", task_.settings},
                          {"seconds", options_.seconds ? Json(*options_.seconds) : Json(nullptr)},
                          {"memory", options_.memory ? Json(*options_.memory) : Json(nullptr)},
                          {"share", claims_ != nullptr}};
      worker.process->channel().send(Kind::kSetup, to_text(setup));
    }
    const NamedSource& mesh = jobs_[job.index];
    // If the worker is gone, wait() will notice.
    worker.process->channel().send(Kind::kMesh, job_message(job.index, mesh));
    if (control_.on_progress) control_.on_progress(over_, jobs_.size(), mesh.name);
  }

  /// Gives an idle worker, when there are no new jobs, the one that waits behind the longest job of another.
  void take_over(Worker& idle) {
    Worker* slowest = nullptr;
    for (Worker& worker : workers_)
      if (worker.jobs.size() == kDepth && !worker.jobs.back().cancelled &&
          (!slowest || worker.started < slowest->started))
        slowest = &worker;
    if (!slowest) return;
    slowest->process->channel().send(Kind::kCancel, "");
    const Job job = slowest->jobs.back();
    slowest->jobs.back().cancelled = true;
    give(idle, job);
  }

  /// Waits until a worker has something to say or has been silent for too long.
  void wait() {
    std::vector<pollfd> sockets;
    std::vector<Worker*> who;
    double timeout = 0.2;  // seconds; short enough to notice a stop
    for (Worker& worker : workers_) {
      if (worker.jobs.empty()) continue;
      sockets.push_back({worker.process->channel().socket(), POLLIN, 0});
      who.push_back(&worker);
      if (options_.seconds) timeout = std::min(timeout, patience(*options_.seconds) - elapsed(worker));
    }
    poll(sockets.data(), sockets.size(), static_cast<int>(1000 * std::max(0.0, timeout)) + 1);
    for (std::size_t i = 0; i < who.size(); ++i) {
      Worker& worker = *who[i];
      const bool alive = sockets[i].revents == 0 || worker.process->channel().fill();
      const int process = worker.processes;
      const auto has_job = [&] { return worker.process && worker.processes == process && !worker.jobs.empty(); };
      while (has_job()) {
        const auto message = worker.process->channel().next();
        if (!message) break;
        worker.heard = true;
        take(worker, *message);
      }
      if (!has_job()) continue;
      if (!alive) end_of(worker);
      else if (options_.seconds && elapsed(worker) > patience(*options_.seconds)) kill(worker);
    }
  }

  static double elapsed(const Worker& worker) {
    return std::chrono::duration<double>(Clock::now() - worker.started).count();
  }

  void take(Worker& worker, const Message& message) {
    const Job job = worker.jobs.front();
    switch (message.kind) {
      case Kind::kRead:
        if (!job.cancelled) handler_.read(job.index, parse_json(message.content));
        return;
      case Kind::kAsk:
        if (!job.cancelled && handler_.is_wanted(job.index, parse_json(message.content))) {
          worker.process->channel().send(Kind::kGoOn, "");
        } else {
          worker.process->channel().send(Kind::kKnown, "");
          pop(worker);
        }
        return;
      case Kind::kResult: {
        const std::size_t text = message.content.find('\0');
        Json json = parse_json(message.content.substr(0, text));
        if (!claims_ && !job.cancelled) handler_.read(job.index, json["read"]);
        const bool over = json["time_over"] == true;
        return finish(worker, {over ? RowStatus::kLimited : RowStatus::kDone, std::move(json["result"]),
                               text == std::string::npos ? std::string() : message.content.substr(text + 1),
                               over ? limit_text("seconds") : std::string()});
      }
      case Kind::kError:
        return finish(worker, {RowStatus::kFailed, nullptr, {}, error_about(jobs_[job.index].source, message.content)});
      case Kind::kNoMemory:
        worker.process.reset();
        return finish(worker, {RowStatus::kLimited, nullptr, {}, limit_text("memory")});
      case Kind::kSkipped:
        return pop(worker);
      default:
        return;
    }
  }

  void finish(Worker& worker, Answer&& answer) {
    const Job job = worker.jobs.front();
    answer.seconds = elapsed(worker);
    if (!job.cancelled) handler_.finish(job.index, std::move(answer));
    pop(worker);
  }

  /// The first job of a worker is over; the second begins, in a new process if this one is gone.
  void pop(Worker& worker) {
    const Job job = worker.jobs.front();
    worker.jobs.pop_front();
    worker.started = Clock::now();
    if (!job.cancelled) {
      ++over_;
      if (control_.on_progress) control_.on_progress(over_, jobs_.size(), jobs_[job.index].name);
    }
    if (!worker.process) hand_again(worker);
  }

  /// Sends the jobs of a worker whose process is gone to a new one.
  void hand_again(Worker& worker) {
    const std::deque<Job> jobs = std::move(worker.jobs);
    worker.jobs.clear();
    for (const Job& job : jobs)
      if (!job.cancelled) give(worker, job);
  }

  void kill(Worker& worker) {
    worker.process.reset();
    finish(worker, {RowStatus::kLimited, nullptr, {}, limit_text("seconds")});
  }

  void end_of(Worker& worker) {
    const std::string how = worker.process->wait_for_end();
    worker.process.reset();
    Job& job = worker.jobs.front();
    // It was killed from outside, by a person or by a system short of memory. A second try tells whether the mesh was
    // to blame.
    if (how.starts_with("signal 9,") && !job.again) {
      job.again = true;
      return hand_again(worker);
    }
    // A worker that ends before its first message would do so for every mesh: the mesh is not to blame.
    if (!worker.heard && how.starts_with("exit")) throw std::runtime_error("a worker process does not start: " + how);
    finish(worker, {RowStatus::kLimited, nullptr, {}, jobs_[job.index].source + ": the program crashed (" + how + ")"});
  }

  std::string limit_text(const std::string& limit) const {
    if (limit == "seconds" && !options_.seconds) return "its time ran out";
    if (limit == "seconds") return "more than " + to_text(*options_.seconds) + " seconds";
    if (!options_.memory) return "not enough memory";
    return "more than " + std::to_string(*options_.memory) + " bytes of memory";
  }

  const std::span<const NamedSource> jobs_;
  const Task& task_;
  const WorkerOptions& options_;
  const Claims* const claims_;
  JobHandler& handler_;
  const LoopControl& control_;
  std::vector<Worker> workers_;
  std::size_t next_ = 0, over_ = 0;
};

}  // namespace

void run_jobs(std::span<const NamedSource> jobs, const Task& task, const WorkerOptions& options, const Claims* claims,
              JobHandler& handler, const LoopControl& control) {
  WorkerPool(jobs, task, options, claims, handler, control).run();
}

}  // namespace rectilin::corpus
