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

/// Does one mesh; returns false if the worker should end.
bool do_mesh(Channel& channel, const std::string& source, const Work& work) {
  std::string error;
  memory_ran_out = false;
  try {
    const LoadedMesh loaded = load_mesh(source);
    const Json read = {
        {"digest", mesh_digest(loaded.mesh)}, {"report", to_json(loaded.report)}, {"left_out", summary(loaded.report)}};
    if (!channel.send(Kind::kRead, to_text(read))) return false;
    const auto answer = channel.receive();
    if (!answer) return false;
    if (answer->kind == Kind::kKnown) return true;
    const WorkResult done = work(loaded);
    return channel.send(Kind::kResult, to_text(Json{{"result", done.result}, {"time_over", done.time_over}}));
  } catch (const std::bad_alloc&) {
    memory_ran_out = true;
  } catch (const std::exception& e) {
    error = e.what();
  }
  if (memory_ran_out) {
    channel.send(Kind::kNoMemory, "");
    return false;
  }
  return channel.send(Kind::kError, error);
}

}  // namespace

int run_worker(int socket, const MakeWork& make_work) {
  Channel channel(socket);
  const auto setup = channel.receive();
  if (!setup || setup->kind != Kind::kSetup) return 2;
  const Json json = Json::parse(setup->content);
  const auto seconds = json["seconds"].is_null() ? std::nullopt : std::optional(json["seconds"].get<double>());
  const Work work = make_work({json["task"], json["settings"]}, seconds);
  if (!json["memory"].is_null()) limit_memory(json["memory"]);
  while (const auto message = channel.receive()) {
    if (message->kind != Kind::kMesh || !do_mesh(channel, message->content, work)) break;
  }
  return 0;
}

}  // namespace rectilin::corpus
