// A worker for the tests: its task's settings say which numbers of faces make it hang, be slow, crash or fill its
// memory.
#include <csignal>
#include <thread>
#include <vector>

#include "rectilin/corpus/worker.h"

using namespace rectilin;

namespace {

corpus::WorkResult work(const LoadedMesh& mesh, const Json& settings) {
  const std::size_t faces = mesh.mesh.triangles.size();
  const auto is = [&](const char* key) { return settings.value(key, std::size_t{0}) == faces; };
  if (is("hang"))
    for (;;) std::this_thread::sleep_for(std::chrono::seconds(1));
  if (is("crash")) std::raise(SIGSEGV);
  if (is("fill")) {
    std::vector<std::vector<char>> memory;
    while (memory.size() < 4096) memory.emplace_back(1 << 20, 'x');
  }
  if (is("fail")) throw MeshError("faces of an unlucky number");
  if (is("slow")) std::this_thread::sleep_for(std::chrono::seconds(2));
  if (const int pause = settings.value("pause", 0); pause > 0)
    std::this_thread::sleep_for(std::chrono::milliseconds(pause));
  double sum = 0;
  for (const Vector3& vertex : mesh.mesh.vertices) sum += vertex.norm();
  return {{{"faces", faces},
           {"area", sum},
           {"rectilinearity", 1 / (1 + sum)},
           {"lower", 0.0},
           {"upper", 1.0},
           {"rotation", {{sum, 0, 0}, {0, -1e-300, 0}, {0, 0, 0.1}}}},
          is("over")};
}

}  // namespace

int main() {
  return corpus::run_worker(3, [](const corpus::Task& task, std::optional<double>) -> corpus::Work {
    return [settings = task.settings](const NamedSource&, const LoadedMesh& mesh) { return work(mesh, settings); };
  });
}
