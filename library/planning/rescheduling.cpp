#include "library/planning/rescheduling.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

#include "library/planning/slowing.h"

namespace voroproof::internal {
namespace {

// Columns of time and levels of progress; even speed rises by even_rise levels a column.
constexpr int columns = 64, levels = 128, even_rise = levels / columns;
constexpr int column_steps = time_steps / columns, level_parts = whole_way / levels;
constexpr int max_rise = max_speed_up * even_rise;

class Search {
 public:
  Search(int vehicle, const std::vector<Timetable>& all, const Conjunctions& conjunctions,
         Haste haste, int ignored)
      : vehicle_(vehicle), all_(all), conjunctions_(conjunctions), haste_(haste) {
    for (const int other : conjunctions.neighbors(vehicle))
      if (other != ignored) others_.push_back(other);
  }

  std::optional<Timetable> run() {
    cost_[0].fill(unreachable);
    cost_[0][0] = 0;
    for (int column = 0; column < columns; ++column) {
      note_others(column);
      extend(column);
    }
    if (cost_[columns][levels] == unreachable) return std::nullopt;
    Timetable timetable;
    for (int column = columns, level = levels; column >= 0; --column) {
      timetable.push_back({column * column_steps, level * level_parts});
      level -= rise_[column][level];
    }
    std::reverse(timetable.begin(), timetable.end());
    drop_idle_knots(timetable);
    if (!clear(timetable)) return std::nullopt;
    simplify(timetable);
    return timetable;
  }

 private:
  static constexpr int unreachable = std::numeric_limits<int>::max();

  // A piece of another vehicle's progress, within one column.
  struct Piece {
    int other;
    int from, to;  // steps
    double start, end;
  };

  void note_others(int column) {
    pieces_.clear();
    const int first = column * column_steps, last = first + column_steps;
    for (const int other : others_) {
      const Timetable& timetable = all_[other];
      int from = first;
      for (const Knot& knot : timetable) {
        if (knot.step <= first || from == last) continue;
        const int to = std::min(knot.step, last);
        const Piece piece{other, from, to, progress_at<double>(timetable, from),
                          progress_at<double>(timetable, to)};
        if (conjunctions_.reaches(other, piece.start, piece.end, vehicle_))
          pieces_.push_back(piece);
        from = to;
      }
    }
  }

  void extend(int column) {
    cost_[column + 1].fill(unreachable);
    for (int level = 0; level <= levels; ++level) {
      const int here = cost_[column][level];
      if (here == unreachable) continue;
      for (int rise = 0; rise <= max_rise && level + rise <= levels; ++rise) {
        const int cost = here + (rise - even_rise) * (rise - even_rise) + delay(level + rise);
        if (cost >= cost_[column + 1][level + rise] || blocked(column, level, rise)) continue;
        cost_[column + 1][level + rise] = cost;
        rise_[column + 1][level + rise] = rise;
      }
    }
  }

  // The cost of this level for a timetable that is to be early or late rather than even.
  int delay(int level) const {
    return haste_ == Haste::even ? 0 : haste_ == Haste::early ? levels - level : level;
  }

  bool blocked(int column, int level, int rise) {
    const auto progress = [&](int step) {
      return level_parts *
             (level + rise * static_cast<double>(step - column * column_steps) / column_steps);
    };
    const auto blocks = [&](const Piece& piece) {
      return conjunctions_
                 .nearest(vehicle_, progress(piece.from), progress(piece.to), piece.other,
                          piece.start, piece.end)
                 .excess < -conjunctions_.doubt();
    };
    const auto found = std::find_if(pieces_.begin(), pieces_.end(), blocks);
    if (found == pieces_.end()) return false;
    // The piece that blocks one step is tried first for the next: it often blocks steps nearby.
    std::rotate(pieces_.begin(), found, found + 1);
    return true;
  }

  bool clear(const Timetable& timetable) const {
    return std::none_of(others_.begin(), others_.end(), [&](int other) {
      return conjunctions_.first(vehicle_, timetable, other, all_[other]);
    });
  }

  // Fewer changes of speed, as long as the way stays clear.
  void simplify(Timetable& timetable) const {
    for (std::size_t k = 1; k + 1 < timetable.size();) {
      Timetable shorter = timetable;
      shorter.erase(shorter.begin() + static_cast<std::ptrdiff_t>(k));
      drop_idle_knots(shorter);
      if (clear(shorter))
        timetable = std::move(shorter);
      else
        ++k;
    }
  }

  int vehicle_;
  const std::vector<Timetable>& all_;
  const Conjunctions& conjunctions_;
  Haste haste_;
  std::vector<int> others_;
  std::vector<Piece> pieces_;
  std::array<std::array<int, levels + 1>, columns + 1> cost_, rise_{};
};

}  // namespace

std::optional<Timetable> rescheduled(int vehicle, const std::vector<Timetable>& all,
                                     const Conjunctions& conjunctions, Haste haste, int ignored) {
  return Search(vehicle, all, conjunctions, haste, ignored).run();
}

}  // namespace voroproof::internal
