#include "rectilin/serve/serve.h"

#include <unistd.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <new>
#include <thread>

#include "api.h"
#include "child/tasks.h"
#include "http/listen.h"
#include "http/server.h"
#include "rectilin/base/printable.h"

namespace rectilin::serve {
namespace {

/// Work on a member or an upload: more than any mesh of a common collection takes.
constexpr ChildLimits kChildLimits{};

HttpLimits limits_for(const ServeOptions& options) {
  HttpLimits limits;
  limits.body_bytes = options.upload_bytes;
  limits.bodies_bytes = 2 * options.upload_bytes;
  limits.workers = std::clamp<std::size_t>(std::thread::hardware_concurrency(), 2, 8);
  return limits;
}

}  // namespace

void serve(const ServeOptions& options, const std::function<void(const Started&)>& started, std::stop_token stop) {
  Collection collection{search::Database(options.database)};
  std::string note;
  if (options.approximate)
    note = collection.use_graph(search::graph_file(options.database), {stop, options.on_progress});
  PageFiles page = load_page_files();
  const bool viewer = page.viewer;
  MeshWork work(options.worker_command, kChildLimits);
  Api api(collection, std::move(page), work,
          {std::filesystem::path(options.database).filename().string(), options.hosts, options.upload_bytes});
  HttpServer server(options.address, options.port, limits_for(options), api);
  started({"http://" + with_port(options.address, server.port()) + "/", collection.size(), viewer, note});
  for (int steps = 0; !stop.stop_requested(); ++steps) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    if (steps % 20 == 0) server.sweep();
  }
  work.stop();
}

int run_mesh_worker() {
  limit_this_process(kChildLimits);
  Json answer;
  try {
    const std::string input{std::istreambuf_iterator<char>(std::cin), {}};
    answer = do_task(Json::from_cbor(input));
  } catch (const std::bad_alloc&) {
    answer = Json{{"error", "takes too much memory"}};
  } catch (const std::exception& e) {
    answer = Json{{"error", printable(e.what())}};
  }
  std::string output;
  Json::to_cbor(answer, nlohmann::detail::output_adapter<char>(output));
  std::cout.write(output.data(), static_cast<std::streamsize>(output.size()));
  return std::cout.flush() ? 0 : 1;
}

}  // namespace rectilin::serve
