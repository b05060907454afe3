#include "api.h"

#include <charconv>
#include <chrono>
#include <filesystem>

#include "answers.h"
#include "http/guard.h"
#include "rectilin/base/printable.h"
#include "rectilin/report/csv.h"

namespace rectilin::serve {
namespace {

constexpr std::size_t kPictureRoom = 64u << 20, kMeshRoom = 128u << 20, kUploadRoom = 256u << 20;
constexpr std::uint64_t kMostResults = 1000;
constexpr const char* kForGood = "private, max-age=31536000, immutable";

Response with_guards(Response response) {
  for (const auto& header : guarding_headers()) response.headers.push_back(header);
  return response;
}

std::size_t bytes_of(const Upload& upload) {
  std::size_t bytes = upload.picture.size() + upload.mesh.size();
  for (const auto& part : upload.parts) bytes += part.size();
  return bytes;
}

}  // namespace

Api::Api(const Collection& collection, PageFiles page, MeshWork& work, Options options)
    : collection_(collection),
      page_(std::move(page)),
      work_(work),
      options_(std::move(options)),
      pictures_(kPictureRoom),
      meshes_(kMeshRoom),
      uploads_(kUploadRoom) {}

std::optional<Response> Api::refuse(const Request& request) {
  const auto refusal = [&]() -> std::optional<Response> {
    if (auto refused = refused_by_guard(request, options_.hosts)) return refused;
    const bool reads = request.method == "GET" || request.method == "HEAD";
    const bool sends = request.method == "POST" && request.path == "/api/search";
    if (!reads && !sends) {
      Response response = error_response(405, "only GET, and POST to /api/search");
      response.headers.emplace_back("Allow", "GET, HEAD");
      return response;
    }
    if (sends && request.length == 0) return error_response(400, "the file is empty");
    if (!sends && request.length > 0) return error_response(400, "a body where none belongs");
    return std::nullopt;
  }();
  return refusal ? std::optional(with_guards(*refusal)) : std::nullopt;
}

Response Api::answer(const Request& request) {
  try {
    return with_guards(route(request));
  } catch (const Refusal& e) {
    return with_guards(error_response(e.status(), e.what()));
  } catch (const ShapeError& e) {
    return with_guards(error_response(422, e.what()));
  }
}

Response Api::route(const Request& r) {
  if (r.method == "POST") return upload(r);
  if (r.path == "/api/collection") return collection();
  if (r.path == "/api/shapes") return shapes(r);
  if (r.path == "/api/search") return search(r);
  if (r.path == "/api/matches") return matches(r);
  if (r.path == "/api/picture") return picture(r);
  if (r.path == "/api/mesh") return mesh(r);
  if (r.path == "/api/turn") return turn(r);
  return page_file(r);
}

Response Api::page_file(const Request& request) const {
  const auto found = page_.files.find(request.path);
  if (found == page_.files.end()) throw Refusal(404, "there is nothing of that name");
  const PageFile& file = found->second;
  Response response{200, file.type, file.bytes, {{"ETag", file.tag}, {"Cache-Control", "no-cache"}}};
  if (request.header("if-none-match") == file.tag) response.status = 304, response.body = nullptr;
  return response;
}

Api::Shape Api::member_shape(std::size_t i) const { return {std::to_string(collection_.member(i).id), i, nullptr}; }

Api::Shape Api::shape(const std::string& id) {
  if (id.starts_with('u')) {
    const auto upload = uploads_.get(id);
    if (!upload) throw Refusal(404, "the uploaded file is not kept any more; send it again");
    return {id, std::nullopt, *upload};
  }
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(id.data(), id.data() + id.size(), number);
  const auto member = error == std::errc() && end == id.data() + id.size() ? collection_.find(number) : std::nullopt;
  if (!member) throw Refusal(404, "there is no shape of that id");
  return member_shape(*member);
}

const search::Member& Api::about(const Shape& shape) const {
  return shape.member ? collection_.member(*shape.member) : shape.upload->member;
}

Json Api::to_json(const Shape& shape) const {
  const search::Member& m = about(shape);
  Json json{{"id", shape.id}, {"name", printable(m.name)}, {"faces", m.faces}, {"rectilinearity", m.rectilinearity},
            {"size", m.size}, {"version", m.digest}};
  if (shape.upload && !shape.upload->left_out.empty()) json["note"] = shape.upload->left_out;
  return json;
}

Response Api::collection() const {
  return json_response({{"title", printable(options_.title)},
                        {"descriptor", collection_.descriptor()},
                        {"shapes", collection_.size()},
                        {"failed", collection_.failed()},
                        {"viewer", page_.viewer},
                        {"upload_bytes", options_.upload_bytes}});
}

Response Api::shapes(const Request& request) const {
  const std::uint64_t from = number_argument(request, "from", 0, 0, 1u << 30);
  const std::uint64_t count = number_argument(request, "count", 48, 1, kMostResults);
  const Page page = collection_.page(request.argument("name").value_or(""), from, count);
  Json list = Json::array();
  for (const std::size_t i : page.members) list.push_back(to_json(member_shape(i)));
  return json_response({{"total", page.total}, {"from", from}, {"shapes", std::move(list)}});
}

std::vector<search::Neighbour> Api::neighbours(const Shape& query, const Request& request) const {
  const std::uint64_t count = number_argument(request, "count", 24, 1, kMostResults);
  const bool by_diffusion = number_argument(request, "collection", 0, 0, 1) == 1;
  return collection_.nearest(query.member ? collection_.parts_of(*query.member) : query.upload->parts, count,
                             request.argument("name").value_or(""), query.member, by_diffusion);
}

Response Api::found(const Shape& query, const Request& request) const {
  const auto begin = std::chrono::steady_clock::now();
  const std::vector<search::Neighbour> found = neighbours(query, request);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  Json results = Json::array();
  for (std::size_t k = 0; k < found.size(); ++k) {
    Json result = to_json(member_shape(found[k].member));
    result["rank"] = k + 1;
    result["distance"] = found[k].distance;
    results.push_back(std::move(result));
  }
  return json_response({{"query", to_json(query)}, {"seconds", seconds}, {"results", std::move(results)}});
}

Response Api::search(const Request& request) { return found(shape(needed_argument(request, "id")), request); }

Response Api::upload(const Request& request) {
  const std::string name = needed_argument(request, "file");
  auto upload = std::make_shared<const Upload>(work_.describe(name, request.body, collection_.descriptor()));
  if (!collection_.fits(upload->parts)) throw Refusal(500, "the file could not be described");
  const Shape query{"u" + random_name(), std::nullopt, upload};
  uploads_.put(query.id, upload, bytes_of(*upload));
  return found(query, request);
}

Response Api::matches(const Request& request) {
  const Shape query = shape(needed_argument(request, "id"));
  const std::string format = request.argument("format").value_or("json");
  if (format != "json" && format != "csv") throw Refusal(400, "format is json or csv");
  const std::vector<search::Neighbour> found = neighbours(query, request);
  Response response{200, "", nullptr, {{"Content-Disposition", "attachment; filename=\"matches." + format + "\""}}};
  if (format == "csv") {
    report::Csv csv({"query", "rank", "distance", "name"});
    for (std::size_t k = 0; k < found.size(); ++k)
      csv.row({about(query).name, k + 1, found[k].distance, collection_.member(found[k].member).name});
    response.type = "text/csv; charset=utf-8";
    response.body = to_bytes(csv.text());
  } else {
    Json results = Json::array();
    for (std::size_t k = 0; k < found.size(); ++k)
      results.push_back(
          {{"name", collection_.member(found[k].member).name}, {"distance", found[k].distance}, {"rank", k + 1}});
    response.type = "application/json";
    response.body = to_bytes(to_text({{"query", about(query).name}, {"results", std::move(results)}}) + "\n");
  }
  return response;
}

Response Api::picture(const Request& request) {
  const Shape s = shape(needed_argument(request, "id"));
  Bytes bytes;
  if (s.upload) {
    bytes = to_bytes(s.upload->picture);
  } else if (const auto kept = pictures_.get(s.id)) {
    bytes = *kept;
  } else {
    bytes = to_bytes(work_.picture(about(s)));
    pictures_.put(s.id, bytes, bytes->size());
  }
  return {200, "image/png", bytes, {{"Cache-Control", kForGood}}};
}

Bytes Api::mesh_of(const Shape& s) {
  if (s.upload) return to_bytes(s.upload->mesh);
  if (const auto kept = meshes_.get(s.id)) return *kept;
  const Bytes bytes = to_bytes(work_.mesh(about(s)));
  meshes_.put(s.id, bytes, bytes->size());
  return bytes;
}

Response Api::mesh(const Request& request) {
  return {
      200, "application/octet-stream", mesh_of(shape(needed_argument(request, "id"))), {{"Cache-Control", "no-store"}}};
}

Response Api::turn(const Request& request) {
  const Shape query = shape(needed_argument(request, "query")), result = shape(needed_argument(request, "result"));
  const Turn turn = work_.turn(*mesh_of(query), *mesh_of(result));
  return json_response({{"rotation", turn.rotation}, {"distance", turn.distance}});
}

}  // namespace rectilin::serve
