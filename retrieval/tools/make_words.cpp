// Learns the code book of local features from a folder of meshes, without labels, and writes it as data/words.bin.
//
//     rectilin_make_words FOLDER FILE.cla words.bin [DUMP]
//
// The same bytes for any number of threads. With DUMP, everything that descriptors are weighted by is written there.
#include <tbb/parallel_for.h>

#include <Eigen/Dense>
#include <Eigen/Eigenvalues>
#include <cstring>
#include <iostream>

#include "features/code_book.h"
#include "features/frame_views.h"
#include "features/rich_view.h"
#include "rectilin/base/random.h"
#include "rectilin/base/whole_file.h"
#include "rectilin/mesh/source.h"
#include "rectilin/retrieval/collection.h"
#include "rectilin/retrieval/descriptor.h"

namespace {

using namespace rectilin;
using namespace rectilin::retrieval;
using Matrix = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

constexpr int kWords = 64, kDims = 32, kNumbers = 96;
constexpr std::size_t kSamples = 400;  // local features of a model
constexpr std::size_t kEvery = 5;      // of the models one in so many lends its local features
constexpr Turn kTurn = Turn::kQuarter;

/// All local features of a model, or of its views' every so many.
void visit_model(const Mesh& mesh, const std::function<void(const LocalFeature&)>& take) {
  visit_frame_views(mesh, render::ViewSphere(1),
                    [&](std::size_t, const render::DepthImage& image) { visit_local_features(image, kTurn, take); });
}

/// Main components of rows that have been centred: as rows, the largest first.
Matrix main_components(const Eigen::MatrixXd& covariance, int count, std::vector<double>* variances = nullptr) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(covariance);
  Matrix rows(count, covariance.rows());
  for (int k = 0; k < count; ++k) {
    rows.row(k) = solver.eigenvectors().col(covariance.rows() - 1 - k).transpose().cast<float>();
    if (variances) variances->push_back(solver.eigenvalues()(covariance.rows() - 1 - k));
  }
  return rows;
}

std::vector<Mesh> posed_meshes(const Collection& collection) {
  std::vector<Mesh> meshes(collection.files.size());
  tbb::parallel_for(std::size_t{0}, meshes.size(), [&](std::size_t i) {
    const Model model(load_mesh(collection.files[i]).mesh);
    meshes[i] = model.posed("rectilinear");
  });
  return meshes;
}

Matrix sampled_features(const std::vector<Mesh>& meshes) {
  const std::size_t models = (meshes.size() + kEvery - 1) / kEvery;
  std::vector<std::vector<LocalFeature>> samples(models);
  tbb::parallel_for(std::size_t{0}, models, [&](std::size_t m) {
    Random random(m + 1);
    std::vector<LocalFeature>& own = samples[m];
    std::size_t seen = 0;
    visit_model(meshes[m * kEvery], [&](const LocalFeature& f) {  // a reservoir: each as likely as any other
      ++seen;
      if (own.size() < kSamples) {
        own.push_back(f);
      } else if (const auto at = static_cast<std::size_t>(random.uniform() * static_cast<double>(seen));
                 at < kSamples) {
        own[at] = f;
      }
    });
  });
  std::size_t count = 0;
  for (const auto& own : samples) count += own.size();
  Matrix all(static_cast<Eigen::Index>(count), kLocal);
  Eigen::Index row = 0;
  for (const auto& own : samples)
    for (const LocalFeature& f : own) all.row(row++) = Eigen::Map<const Eigen::RowVectorXf>(f.data(), kLocal);
  return all;
}

/// Lloyd's algorithm from words drawn at random.
Matrix clustered(const Matrix& points, int words) {
  Random random(7);
  Matrix centres(words, points.cols());
  for (int w = 0; w < words; ++w)
    centres.row(w) = points.row(static_cast<Eigen::Index>(random.uniform() * static_cast<double>(points.rows())));
  std::vector<int> nearest(static_cast<std::size_t>(points.rows()));
  for (int round = 0; round < 25; ++round) {
    const Eigen::VectorXf norms = centres.rowwise().squaredNorm();
    tbb::parallel_for(Eigen::Index{0}, points.rows(), [&](Eigen::Index i) {
      int best;
      (norms - 2 * centres * points.row(i).transpose()).minCoeff(&best);
      nearest[static_cast<std::size_t>(i)] = best;
    });
    Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(words, points.cols());
    Eigen::VectorXd counts = Eigen::VectorXd::Zero(words);
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
      sums.row(nearest[static_cast<std::size_t>(i)]) += points.row(i).cast<double>();
      counts(nearest[static_cast<std::size_t>(i)]) += 1;
    }
    for (int w = 0; w < words; ++w)
      if (counts(w) > 0) centres.row(w) = (sums.row(w) / counts(w)).cast<float>();
  }
  return centres;
}

void copy(const Matrix& from, std::vector<float>& to) { to.assign(from.data(), from.data() + from.size()); }

void learn(CodeBook& book, const std::vector<Mesh>& meshes) {
  Matrix samples = sampled_features(meshes);
  std::cerr << samples.rows() << " local features\n";
  const Eigen::RowVectorXf mean = samples.cast<double>().colwise().mean().cast<float>();
  samples.rowwise() -= mean;
  const Eigen::MatrixXd covariance =
      samples.cast<double>().transpose() * samples.cast<double>() / static_cast<double>(samples.rows());
  const Matrix components = main_components(covariance, kDims);
  const Matrix points = samples * components.transpose();
  book.words = kWords;
  book.dims = kDims;
  book.mean.assign(mean.data(), mean.data() + mean.size());
  copy(components, book.components);
  copy(clustered(points, kWords), book.centres);
}

/// The main components of all models' residuals, by the products between models, for these are fewer.
void learn_numbers(CodeBook& book, const Matrix& residuals) {
  const Eigen::RowVectorXf offset = residuals.cast<double>().colwise().mean().cast<float>();
  const Eigen::MatrixXd centred = (residuals.rowwise() - offset).cast<double>();
  std::vector<double> variances;
  const Matrix main = main_components(centred * centred.transpose(), kNumbers, &variances);
  book.numbers = kNumbers;
  book.offset.assign(offset.data(), offset.data() + offset.size());
  const double power = 0.25;  // of variances that numbers are divided by: half way to equal variances would be 0.25
  for (int k = 0; k < kNumbers; ++k) {
    Eigen::VectorXd row = centred.transpose() * main.row(k).transpose().cast<double>();
    row /= row.norm() * std::pow(variances[static_cast<std::size_t>(k)] / variances[0], power);
    const double largest = row.cwiseAbs().maxCoeff();
    book.scale.push_back(static_cast<float>(largest / 127));
    for (Eigen::Index i = 0; i < row.size(); ++i)
      book.rows.push_back(static_cast<std::int8_t>(std::lround(row(i) / largest * 127)));
  }
}

void put(std::string& bytes, const void* data, std::size_t size) { bytes.append(static_cast<const char*>(data), size); }

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4 && argc != 5) {
    std::cerr << "usage: rectilin_make_words FOLDER FILE.cla words.bin [DUMP]\n";
    return 2;
  }
  try {
    const Collection collection = find_collection(argv[1], read_classification(argv[2]));
    const std::vector<Mesh> meshes = posed_meshes(collection);
    std::cerr << meshes.size() << " meshes\n";
    CodeBook book;
    learn(book, meshes);
    std::cerr << "words\n";
    Matrix residuals(static_cast<Eigen::Index>(meshes.size()), static_cast<Eigen::Index>(book.residuals()));
    std::vector<std::vector<float>> rich(meshes.size());
    tbb::parallel_for(std::size_t{0}, meshes.size(), [&](std::size_t i) {
      Residuals own(book);
      if (argc == 5) rich[i].resize(18 * kRichNumbers);
      visit_frame_views(meshes[i], render::ViewSphere(1), [&](std::size_t k, const render::DepthImage& image) {
        visit_local_features(image, kTurn, [&](const LocalFeature& f) { own.add(f); });
        if (argc == 5)
          std::ranges::copy(rich_view_numbers(image), rich[i].begin() + static_cast<long>(k * kRichNumbers));
      });
      const std::vector<float> finished = own.finished();
      residuals.row(static_cast<Eigen::Index>(i)) =
          Eigen::Map<const Eigen::RowVectorXf>(finished.data(), static_cast<Eigen::Index>(finished.size()));
      if (i % 50 == 0) std::cerr << i << '\n';
    });
    learn_numbers(book, residuals);
    write_whole_file(argv[3], book.to_bytes());
    if (argc == 5) {
      std::string dump;
      for (std::size_t i = 0; i < meshes.size(); ++i) {
        const auto group = static_cast<std::int32_t>(collection.classes.class_of[i]);
        put(dump, &group, 4);
        put(dump, rich[i].data(), 4 * rich[i].size());
        put(dump, residuals.data() + i * book.residuals(), 4 * book.residuals());
      }
      write_whole_file(argv[4], dump);
    }
  } catch (const std::exception& e) {
    std::cerr << e.what() << '\n';
    return 1;
  }
}
