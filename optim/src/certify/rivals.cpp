// foreach_target.h includes this file again for each instruction set and has to come first.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "certify/rivals.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"
// clang-format on

#include "certify/rivals.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "certify/store_chosen-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rectilin::certification::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using SquareNumbers = std::array<std::int64_t, 8>;

/// The numbers of the table's squares to which an axis points at the corners of a box, as CutTable::square_of().
SquareNumbers squares_at(const Corners& corners, int axis) {
  const hn::CappedTag<double, 8> d;
  const hn::RebindToSigned<decltype(d)> whole;
  const auto all = [d](double value) HWY_ATTR { return hn::Set(d, value); };
  using V = hn::Vec<decltype(d)>;
  SquareNumbers numbers;
  for (std::size_t first = 0; first < 8; first += hn::Lanes(d)) {
    const auto entry = [&](int i) HWY_ATTR { return hn::LoadU(d, corners.entry[3 * axis + i].data() + first); };
    const V x = entry(0), y = entry(1), z = entry(2);
    const V ax = hn::Abs(x), ay = hn::Abs(y), az = hn::Abs(z);
    const auto not_x = hn::Gt(hn::Max(ay, az), ax), is_z = hn::And(not_x, hn::Gt(az, ay));
    const auto pick = [&](V if_x, V if_y, V if_z)
                          HWY_ATTR { return hn::IfThenElse(is_z, if_z, hn::IfThenElse(not_x, if_y, if_x)); };
    const V side = all(CutTable::kSide), half = all(0.5 * CutTable::kSide), longest = pick(x, y, z);
    const V scale = hn::Div(half, hn::Abs(longest));
    const auto column = [&](V u) HWY_ATTR {
      return hn::Trunc(hn::Min(hn::MulAdd(scale, u, half), all(CutTable::kSide - 0.5)));
    };
    const V negative = hn::IfThenElseZero(hn::Lt(longest, hn::Zero(d)), all(1));
    const V face = hn::Add(pick(hn::Zero(d), all(2), all(4)), negative);
    const V number = hn::MulAdd(hn::MulAdd(face, side, column(pick(y, z, x))), side, column(pick(z, x, y)));
    hn::StoreU(hn::ConvertTo(whole, number), whole, numbers.data() + first);
  }
  return numbers;
}

/// An axis of the rotation at the middle of a box, and how it moves from there to the middles of three of its faces, to
/// first order.
struct MovingAxis {
  Eigen::Vector3d at;
  std::array<Eigen::Vector3d, 3> moves;

  MovingAxis(const Box& box, const Eigen::Vector3d& axis) : at(axis) {
    // A frame with the Rodrigues vector rho turns by 2 / (1 + |rho|^2) (rho x d - d) in the mesh's coordinates if rho
    // grows by d.
    const Eigen::Vector3d rho = box.centre(), e = box.half_edges();
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector3d unit = Eigen::Vector3d::Unit(i);
      moves[i] = 2 * e[i] / (1 + rho.squaredNorm()) * (rho.cross(unit) - unit).cross(at);
    }
  }
};

/// Adds those rows of a square that exceed `known` somewhere on the box, as long as there is room.
HWY_INLINE void add_rows(const CutTable::Square& square, const Eigen::Vector3d& known, const MovingAxis& axis,
                         CutList& list) {
  const hn::CappedTag<float, CutTable::kLanes> d;
  const hn::RebindToUnsigned<decltype(d)> numbers;
  using V = hn::Vec<decltype(d)>;
  const auto all = [d](double value) HWY_ATTR { return hn::Set(d, static_cast<float>(value)); };
  const Eigen::Vector3d rest = known - known.cast<float>().cast<double>();
  std::size_t left = square.size();
  for (const CutTable::Block& block : square.blocks)
    for (std::size_t i = 0; i < CutTable::kLanes && left > 0; i += hn::Lanes(d)) {
      const std::size_t count = std::min(left, hn::Lanes(d));
      left -= count;
      const auto more = [&](int c) HWY_ATTR {
        return hn::Add(hn::Sub(hn::LoadU(d, block.row[c].data() + i), all(known[c])),
                       hn::Sub(hn::LoadU(d, block.rest[c].data() + i), all(rest[c])));
      };
      const V x = more(0), y = more(1), z = more(2);
      const auto along = [&](const Eigen::Vector3d& u) HWY_ATTR {
        return hn::MulAdd(z, all(u[2]), hn::MulAdd(y, all(u[1]), hn::Mul(x, all(u[0]))));
      };
      const V lead = along(axis.at), a = along(axis.moves[0]), b = along(axis.moves[1]), c = along(axis.moves[2]);
      const V most = hn::Add(hn::Add(lead, hn::Abs(a)), hn::Add(hn::Abs(b), hn::Abs(c)));
      const auto wins = hn::And(hn::Gt(most, hn::Zero(d)), hn::FirstN(d, count));
      if (hn::AllFalse(d, wins)) continue;
      const auto add = [&](V v, CutList::PerRow<float>& to)
                           HWY_ATTR { store_chosen(d, v, wins, to.data() + list.size); };
      add(lead, list.lead), add(a, list.along[0]), add(b, list.along[1]), add(c, list.along[2]);
      store_chosen(numbers, hn::LoadU(numbers, block.index.data() + i), hn::RebindMask(numbers, wins),
                   list.row.data() + list.size);
      list.size = std::min(list.size + hn::CountTrue(d, wins), CutList::kMost - 1);
    }
}

/// Starts a list with the cell's own cuts.
void add_own(const Cell::Bundle& bundle, const CutTable& table, const MovingAxis& axis, CutList& list) {
  int best = 0;
  for (int j = 1; j < bundle.size; ++j)
    if (table[bundle.cuts[j]].dot(axis.at) > table[bundle.cuts[best]].dot(axis.at)) best = j;
  list.size = static_cast<std::size_t>(bundle.size);
  for (int j = 0; j < bundle.size; ++j) {
    const std::size_t to = j == best ? 0 : j == 0 ? best : j;
    const Eigen::Vector3d more = table[bundle.cuts[j]] - table[bundle.cuts[best]];
    list.row[to] = bundle.cuts[j];
    list.lead[to] = static_cast<float>(more.dot(axis.at));
    for (int i = 0; i < 3; ++i) list.along[i][to] = static_cast<float>(more.dot(axis.moves[i]));
  }
}

void find(const Cell& cell, const CutTable& table, const Rotation& middle, CutLists& lists) {
  const Corners corners(cell.box);
  for (int k = 0; k < 3; ++k) {
    CutList& list = lists[k];
    const MovingAxis axis(cell.box, middle.axis(k));
    add_own(cell.bundles[k], table, axis, list);
    const Eigen::Vector3d known = table[list.row[0]];
    std::array<bool, CutTable::kSquares> seen = {};
    const auto look = [&](std::size_t number) {
      if (!seen[number]) add_rows(table.square(number), known, axis, list);
      seen[number] = true;
    };
    look(CutTable::square_of(axis.at));
    for (const std::int64_t number : squares_at(corners, k)) look(static_cast<std::size_t>(number));
    list.row[list.size] = list.row[0];
    list.lead[list.size] = 0;
    for (auto& along : list.along) along[list.size] = 0;
  }
}

}  // namespace
}  // namespace rectilin::certification::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rectilin::certification {

HWY_EXPORT(find);

void find_rivals(const Cell& cell, const CutTable& table, const Rotation& middle, CutLists& lists) {
  HWY_DYNAMIC_DISPATCH(find)(cell, table, middle, lists);
}

}  // namespace rectilin::certification
#endif
