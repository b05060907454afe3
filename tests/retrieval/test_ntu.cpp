// The light field descriptor against what its authors' program computed.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "rectilin/mesh/source.h"
#include "rectilin/retrieval/descriptor.h"
#include "rectilin/retrieval/lfd_files.h"
#include "support/catch.h"

using namespace rectilin;
using namespace rectilin::retrieval;

namespace {

const std::vector<std::string> kModels{"m1050", "m1195", "m1371", "m1430", "m1544", "m1767",
                                       "m363",  "m457",  "m609",  "m712",  "m791",  "m93"};

std::size_t nearest_to(std::size_t i, const std::vector<Signature>& all, const Descriptor& descriptor) {
  std::size_t nearest = i == 0 ? 1 : 0;
  for (std::size_t k = 0; k < all.size(); ++k)
    if (k != i && descriptor.distance(all[i], all[k]) < descriptor.distance(all[i], all[nearest])) nearest = k;
  return nearest;
}

}  // namespace

TEST_CASE("Features and nearest models agree with the authors' program") {
  const char* data = std::getenv("RECTILIN_DATA");
  if (data == nullptr) {
    WARN("skipped: RECTILIN_DATA is not set");
    return;
  }
  const DescriptorPointer descriptor = make_descriptor("lfd:ntu");
  std::vector<Signature> ours, theirs;
  double sum = 0, count = 0;
  for (const std::string& model : kModels) {
    theirs.push_back(read_lfd_files(std::string(data) + "/lfd-ntu/" + model));
    REQUIRE(theirs.back().size() == descriptor->bytes());
    ours.push_back(descriptor->describe(Model(load_mesh(std::string(data) + "/psb/off/" + model + ".off").mesh)));
    for (std::size_t i = 0; i < ours.back().size(); ++i)
      sum += std::abs(double{static_cast<double>(ours.back()[i])} - static_cast<double>(theirs.back()[i]));
    count += static_cast<double>(ours.back().size());
  }
  // What is left comes from pixels: where a corner of a triangle falls between two places 1/256 pixel apart, and
  // whether a pixel counts whose centre is on an edge.
  CHECK(sum / count < 0.05);
  // Eleven of the twelve have the same nearest model. For the twelfth, m712, their own bytes put m1430 at 16813 and
  // m609 at 16816 of 147900, and a pixel here or there decides. So it is asked that our nearest model be theirs or, by
  // their bytes, no further than theirs but for a part in two thousand.
  std::size_t same = 0;
  for (std::size_t i = 0; i < kModels.size(); ++i) {
    INFO(kModels[i]);
    const std::size_t own = nearest_to(i, ours, *descriptor), nearest = nearest_to(i, theirs, *descriptor);
    same += own == nearest;
    CHECK(descriptor->distance(theirs[i], theirs[own]) <= 1.0005 * descriptor->distance(theirs[i], theirs[nearest]));
    for (std::size_t k = 0; k < kModels.size(); ++k)
      CHECK(descriptor->distance(ours[i], ours[k]) ==
            Approx(descriptor->distance(theirs[i], theirs[k])).epsilon(2e-3).margin(1e-12));
  }
  CHECK(same >= 11);
}

TEST_CASE("Signatures go to the program's four files and come back") {
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "rectilin-lfd-files";
  std::filesystem::create_directories(folder);
  Signature signature(4700);
  for (std::size_t i = 0; i < signature.size(); ++i) signature[i] = static_cast<std::uint8_t>(i * 37);
  write_lfd_files(folder / "m1", signature);
  CHECK(std::filesystem::file_size(folder / "m1.art") == 3500);
  CHECK(std::filesystem::file_size(folder / "m1.fd") == 1000);
  CHECK(std::filesystem::file_size(folder / "m1.cir") == 100);
  CHECK(std::filesystem::file_size(folder / "m1.ecc") == 100);
  CHECK(read_lfd_files(folder / "m1") == signature);
  CHECK_THROWS_AS(write_lfd_files(folder / "m2", SignatureView(signature).first(10)), std::invalid_argument);
  CHECK_THROWS_WITH(read_lfd_files(folder / "m2"), Catch::Contains("m2.art: cannot be read"));
  std::filesystem::resize_file(folder / "m1.cir", 99);
  CHECK_THROWS_WITH(read_lfd_files(folder / "m1"), Catch::Contains("m1.cir: has 99 bytes, not 100"));
  std::filesystem::remove_all(folder);
}
