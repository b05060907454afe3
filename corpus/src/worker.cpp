#include "rectilin/corpus/worker.h"

#include <sys/resource.h>
#include <unistd.h>

#include <atomic>
#include <fstream>
#include <new>

#include "channel.h"
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
  Worker(Channel& channel, Work work, bool ask) : channel_(channel), work_(std::move(work)), ask_(ask) {}

  /// Does one mesh; returns false if the worker should end.
  bool do_mesh(const NamedSource& job) {
    std::string error;
    memory_ran_out = false;
    try {
      read(job.source);
      Json about = {{"digest", digest_}, {"report", to_json(loaded_.report)}, {"left_out", summary(loaded_.report)}};
      if (ask_) {
        if (!channel_.send(Kind::kRead, to_text(about))) return false;
        auto answer = channel_.receive();
        while (answer && answer->kind == Kind::kCancel) answer = channel_.receive();  // too late: it was begun
        if (!answer) return false;
        if (answer->kind == Kind::kKnown) return true;
        about = nullptr;
      }
      const WorkResult done = work_(job, loaded_);
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

 private:
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
  const bool ask_;
  std::string source_, digest_;
  LoadedMesh loaded_;
};

}  // namespace

int run_worker(int socket, const MakeWork& make_work) {
  Channel channel(socket);
  const auto setup = channel.receive();
  if (!setup || setup->kind != Kind::kSetup) return 2;
  const Json json = Json::parse(setup->content);
  const auto seconds = json["seconds"].is_null() ? std::nullopt : std::optional(json["seconds"].get<double>());
  Worker worker(channel, make_work({json["task"], json["settings"]}, seconds), json["ask"]);
  if (!json["memory"].is_null()) limit_memory(json["memory"]);
  while (const auto message = channel.receive()) {
    if (message->kind == Kind::kCancel) continue;  // it came after its mesh was done
    if (message->kind != Kind::kMesh) break;
    if (!(channel.take(Kind::kCancel) ? channel.send(Kind::kSkipped, "") : worker.do_mesh(mesh_in(message->content))))
      break;
  }
  return 0;
}

}  // namespace rectilin::corpus
