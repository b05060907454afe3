#include "certify/corner_game.h"

namespace rectilin::certification {
namespace {

/// Dictionary simplex (Chvatal 1983, ch. 2-3): basic variables are affine in the nonbasic ones. A column holds
/// the coefficients of one nonbasic variable, or the constants; rows 0-7 belong to the corners, 8-10 to the axes.
/// Corner c's variable is its slack over the game's value L; the row of one corner holds L itself, which
/// never leaves the basis. Starting from pure strategies every dictionary is feasible.
class Dictionary {
 public:
  explicit Dictionary(const CornerGame& game) : game_(game) {
    Array8 payoff = Array8::Zero();
    for (int k = 0; k < 3; ++k) {
      for (int j = 1; j < game.size[k]; ++j)
        if (game.payoff[k][j].sum() > game.payoff[k][pure_[k]].sum()) pure_[k] = j;
      payoff += game.payoff[k][pure_[k]];
    }
    value_ = payoff.minCoeff(&objective_);
    constants_ << payoff - value_, Rest::Zero();
    constants_.segment<3>(8).setOnes();
    constants_[objective_] = value_;
  }

  double value() const { return constants_[objective_]; }

  void maximise(double enough) {
    set_up_columns();
    for (int step = 0; step < kMaxSteps && value() < enough; ++step) {
      const int entering = steepest();
      if (entering < 0) return;
      const int leaving = first_to_vanish(columns_[entering]);
      if (leaving < 0) return;
      pivot(entering, leaving);
    }
  }

  Strategies strategies() const {
    Strategies s;
    if (count_ == 0) {
      for (int k = 0; k < 3; ++k) s.weight[k][pure_[k]] = 1;
      s.corner = Array8::Zero();
      s.corner[objective_] = 1;
      s.value = value_;
      return s;
    }
    for (int row = 0; row < 11; ++row)
      if (basic_[row] < kSlack) s.weight[basic_[row] / 16][basic_[row] % 16] = std::max(0.0, constants_[row]);
    normalise(s);

    // The dual variables of the slacks: what the value loses as they grow.
    s.corner = Array8::Zero();
    for (int j = 0; j < count_; ++j)
      if (name_[j] >= kSlack) s.corner[name_[j] - kSlack] = std::max(0.0, -columns_[j][objective_]);
    const double sum = s.corner.sum();
    if (sum > 0) s.corner /= sum;
    else s.corner.setConstant(0.125);
    return s;
  }

 private:
  using Column = Eigen::Array<double, 12, 1>;  // the last row pads
  using Rest = Eigen::Array<double, 4, 1>;

  static constexpr int kMaxSteps = 40;
  static constexpr int kSlack = 100, kValue = 200;  // names: weights are 16 axis + cut, slacks kSlack + corner

  void set_up_columns() {
    for (int c = 0; c < 8; ++c) basic_[c] = kSlack + c;
    for (int k = 0; k < 3; ++k) basic_[8 + k] = 16 * k + pure_[k];
    basic_[objective_] = kValue;
    for (int k = 0; k < 3; ++k)
      for (int j = 0; j < game_.size[k]; ++j) {
        if (j == pure_[k]) continue;
        const Array8 gain = game_.payoff[k][j] - game_.payoff[k][pure_[k]];
        const double objective_gain = gain[objective_];
        Column& column = add_column(16 * k + j);
        column << gain - objective_gain, Rest::Zero();
        column[objective_] = objective_gain;
        column[8 + k] = -1;
      }
    Column& slack = add_column(kSlack + objective_);
    slack << Array8::Ones(), Rest::Zero();
    slack[objective_] = -1;
  }

  Column& add_column(int name) {
    name_[count_] = name;
    return columns_[count_++];
  }

  int steepest() const {
    int best = -1;
    double slope = 1e-13;
    for (int j = 0; j < count_; ++j)
      if (columns_[j][objective_] > slope) slope = columns_[j][objective_], best = j;
    return best;
  }

  int first_to_vanish(const Column& entering) const {
    int first = -1;
    double least = std::numeric_limits<double>::infinity();
    for (int row = 0; row < 11; ++row) {
      if (row == objective_ || entering[row] > -1e-12) continue;
      const double ratio = -constants_[row] / entering[row];
      if (ratio < least) least = ratio, first = row;
    }
    return first;
  }

  void pivot(int entering, int row) {
    const Column column = columns_[entering];
    const double inverse = 1 / column[row];
    const auto eliminate = [&](Column& other) {
      const double factor = other[row] * inverse;
      other -= factor * column;
      other[row] = -factor;
    };
    for (int j = 0; j < count_; ++j)
      if (j != entering) eliminate(columns_[j]);
    eliminate(constants_);
    columns_[entering] = inverse * column;
    columns_[entering][row] = inverse;
    std::swap(basic_[row], name_[entering]);
  }

  /// Rounding may leave the weights slightly off; the value is that of the weights as they are in the end.
  void normalise(Strategies& s) const {
    Array8 payoff = Array8::Zero();
    for (int k = 0; k < 3; ++k) {
      double sum = 0;
      for (const double weight : s.weight[k]) sum += weight;
      for (int j = 0; j < game_.size[k]; ++j)
        if (s.weight[k][j] > 0) payoff += (s.weight[k][j] /= sum) * game_.payoff[k][j];
    }
    s.value = payoff.minCoeff();
  }

  const CornerGame& game_;
  std::array<int, 3> pure_ = {};  // the cut each axis starts with
  int objective_ = 0;             // the row that holds L
  double value_ = 0;
  int count_ = 0;
  std::array<Column, 3 * kMaxCuts + 1> columns_;
  std::array<int, 3 * kMaxCuts + 1> name_;
  std::array<int, 11> basic_;
  Column constants_;
};

}  // namespace

Strategies solve(const CornerGame& game, double enough) {
  Dictionary dictionary(game);
  if (dictionary.value() < enough) dictionary.maximise(enough);
  return dictionary.strategies();
}

}  // namespace rectilin::certification
