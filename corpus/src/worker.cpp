#include "rectilin/corpus/worker.h"

#include <sys/resource.h>
#include <unistd.h>

#include <atomic>
#include <deque>
#include <fstream>
#include <new>

#include "channel.h"
#include "rectilin/corpus/claims.h"
#include "rectilin/measure/verify.h"
#include "rectilin/mesh/mesh_report.h"
#include "rectilin/mesh/source.h"

namespace rectilin::corpus {
namespace {

std::atomic<bool> memory_ran_out = false;

/// Bytes of data that the process uses now, those of its libraries included: a mesh is not charged for them.
std::uint64_t present_data() {
  std::ifstream file("/proc/self/statm");
  std::uint64_t size = 0, resident = 0, shared = 0, text = 0, library = 0, data = 0;
  file >> size >> resident >> shared >> text >> library >> data;
  return file ? data * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE)) : 0;
}

void limit_memory(std::uint64_t bytes) {
  const rlim_t limit = present_data() + bytes;
  const rlimit data{limit, limit};
  setrlimit(RLIMIT_DATA, &data);
  // The mesh readers report a lack of memory as an error of the file. This handler sees it first and tells the
  // two apart.
  std::set_new_handler([] {
    memory_ran_out = true;
    throw std::bad_alloc();
  });
}

class Worker {
 public:
  Worker(Channel& channel, Work work, std::optional<Claims> claims)
      : channel_(channel), work_(std::move(work)), claims_(std::move(claims)) {}

  void run() {
    for (;;) {
      if (!channel_.fill()) return;
      while (const auto message = channel_.next())
        if (!put_aside(*message)) return;
      if (waiting_.empty()) {
        const auto message = channel_.receive();
        if (!message || !put_aside(*message)) return;
        continue;
      }
      const Waiting next = std::move(waiting_.front());
      waiting_.pop_front();
      if (!(next.cancelled ? channel_.send(Kind::kSkipped, "") : do_mesh(next.job))) return;
    }
  }

 private:
  struct Waiting {
    MeshJob job;
    bool cancelled = false;
  };

  /// Keeps a mesh that comes while another is in work; returns false for a message that is about the one in work.
  bool put_aside(const Message& message) {
    if (message.kind == Kind::kMesh) waiting_.push_back({job_in(message.content)});
    // If no mesh waits, the one that is not wanted any more was begun.
    else if (message.kind == Kind::kCancel && !waiting_.empty()) waiting_.back().cancelled = true;
    return message.kind == Kind::kMesh || message.kind == Kind::kCancel;
  }

  /// Does one mesh; returns false if the worker should end.
  bool do_mesh(const MeshJob& job) {
    std::string error;
    memory_ran_out = false;
    try {
      read(job.mesh.source);
      Json about = {{"digest", digest_}, {"report", to_json(loaded_.report)}, {"left_out", summary(loaded_.report)}};
      if (claims_) {
        const bool is_new = claims_->claim(digest_, job.number);
        if (!channel_.send(is_new ? Kind::kRead : Kind::kAsk, to_text(about))) return false;
        if (!is_new) {
          auto answer = channel_.receive();
          while (answer && put_aside(*answer)) answer = channel_.receive();
          if (!answer) return false;
          if (answer->kind == Kind::kKnown) return true;
        }
        about = nullptr;
      }
      const WorkResult done = work_(job.mesh, loaded_);
      std::string answer =
          to_text(Json{{"result", done.result}, {"time_over", done.time_over}, {"read", std::move(about)}});
      if (!done.bytes.empty()) answer.append(1, '\0').append(done.bytes);
      return channel_.send(Kind::kResult, answer);
    } catch (const std::bad_alloc&) {
      memory_ran_out = true;
    } catch (const std::exception& e) {
      error = e.what();
    }
    if (memory_ran_out) {
      channel_.send(Kind::kNoMemory, "");
      return false;
    }
    return channel_.send(Kind::kError, error);
  }

  /// Reads the mesh unless it is the one of the last job, as when many jobs are about one mesh.
  void read(const std::string& source) {
    if (source == source_) return;
    source_.clear();
    loaded_ = {};  // two meshes at a time would count twice against the memory limit
    loaded_ = load_mesh(source);
    digest_ = mesh_digest(loaded_.mesh);
    source_ = source;
  }

  Channel& channel_;
  const Work work_;
  std::optional<Claims> claims_;
  std::deque<Waiting> waiting_;
  std::string source_, digest_;  ///< of the mesh that was read last
  LoadedMesh loaded_;
};

}  // namespace

int run_worker(int socket, const MakeWork& make_work) {
  Channel channel(socket);
  const auto setup = channel.receive();
  if (!setup || setup->kind != Kind::kSetup) return 2;
  const Json json = parse_json(setup->content);
  const auto seconds = json["seconds"].is_null() ? std::nullopt : std::optional(json["seconds"].get<double>());
  Worker worker(channel, make_work({json["task"], json["settings"]}, seconds),
                json["share"] == true ? std::optional(Claims::open(socket + 1)) : std::nullopt);
  if (!json["memory"].is_null()) limit_memory(json["memory"]);
  worker.run();
  return 0;
}

}  // namespace rectilin::corpus
