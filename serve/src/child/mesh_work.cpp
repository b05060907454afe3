#include "child/mesh_work.h"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "child/tasks.h"
#include "rectilin/base/parameters.h"
#include "rectilin/base/printable.h"
#include "rectilin/mesh/mesh_io.h"

namespace rectilin::serve {
namespace {

namespace fs = std::filesystem;

/// A new folder that only this user can enter, gone when this object is.
class PrivateFolder {
 public:
  PrivateFolder() {
    std::string name = (fs::temp_directory_path() / "rectilin-serve-XXXXXX").string();
    if (!mkdtemp(name.data())) throw ShapeError("no folder can be made for uploads");
    path_ = name;
  }
  ~PrivateFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  PrivateFolder(const PrivateFolder&) = delete;
  PrivateFolder& operator=(const PrivateFolder&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

/// A file name of ours that keeps the part of theirs that readers look at.
std::string plain_name(const std::string& theirs) {
  fs::path name = fs::path(theirs).filename();
  std::string packed;
  if (name.extension() == ".gz") {
    packed = ".gz";
    name = name.stem();
  }
  return "upload" + (format_of_extension(name) ? name.extension().string() : std::string(".mesh")) + packed;
}

/// Messages name the file by the name that its owner knows.
std::string renamed(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

Json answer_of(const std::string& name, const std::vector<std::string>& command, const Json& task,
               const ChildLimits& limits, const std::atomic<bool>& stopped) {
  std::string input;
  Json::to_cbor(task, nlohmann::detail::output_adapter<char>(input));
  Json answer;
  try {
    answer = Json::from_cbor(run_child(command, input, limits, [&] { return stopped.load(); }));
  } catch (const ChildError& e) {
    throw ShapeError(name + ": " + e.what());
  } catch (const Json::exception&) {
    throw ShapeError(name + ": could not be worked on");
  }
  if (answer.contains("error")) throw ShapeError(answer["error"].get<std::string>());
  return answer;
}

std::string bytes_of(const Json& value) {
  const auto& bytes = value.get_binary();
  return {bytes.begin(), bytes.end()};
}

}  // namespace

std::string MeshWork::of_member(const char* task, const search::Member& member) const {
  const Json request{{"task", task}, {"source", as_bytes(member.source)}, {"digest", member.digest}};
  const std::string name = printable(member.name);
  try {
    return bytes_of(answer_of(name, command_, request, limits_, stopped_)["bytes"]);
  } catch (const ShapeError& e) {
    throw ShapeError(renamed(e.what(), printable(member.source), name));
  }
}

Upload MeshWork::describe(const std::string& name, const std::string& content, const std::string& descriptor) const {
  const PrivateFolder folder;
  const std::string own = plain_name(name), shown = printable(fs::path(name).filename().string());
  {
    std::ofstream file(folder.path() / own, std::ios::binary);
    file.write(content.data(), static_cast<std::streamsize>(content.size()));
    if (!file.flush()) throw ShapeError(shown + ": no room to keep it");
  }
  const Json request{
      {"task", "describe"}, {"folder", folder.path().string()}, {"source", as_bytes(own)}, {"descriptor", descriptor}};
  try {
    const Json answer = answer_of(shown, command_, request, limits_, stopped_);
    Upload upload;
    upload.member.name = shown;
    upload.member.status = search::MemberStatus::kDone;
    upload.member.faces = answer["faces"];
    upload.member.rectilinearity = answer["rectilinearity"];
    upload.member.size = answer["size"];
    upload.left_out = renamed(answer["left_out"], own, shown);
    for (const Json& part : answer["parts"]) upload.parts.push_back(part.get_binary());
    upload.picture = bytes_of(answer["picture"]);
    upload.mesh = bytes_of(answer["mesh"]);
    return upload;
  } catch (const ShapeError& e) {
    throw ShapeError(renamed(e.what(), own, shown));
  }
}

Turn MeshWork::turn(const std::string& first, const std::string& second) const {
  const Json request{{"task", "turn"}, {"first", as_bytes(first)}, {"second", as_bytes(second)}};
  const Json answer = answer_of("the two shapes", command_, request, limits_, stopped_);
  return {answer["rotation"].get<std::array<double, 9>>(), answer["distance"]};
}

}  // namespace rectilin::serve
