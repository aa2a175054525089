// Which disks of a billiard may touch when: their boxes meet. All corners are whole numbers of a
// unit, rounded away from the box.
//
// Time is cut into windows, and in each every flight has a box. Boxes are moved into one cell of a
// periodic box. A pair of disks is met where the box of the first one there meets one of the second
// there, or an image of that.
#include <algorithm>
#include <optional>

#include "certify/kernel/motion.h"

namespace voroproof_kernel {
namespace {

struct Box {
  int disk;
  std::size_t flight;
  Image image{};       // by which it is moved
  bool moved = false;  // out of the cell
  std::int64_t lo[3]{}, hi[3]{};
};

class Window {
 public:
  Window(const Problem& p, const Rat& from, const Rat& to)
      : scene_(p.scene), p_(p), from_(from), to_(to) {
    const auto bits = [](const Int& x) { return x == 0 ? 0 : static_cast<long>(msb(x)); };
    unit_ = power(2, 16 + bits(denominator(p.extent)) - bits(numerator(p.extent)));
    for (int k = 0; k < 3; ++k) sides_[k] = scene_.sides[k] * unit_;
    drift_ = scene_.shear * sides_[1];
    // Where all fall alike they are seen from what falls with them.
    bool falls = scene_.last_wall() < 0;
    for (const Disk& d : scene_.disks) falls = falls || d.fixed;
    for (int disk = 0; disk < p.disks(); ++disk) {
      const auto& flights = p.flights[disk];
      auto f = std::upper_bound(flights.begin(), flights.end(), from,
                                [](const Rat& t, const Flight& x) { return t < x.start; });
      for (--f; f != flights.end() && (f->start < to || from == to); ++f) {
        add(disk, f - flights.begin(), falls ? p.fall(disk) : Vec{});
      }
    }
  }

  // The lives in it of all whose boxes meet; nothing where there are too many images, or more than
  // a `few` lives.
  std::optional<std::vector<Life>> lives(bool few) {
    std::vector<Life> all;
    const std::size_t most = few ? 16 * boxes_.size() + 1024 : SIZE_MAX;
    fold();
    if (!add_images()) return std::nullopt;
    std::sort(boxes_.begin(), boxes_.end(),
              [](const Box& x, const Box& y) { return x.lo[0] < y.lo[0]; });
    for (auto x = boxes_.begin(); x != boxes_.end(); ++x) {
      for (auto y = x + 1; y != boxes_.end() && y->lo[0] <= x->hi[0]; ++y) {
        const bool apart = x->lo[1] > y->hi[1] || y->lo[1] > x->hi[1] || x->lo[2] > y->hi[2] ||
                           y->lo[2] > x->hi[2];
        const Box &i = x->disk < y->disk ? *x : *y, &j = x->disk < y->disk ? *y : *x;
        if (apart || i.moved || i.disk == j.disk) continue;
        Encounter two{i.disk, j.disk};
        for (int k = 0; k < 3; ++k) two.image[k] = j.image[k] - i.image[k];
        add(all, two, i.flight, j.flight);
        if (all.size() > most) return std::nullopt;
      }
    }
    for (const Box& box : boxes_) {
      for (int wall = scene_.last_wall(); wall < 0; ++wall) {
        if (!box.moved) add(all, {wall, box.disk}, 0, box.flight);
      }
    }
    return all;
  }

 private:
  static std::int64_t below(const Rat& x) { return truncated(x, 60) - 1; }
  static std::int64_t above(const Rat& x) { return truncated(x, 60) + 1; }

  // A disk is on a flight from `begin` up to the next one or the window's end.
  std::pair<Rat, Rat> time(int disk, std::size_t flight) const {
    const auto& all = p_.flights[disk];
    return {std::max(from_, all[flight].start),
            flight + 1 < all.size() ? std::min(to_, all[flight + 1].start) : to_};
  }

  void add(int disk, std::size_t flight, const Vec& fall) {
    const auto [s, t] = time(disk, flight);
    const Flight& f = p_.flights[disk][flight];
    const Disk& d = scene_.disks[disk];
    const Vec x = plus(plus(f.a, s, f.b), s * s, fall), y = plus(plus(f.a, t, f.b), t * t, fall);
    const Rat radius = d.radius + std::max(Rat(d.growth * s), Rat(d.growth * t));
    Box& box = boxes_.emplace_back(Box{disk, flight});
    for (int k = 0; k < scene_.coordinates(); ++k) {
      // A parabola is no farther from its chord than that.
      const Rat around = radius + abs(fall[k]) * square(t - s) / 4;
      box.lo[k] = below((std::min(x[k], y[k]) - around) * unit_);
      box.hi[k] = above((std::max(x[k], y[k]) + around) * unit_);
    }
  }

  void add(std::vector<Life>& to, const Encounter& two, std::size_t i, std::size_t j) const {
    auto [begin, end] = time(two.j, j);
    if (two.i >= 0) {
      const auto [first, last] = time(two.i, i);
      begin = std::max(begin, first);
      end = std::min(end, last);
    }
    if (begin < end || from_ == to_) to.push_back({two, {i, j}, begin, end});
  }

  // Moves a box by n images along an axis. Images along the second axis move along the first one.
  void move(Box& box, int axis, std::int64_t n) const {
    const auto widen = [&](int k, const Rat& x, const Rat& y) {
      box.lo[k] = below(box.lo[k] + std::min(x, y));
      box.hi[k] = above(box.hi[k] + std::max(x, y));
    };
    if (n == 0) return;
    widen(axis, n * sides_[axis], n * sides_[axis]);
    if (axis == 1 && drift_ != 0) widen(0, n * drift_ * from_, n * drift_ * to_);
    box.image[axis] += static_cast<int>(n);
  }

  std::int64_t cell(const Box& box, int axis) const {
    return truncated(box.lo[axis] / sides_[axis], 28);
  }

  // The cell of the second axis is that of the first box: far images of it drift fast.
  void fold() {
    for (const int axis : {2, 1, 0}) {
      if (sides_[axis] == 0 || boxes_.empty()) continue;
      const std::int64_t base = axis == 1 ? cell(boxes_.front(), 1) : 0;
      for (Box& box : boxes_) move(box, axis, base - cell(box, axis));
    }
  }

  // All images of boxes that meet the hull of those in the cell; false where they are too many.
  bool add_images() {
    const std::size_t most = 64 * boxes_.size() + 4096;
    Box hull = boxes_.empty() ? Box{} : boxes_.front();
    for (const Box& box : boxes_) {
      for (int k = 0; k < 3; ++k) {
        hull.lo[k] = std::min(hull.lo[k], box.lo[k]);
        hull.hi[k] = std::max(hull.hi[k], box.hi[k]);
      }
    }
    for (const int axis : {2, 1, 0}) {
      if (sides_[axis] == 0) continue;
      const std::size_t so_far = boxes_.size();
      for (std::size_t b = 0; b < so_far; ++b) {
        const std::int64_t first = below((hull.lo[axis] - boxes_[b].hi[axis]) / sides_[axis]),
                           last = above((hull.hi[axis] - boxes_[b].lo[axis]) / sides_[axis]);
        for (std::int64_t n = first; n <= last; ++n) {
          if (boxes_.size() > most) return false;
          Box box = boxes_[b];
          box.moved = true;
          move(box, axis, n);
          const bool meets = box.lo[axis] <= hull.hi[axis] && box.hi[axis] >= hull.lo[axis];
          if (n != 0 && meets) boxes_.push_back(box);
        }
      }
    }
    return true;
  }

  const Scene& scene_;
  const Problem& p_;
  Rat from_, to_, unit_, drift_;
  Vec sides_;
  std::vector<Box> boxes_;
};

bool is_positive(const Form& p, const Rat& from, const Rat& to) {
  const Form f = over(p, from, to);
  if (f.front() <= 0 || f.back() <= 0) return false;
  return variations(f) == 0 || (f.size() == 3 && f[1] * f[1] < 4 * f[0] * f[2]);
}

Form gap(const Problem& p, const Life& life) {
  const Flight* i = life.two.i < 0 ? nullptr : &p.flights[life.two.i][life.flight[0]];
  return Meeting(p, life.two, i, p.flights[life.two.j][life.flight[1]]).gap();
}

class Finder {
 public:
  Finder(const Problem& p, std::vector<Life>& lives) : p_(p), lives_(lives) {}

  // Adds the lives in a time that has been halved so often.
  void look(const Rat& from, const Rat& to, int halved) {
    if (from >= to) return;
    const std::size_t most = 100000 + 16 * p_.history.claims.size();
    if (++windows_ > most || halved > 64)
      undecided("a disk runs past more images of others than are looked at");
    // Disks that stay together are not parted by halving.
    const auto lives = Window(p_, from, to).lives(halved < 6);
    if (!lives) {
      const Rat middle = (from + to) / 2;
      look(from, middle, halved + 1);
      look(middle, to, halved + 1);
      return;
    }
    for (const Life& life : *lives) {
      if (!is_positive(gap(p_, life), life.from, life.to)) lives_.push_back(life);
    }
  }

 private:
  const Problem& p_;
  std::vector<Life>& lives_;
  std::size_t windows_ = 0;
};

std::vector<Life> lives_at(const Problem& p, const Rat& t) {
  const auto lives = Window(p, t, t).lives(false);
  if (!lives) undecided("too many images of disks meet at one time");
  return *lives;
}

}  // namespace

void check_start(const Problem& p) {
  for (const Life& life : lives_at(p, 0)) {
    if (sign_at(gap(p, life), 0) < 0) invalid(name(p, life.two) + " overlap at the start");
  }
}

void find_lives(const Problem& p, std::vector<Life>& lives) {
  const auto& claims = p.history.claims;
  const std::size_t step = std::max(64, p.disks());
  Finder finder(p, lives);
  Rat now = 0, end = p.history.horizon;
  for (std::size_t k = step; k < claims.size(); k += step) {
    p.tell("lives", k);
    finder.look(now, claims[k].t, 0);
    now = claims[k].t;
  }
  if (!claims.empty()) end = std::max(end, claims.back().t);
  finder.look(now, end, 0);
  for (const Life& life : lives_at(p, end)) {
    if (sign_at(gap(p, life), end) == 0) lives.push_back(life);
  }
}

}  // namespace voroproof_kernel
