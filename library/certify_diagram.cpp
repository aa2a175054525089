#include "voroproof/certify_diagram.h"

#include <algorithm>
#include <array>
#include <boost/pending/disjoint_sets.hpp>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <set>
#include <stdexcept>
#include <utility>

#include "certify/report.h"
#include "certify/resting_proof.h"
#include "engine/resting_diagram.h"
#include "exact/names.h"
#include "filtered/motion/given_motion.h"
#include "filtered/search/resting_ties.h"
#include "history/json_text.h"
#include "library/resting_disks.h"
#include "library/values.h"

namespace voroproof {
namespace internal {
namespace {

using Pair = std::pair<GenId, GenId>;

// The places of a proved diagram: its vertices, of which those at the ends of an edge without
// length are one.
class VertexPlaces {
 public:
  VertexPlaces(const std::vector<Quad>& edges, const RestingTies& ties) {
    for (const Quad& q : edges) {
      numbers_.emplace(start_vertex(q), numbers_.size());
      numbers_.emplace(end_vertex(q), numbers_.size());
    }
    std::vector<std::size_t> rank(numbers_.size()), parent(numbers_.size());
    std::iota(parent.begin(), parent.end(), std::size_t{0});
    boost::disjoint_sets sets(rank.data(), parent.data());
    for (const Quad& q : edges) {
      if (q.s != q.e && ties.is_point(q)) {
        sets.union_set(numbers_.at(start_vertex(q)), numbers_.at(end_vertex(q)));
      }
    }
    std::vector<std::set<Pair>> sides(numbers_.size());
    for (auto& [name, number] : numbers_) {
      number = sets.find_set(number);
      for (int k = 0; k < 3; ++k) sides[number].insert({name[k], name[(k + 1) % 3]});
    }
    for (const auto& of_place : sides) {
      contacts_.push_back(cycle_of(of_place));
      for (const GenId g : contacts_.back()) of_generator_[g].push_back(contacts_.size() - 1);
    }
  }

  bool is_vertex(const Triple& name) const { return numbers_.contains(name); }
  const std::map<Triple, std::size_t>& vertices() const { return numbers_; }
  // Whether the circle of one vertex touches all of them counterclockwise in this order.
  bool meet(const std::vector<GenId>& all) const {
    const auto found = of_generator_.find(all.front());
    if (found == of_generator_.end()) return false;
    return std::any_of(found->second.begin(), found->second.end(),
                       [&](std::size_t k) { return has_in_order(contacts_[k], all); });
  }

 private:
  using Contacts = std::vector<GenId>;

  // The generators that a vertex's circle touches, counterclockwise. Each triple is so, and two of
  // one place that share an edge without length are on either side of its chord: the chords that
  // are sides of one triple only are those of the whole polygon.
  static Contacts cycle_of(const std::set<Pair>& sides) {
    std::map<GenId, GenId> next;
    for (const auto& [a, b] : sides) {
      if (!sides.contains({b, a})) next.emplace(a, b);
    }
    Contacts cycle;
    if (next.empty()) return cycle;
    const GenId first = next.begin()->first;
    GenId g = first;
    do {
      cycle.push_back(g);
      g = next.at(g);
    } while (g != first);
    return cycle;
  }

  static bool has_in_order(const Contacts& contacts, const std::vector<GenId>& all) {
    std::vector<std::size_t> places;
    for (const GenId g : all) {
      const auto found = std::find(contacts.begin(), contacts.end(), g);
      if (found == contacts.end()) return false;
      places.push_back(static_cast<std::size_t>(found - contacts.begin()));
    }
    std::rotate(places.begin(), std::min_element(places.begin(), places.end()), places.end());
    return std::adjacent_find(places.begin(), places.end(), std::greater_equal<>()) == places.end();
  }

  std::map<Triple, std::size_t> numbers_;  // the places
  std::vector<Contacts> contacts_;         // by place
  std::map<GenId, std::vector<std::size_t>> of_generator_;
};

// Judges a claim, part by part. Each of its functions says what is wrong; empty: nothing.
class DiagramJudge {
 public:
  DiagramJudge(const DiagramClaim& claim, double tolerance, int threads)
      : claim_(claim),
        frame_{claim.frame, claim.walls},
        framed_(frame_.framed(claim.disks.size())),
        tolerance_(tolerance),
        threads_(threads) {
    resting_.input = resting_input(claim.disks, frame_);
    resting_.frame = frame_.kind();
    if (claim.hosts) resting_.hosts = *claim.hosts;
  }

  std::string fault() {
    std::string fault = edges_fault();
    if (!fault.empty() || !(claim_.neighbours || claim_.vertices)) return fault;
    const GivenMotion motion(resting_.input, {});
    const RestingTies ties(motion, resting_.frame);
    const VertexPlaces places(resting_.edges, ties);
    if (claim_.neighbours) fault = neighbours_fault(ties, places);
    if (fault.empty() && claim_.vertices) fault = vertices_fault(places);
    return fault;
  }

  std::string about() const {
    std::string what;
    const auto add = [&](bool judged, const std::string& part) {
      if (judged) what += (what.empty() ? "" : ", ") + part;
    };
    add(claim_.edges.has_value(), "edges");
    add(claim_.neighbours.has_value(), "neighbours");
    add(claim_.hosts.has_value(), "hidden disks");
    add(claim_.vertices.has_value(),
        "vertices within " + number_text(tolerance_) + " of their numbers");
    const std::size_t n = claim_.disks.size();
    return "about the diagram of " + std::to_string(n) + (n == 1 ? " disk" : " disks") +
           (claim_.frame   ? " in a circle: "
            : claim_.walls ? " in a rectangle: "
                           : " in the plane: ") +
           what;
  }

  std::vector<std::string> reservations() const {
    std::vector<std::string> lines;
    const auto add = [&](std::int64_t count, const char* words) {
      if (count > 0) lines.push_back(std::to_string(count) + words);
    };
    add(claim_.edges ? proof_.chosen_otherwise : 0,
        " edges have no length, and are others than the rule of the largest id chooses");
    add(touching_, " pairs of neighbours meet in a vertex only");
    add(left_out_, " neighbours of the frame are not claimed");
    return lines;
  }

 private:
  // Proves the edges that are claimed, or those that the engine proposes.
  std::string edges_fault() {
    if (claim_.edges) {
      for (const Edge& e : *claim_.edges) resting_.edges.push_back(quad(e));
    } else {
      TierCounts counts;
      resting_.edges = resting_diagram(resting_.input, resting_.frame, {}, counts).edges;
    }
    TierCounts counts;
    proof_ = resting_proof(resting_, {}, counts, threads_);
    if (!proof_.fault) return {};
    // A fault of our own edges is none of the claim's; one of its hosts is.
    if (!claim_.edges && !(claim_.hosts && proof_.fault->cell)) {
      throw Undecided("the diagram that the engine proposes is not proved: " + proof_.fault->truth);
    }
    return proof_.fault->truth;
  }

  std::string neighbours_fault(const RestingTies& ties, const VertexPlaces& places) {
    std::set<Pair> claimed;
    for (const auto& [i, j] : *claim_.neighbours) claimed.insert(std::minmax(i, j));
    std::set<Pair> true_pairs;
    for (const Quad& q : resting_.edges) {
      if (q.s == q.e || !ties.is_point(q)) true_pairs.insert(std::minmax(q.l, q.r));
    }
    // The edge all around a lone disk has no name.
    if (claim_.frame && proof_.visible == 1) {
      for (GenId g = 0; g < static_cast<GenId>(proof_.hidden.size()); ++g) {
        if (!proof_.hidden[g]) true_pairs.insert({container_id, g});
      }
    }
    // All pairs of a kind may be left out, but those of two disks.
    const auto kind = [&](const Pair& p) {
      return p.first == container_id ? 0 : framed_.is_wall(p.second) ? 1 : 2;
    };
    std::array<bool, 3> is_claimed{false, false, true};
    for (const Pair& p : claimed) is_claimed[kind(p)] = true;
    for (const Pair& p : true_pairs) {
      if (claimed.contains(p)) continue;
      if (!is_claimed[kind(p)]) {
        ++left_out_;
      } else {
        return "the cells of " + text_of(p.first, p.second) + " have an edge in common";
      }
    }
    for (const Pair& p : claimed) {
      if (true_pairs.contains(p)) continue;
      if (!places.meet({p.first, p.second})) {
        return "the cells of " + text_of(p.first, p.second) + " have no edge in common";
      }
      ++touching_;
    }
    return {};
  }

  std::string vertices_fault(const VertexPlaces& places) {
    const VertexCircles circles(claim_.disks, frame_);
    std::set<Triple> named;
    for (const Vertex& v : *claim_.vertices) {
      const Triple name = canonical(v.generators);
      if (!named.insert(name).second) return "vertex " + text_of(name) + " is named twice";
      const bool is_one =
          places.is_vertex(name) || (!claim_.edges && places.meet({name.begin(), name.end()}));
      if (!is_one || is_at_infinity(name)) return "there is no vertex " + text_of(name);
      const auto truth = circles.of(name);
      if (!truth) return "vertex " + text_of(name) + " is at infinity";
      if (!is_near(v, *truth)) {
        return "the circle of vertex " + text_of(name) + " has the centre " +
               number_text(truth->center[0]) + ", " + number_text(truth->center[1]) +
               " and the radius " + number_text(truth->radius);
      }
    }
    if (!claim_.edges) return {};
    for (const auto& [name, place] : places.vertices()) {
      if (named.contains(name) || is_at_infinity(name) || !circles.of(name)) continue;
      return "vertex " + text_of(name) + " is missing";
    }
    return {};
  }

  bool is_at_infinity(const Triple& name) const { return !claim_.frame && name[0] == container_id; }

  bool is_near(const Vertex& v, const Vertex& truth) const {
    double size = std::fabs(truth.radius);
    const auto add = [&](const Vector& place) {
      size = std::max({size, std::fabs(place[0]), std::fabs(place[1])});
    };
    add(truth.center);
    for (const GenId g : truth.generators) {
      if (framed_.is_wall(g)) {
        add(frame_.place(framed_.quarter(g)));
        continue;
      }
      const Circle& c = g == container_id ? *claim_.frame : claim_.disks[g];
      add(c.center);
      size = std::max(size, std::fabs(c.radius));
    }
    const auto fits = [&](double claimed, double exact) {
      return std::fabs(claimed - exact) <= tolerance_ * size;
    };
    return fits(v.center[0], truth.center[0]) && fits(v.center[1], truth.center[1]) &&
           fits(v.radius, truth.radius);
  }

  const DiagramClaim& claim_;
  RestingFrame frame_;
  Framed framed_;
  double tolerance_;
  int threads_;
  RestingClaim resting_;
  RestingProof proof_;
  std::int64_t touching_ = 0, left_out_ = 0;
};

void require_claim(const DiagramClaim& claim, double tolerance, int threads) {
  require_disks(claim.disks, {claim.frame, claim.walls});
  const int n = static_cast<int>(claim.disks.size()) + (claim.walls ? wall_count : 0);
  const auto fail = [](const std::string& why) { throw std::invalid_argument(why); };
  const auto require = [&](const char* field, int g, int least) {
    if (g < least || g >= n) fail(std::string(field) + ": there is no " + std::to_string(g));
  };
  if (!claim.hosts && !claim.edges && !claim.neighbours && !claim.vertices) {
    fail("the claim says nothing");
  }
  if (!(tolerance >= 0 && tolerance <= 1)) fail("tolerance: not within 0 to 1");
  if (threads < 1 || threads > 1024) fail("threads: not in 1 to 1024");
  if (claim.edges) {
    for (const Edge& e : *claim.edges) {
      for (const int g : {e.l, e.r, e.s, e.e}) require("edges", g, container_id);
    }
  }
  if (claim.hosts) {
    if (claim.hosts->size() != claim.disks.size()) fail("hosts: not as many as disks");
    for (std::size_t k = 0; k < claim.hosts->size(); ++k) {
      require("hosts", (*claim.hosts)[k], StaticDiagram::visible);
      if ((*claim.hosts)[k] == static_cast<int>(k)) fail("hosts: a disk that hides itself");
    }
  }
  if (claim.neighbours) {
    for (const auto& [i, j] : *claim.neighbours) {
      require("neighbours", i, container_id);
      require("neighbours", j, container_id);
      if (i == j) fail("neighbours: one generator twice");
    }
  }
  if (claim.vertices) {
    for (const Vertex& v : *claim.vertices) {
      for (const int g : v.generators) require("vertices", g, container_id);
    }
  }
}

}  // namespace
}  // namespace internal

DiagramReport certify_diagram(const DiagramClaim& claim, double tolerance, int threads) {
  return internal::with_public_errors([&] {
    internal::require_claim(claim, tolerance, threads);
    internal::DiagramJudge judge(claim, tolerance, threads);
    DiagramReport report;
    try {
      report.reason = judge.fault();
      report.verdict = report.reason.empty() ? Verdict::certified : Verdict::refuted;
    } catch (const internal::Undecided& why) {
      report.reason = why.what();
    }
    report.about = judge.about();
    report.reservations = judge.reservations();
    return report;
  });
}

}  // namespace voroproof
