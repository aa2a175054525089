#include "tests/world/mutants.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <variant>

#include "exact/topology/diagram.h"

namespace voroproof::internal::testing {
namespace {

class Mutation {
 public:
  Mutation(const World& world, const WrittenWorld& right, const Rational& tolerance,
           std::mt19937_64& random)
      : world_(world), history_(right), tolerance_(tolerance), random_(random) {}

  std::optional<Mutant> make() {
    using Change = bool (Mutation::*)();
    static constexpr std::pair<const char*, Change> changes[] = {
        {"one missing", &Mutation::drop},
        {"two missing", &Mutation::drop_two},
        {"wrong time", &Mutation::move},
        {"exchanged", &Mutation::exchange},
        {"repeated", &Mutation::repeat},
        {"wrong names", &Mutation::rename},
        {"wrong jump or turn", &Mutation::spoil_schedule},
        {"wrong beginning", &Mutation::spoil_beginning},
        {"invented", &Mutation::invent}};
    const auto& [kind, change] = changes[pick(std::size(changes))];
    if (!(this->*change)()) return std::nullopt;
    return Mutant{kind, std::move(history_)};
  }

 private:
  std::vector<WorldEvent>& events() { return history_.events; }
  std::size_t pick(std::size_t count) { return random_() % count; }
  auto at(std::size_t place) { return events().begin() + static_cast<std::ptrdiff_t>(place); }
  GenId any_generator() { return static_cast<GenId>(pick(world_.disks.size() + 1)) - 1; }

  bool drop() {
    if (events().empty()) return false;
    events().erase(at(pick(events().size())));
    return true;
  }

  bool drop_two() {
    if (events().size() < 2) return false;
    const std::size_t place = pick(events().size() - 1);
    events().erase(at(place), at(place + 2));
    return true;
  }

  bool move() {
    if (events().empty()) return false;
    Rational& t = events()[pick(events().size())].t;
    t += (pick(2) == 0 ? 3 : -3) * tolerance_;
    const auto earlier = [](const WorldEvent& a, const WorldEvent& b) { return a.t < b.t; };
    return t >= 0 && t <= world_.horizon &&
           std::is_sorted(events().begin(), events().end(), earlier);
  }

  // Two events of different times.
  bool exchange() {
    if (events().size() < 2) return false;
    const std::size_t place = pick(events().size() - 1);
    if (events()[place + 1].t - events()[place].t <= 2 * tolerance_) return false;
    std::swap(events()[place].what, events()[place + 1].what);
    return true;
  }

  bool repeat() {
    if (events().empty()) return false;
    const std::size_t place = pick(events().size());
    events().insert(at(place), WorldEvent(events()[place]));
    return true;
  }

  bool rename() {
    if (events().empty()) return false;
    auto& what = events()[pick(events().size())].what;
    if (auto* q = std::get_if<Quad>(&what)) {
      std::swap(q->s, q->e);
      *q = canonical(*q);
      return true;
    }
    if (auto* hide = std::get_if<Hide>(&what)) {
      const GenId before = std::exchange(hide->j, any_generator());
      return hide->j != hide->g && hide->j != before;
    }
    if (auto* appear = std::get_if<Appear>(&what); appear != nullptr && appear->at) {
      std::swap(appear->at->s, appear->at->e);
      return appear->at->s != appear->at->e;
    }
    return false;
  }

  bool spoil_schedule() {
    if (events().empty()) return false;
    auto& what = events()[pick(events().size())].what;
    if (auto* turn = std::get_if<PathTurn>(&what); turn != nullptr && turn->velocity) {
      turn->velocity->x += 1;
      return true;
    }
    auto* jump = std::get_if<Jump>(&what);
    if (jump == nullptr) return false;
    auto* steps = pick(2) == 0 && jump->out ? &*jump->out : jump->in ? &*jump->in : nullptr;
    if (steps == nullptr || steps->size() < 2) {
      if (!jump->radius) return false;
      *jump->radius += 1;
      return true;
    }
    steps->erase(steps->begin() + 1 + static_cast<std::ptrdiff_t>(pick(steps->size() - 1)));
    return true;
  }

  bool spoil_beginning() {
    if (history_.initial.empty()) return false;
    const auto disks = static_cast<int>(world_.disks.size());
    std::vector<bool> hidden(world_.disks.size(), true);
    for (const Quad& q : history_.initial) {
      for (const GenId g : {q.l, q.r}) {
        if (g >= 0) hidden[static_cast<std::size_t>(g)] = false;
      }
    }
    Diagram diagram = diagram_of(disks, history_.initial, hidden);
    const auto h = 2 * static_cast<Diagram::HalfEdge>(pick(history_.initial.size()));
    if (diagram.quad(h).s == diagram.quad(h).e) return false;
    diagram.flip(h);
    history_.initial = diagram.quads();
    return true;
  }

  bool invent() {
    if (world_.disks.empty()) return false;
    WorldEvent event;
    event.t = world_.horizon * Rational(static_cast<long>(pick(1000)), 1000);
    const GenId g = static_cast<GenId>(pick(world_.disks.size())), j = any_generator();
    if (g == j) return false;
    if (pick(2) == 0) {
      event.what = Hide{g, j};
    } else if (!history_.initial.empty()) {
      event.what = history_.initial[pick(history_.initial.size())];
    } else {
      event.what = Appear{g, j, std::nullopt};
    }
    const auto later = [&](const WorldEvent& other) { return other.t > event.t; };
    events().insert(std::find_if(events().begin(), events().end(), later), event);
    return true;
  }

  const World& world_;
  WrittenWorld history_;
  Rational tolerance_;
  std::mt19937_64& random_;
};

}  // namespace

std::optional<Mutant> mutant(const World& world, const WrittenWorld& right,
                             const Rational& tolerance, std::mt19937_64& random) {
  return Mutation(world, right, tolerance, random).make();
}

}  // namespace voroproof::internal::testing
