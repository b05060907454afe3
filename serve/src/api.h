// What the server answers: the page's files, and what they ask for. papers/search.md describes it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "child/mesh_work.h"
#include "http/message.h"
#include "page_files.h"
#include "shapes/cache.h"
#include "shapes/collection.h"

namespace rectilin::serve {

class Api : public Service {
 public:
  struct Options {
    std::string title;  ///< of the collection
    std::vector<std::string> hosts;
    std::uint64_t upload_bytes;
  };
  Api(const Collection& collection, PageFiles page, MeshWork& work, Options options);

  std::optional<Response> refuse(const Request& request) override;
  Response answer(const Request& request) override;

 private:
  /// A shape that can be searched for: a member or what somebody sent.
  struct Shape {
    std::string id;
    std::optional<std::size_t> member;
    std::shared_ptr<const Upload> upload;
  };
  Shape shape(const std::string& id);
  const search::Member& about(const Shape& shape) const;
  Json to_json(const Shape& shape) const;
  Shape member_shape(std::size_t i) const;

  Response route(const Request& request);
  Response page_file(const Request& request) const;
  Response collection() const;
  Response shapes(const Request& request) const;
  Response search(const Request& request);
  Response upload(const Request& request);
  Response matches(const Request& request);
  Response picture(const Request& request);
  Response mesh(const Request& request);
  Response turn(const Request& request);

  std::vector<search::Neighbour> neighbours(const Shape& query, const Request& request) const;
  Response found(const Shape& query, const Request& request) const;
  Bytes mesh_of(const Shape& shape);

  const Collection& collection_;
  PageFiles page_;
  MeshWork& work_;
  Options options_;
  Cache<Bytes> pictures_, meshes_;
  Cache<std::shared_ptr<const Upload>> uploads_;
};

}  // namespace rectilin::serve
