#include "tests/adversary/rewrite.h"

#include <algorithm>
#include <cmath>

#include "tests/adversary/truth.h"

namespace voroproof::internal::adversary {
namespace {

void sort_by_time(History& h) {
  for (Line& line : h.lines) line.t = std::clamp(line.t, 0.0, h.horizon);
  std::stable_sort(h.lines.begin(), h.lines.end(),
                   [](const Line& a, const Line& b) { return a.t < b.t; });
}

// Turns of one disk need not commute: the later one stays behind the earlier one.
void keep_order_of_turns(History& h) {
  for (auto b = h.lines.begin(); b != h.lines.end(); ++b) {
    if (b->kind == Line::Kind::flip) continue;
    for (auto a = h.lines.begin(); a != b; ++a) {
      if (a->kind == Line::Kind::flip) continue;
      const bool shared = concerns(*a, b->j) || (b->i >= 0 && concerns(*a, b->i));
      if (shared) b->t = std::max(b->t, a->t);
    }
  }
}

double some_shift(Random& random) {
  const double size = random.chance(0.5) ? random.log_uniform(1e-12, 0.99 * tolerance)
                                         : random.log_uniform(1.01 * tolerance, 1);
  return random.chance(0.5) ? size : -size;
}

// Back and forth, or a velocity that the other end takes up.
void change_pair(Line& line, Random& random) {
  const double amount = random.log_uniform(1e-12, 1) * (random.chance(0.5) ? 1 : -1);
  const auto k = static_cast<std::size_t>(random.integer(0, 1));
  line.v[1][k] += amount;
  if (line.i >= 0) line.v[0][k] -= amount;
}

}  // namespace

void rewrite(History& h, Rewriting how, Random& random) {
  switch (how) {
    case Rewriting::flips_shifted:
    case Rewriting::all_shifted:
      for (Line& line : h.lines) {
        if (how == Rewriting::flips_shifted && line.kind != Line::Kind::flip) continue;
        line.t += random.uniform(-0.95, 0.95) * tolerance;
      }
      keep_order_of_turns(h);
      sort_by_time(h);
      break;
    case Rewriting::neighbours_exchanged:
      for (std::size_t k = 0; k + 1 < h.lines.size(); ++k) {
        Line &a = h.lines[k], &b = h.lines[k + 1];
        if (b.t - a.t > 0.9 * tolerance || random.chance(0.5)) continue;
        // Events that share a disk need not commute.
        bool apart = a.kind == Line::Kind::flip || b.kind == Line::Kind::flip;
        for (const Line* flip : {&a, &b}) {
          if (flip->kind != Line::Kind::flip) continue;
          for (const int id : flip->edge) {
            apart = apart && (id < 0 || !concerns(flip == &a ? b : a, id));
          }
        }
        if (!apart) continue;
        std::swap(a.t, b.t);
        std::swap(a, b);
        ++k;
      }
      break;
    case Rewriting::horizon_cut: {
      h.horizon *= random.uniform(0.1, 1);
      h.lines.erase(std::remove_if(h.lines.begin(), h.lines.end(),
                                   [&](const Line& line) { return line.t > h.horizon; }),
                    h.lines.end());
      break;
    }
    case Rewriting::none:
    case Rewriting::count:
      break;
  }
}

void fuzz(History& h, Random& random) {
  for (int changes = random.integer(1, 4); changes > 0 && !h.lines.empty(); --changes) {
    const auto size = static_cast<int>(h.lines.size());
    const auto k = static_cast<std::size_t>(random.integer(0, size - 1));
    const auto other = static_cast<std::size_t>(random.integer(0, size - 1));
    Line& line = h.lines[k];
    switch (random.integer(0, 10)) {
      case 0:
        h.lines.erase(h.lines.begin() + static_cast<std::ptrdiff_t>(k));
        break;
      case 1:
        h.lines.insert(h.lines.begin() + static_cast<std::ptrdiff_t>(k), Line(line));
        break;
      case 2:
        if (k + 1 < h.lines.size()) {
          std::swap(h.lines[k], h.lines[k + 1]);
          std::swap(h.lines[k].t, h.lines[k + 1].t);
        }
        break;
      case 3:
        line.t += some_shift(random);
        break;
      case 4:
        std::swap(line.edge[2], line.edge[3]);
        break;
      case 5:
        change_pair(line, random);
        break;
      case 6:
        line.v[1][0] *= 1 + 1e-9 * random.uniform(-3, 3);
        break;
      case 7: {
        // A flip and its way back.
        Line back = line;
        if (line.kind != Line::Kind::flip) break;
        back.edge = canonical({line.edge[2], line.edge[3], line.edge[1], line.edge[0]});
        h.lines.insert(h.lines.begin() + static_cast<std::ptrdiff_t>(k) + 1, back);
        break;
      }
      case 8:
        // All of one instant are shifted together.
        {
          const double shift = some_shift(random), t = line.t;
          for (Line& same : h.lines) {
            if (std::fabs(same.t - t) <= tolerance) same.t += shift;
          }
        }
        break;
      case 9: {
        Line copy = h.lines[other];
        copy.t = line.t;
        h.lines.insert(h.lines.begin() + static_cast<std::ptrdiff_t>(k), copy);
        break;
      }
      default:
        std::swap(h.lines[k], h.lines[other]);
        std::swap(h.lines[k].t, h.lines[other].t);
        break;
    }
  }
  sort_by_time(h);
}

}  // namespace voroproof::internal::adversary
