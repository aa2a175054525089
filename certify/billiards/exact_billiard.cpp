#include "certify/billiards/exact_billiard.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "certify/billiards/billiard_motion.h"
#include "certify/billiards/billiard_window.h"
#include "certify/billiards/near_images.h"
#include "certify/billiards/true_instant.h"
#include "certify/billiards/true_lives.h"
#include "certify/billiards/true_response.h"
#include "exact/patience.h"
#include "filtered/billiards/line_boxes.h"
#include "history/json_text.h"

namespace voroproof::internal {
namespace {

// The middle of a line, where it is known in balls only.
Flight<Rational> middle_of(const TrueLine& line) {
  if (line.exact) return *line.exact;
  const auto middle = [](const Vector3<Ball>& v) {
    return Vec3{v[0].midpoint(), v[1].midpoint(), v[2].midpoint()};
  };
  return {line.ball.t0.midpoint(), middle(line.ball.x), middle(line.ball.v)};
}

class ExactBilliard final : public BilliardTruth {
 public:
  ExactBilliard(const Billiard& billiard, const Rational& horizon, const CertifyOptions& options)
      : billiard_(billiard),
        horizon_(horizon),
        tolerance_(options.tolerance),
        motion_(billiard, horizon, options.motion),
        response_(billiard, motion_, options.tolerance, options.law_tolerance),
        images_(billiard, motion_.exact()),
        lives_(motion_, options.motion.filters),
        meeting_(billiard, motion_.near()) {}

  Rational lag() const override { return tolerance_; }
  void begin() override {
    const BilliardTime start(0);
    meeting_.in(motion_.paths(), start, start);  // for the length of the first window
  }
  double good_length() const override { return meeting_.good_length(); }
  BilliardFindings& found() override { return found_; }

  void collide(const BilliardCollision& claim, const BilliardClaim& at) override {
    BilliardPair pair{claim.a, claim.b, claim.image ? *claim.image : LatticeImage{}};
    if (!claim.image && billiard_.lattice.is_periodic()) pair.image = nearest_image(pair, at);
    const Rational latest = at.t.value() + tolerance_;
    std::string fault;
    const bool is_due = told([&] {
      const auto t = contact_in_time(pair, at, latest);
      if (!t) return false;
      require_mover(pair);
      fault = response_.fault(pair, *t, claim);
      motion_.collide(pair, *t, latest, at.number, at.line);
      return true;
    });
    if (!is_due) return;
    if (!fault.empty()) blame(Fault::wrong_response, at, std::move(fault), pair);
    const auto has_none = [&](int side) {
      return !motion_.is_fixed(side == 0 ? pair.a : pair.b) && !claim.v[side];
    };
    if (has_none(0) || has_none(1)) ++found_.computed_velocities;
    note_order(motion_.paths()[static_cast<std::size_t>(mover(pair))].back().from);
  }

  void maneuver(const BilliardTurn& claim, const BilliardManeuver& due,
                const BilliardClaim& at) override {
    const BilliardPair alone{claim.disk, claim.disk};
    std::string fault;
    const bool in_order = told([&] {
      const Sign after = order(motion_.time(due.t), motion_.last(alone).b.from);
      if (after == Sign::unknown) throw TooCoarse("which of two events comes first is not told");
      fault = response_.fault(due, claim);
      return after != Sign::negative;
    });
    if (!in_order) {
      blame(Fault::wrong_order, at,
            "the maneuver of disk " + std::to_string(claim.disk) +
                " comes before the event of that disk that is claimed before it",
            alone);
      return;
    }
    if (!fault.empty()) blame(Fault::wrong_response, at, std::move(fault), alone);
    motion_.maneuver(due, at.number, at.line);
    note_order(motion_.time(due.t));
  }

  void follow(const BilliardWindow& window) override {
    const std::vector<BilliardPair> pairs = meeting_.in(motion_.paths(), window.from, window.to);
    meeting_.adapt(pairs.size());
    const bool is_end = window.last && window.until == horizon_;
    std::optional<Undecided> untold;  // a fault of another pair is one nevertheless
    const auto attempt = [&](const auto& judge) {
      try {
        judge();
      } catch (const Undecided& at) {
        if (!untold) untold = at;
      }
    };
    for (const BilliardPair& pair : pairs) attempt([&] { follow(pair, window, is_end); });
    attempt([&] { judge_instants(window.to, is_end); });
    if (untold && found_.faults.empty()) throw Undecided(*untold);
    motion_.forget_before(window.to.value());
    found_.highest_bits = motion_.bits();
  }

 private:
  // Asks until balls tell, with more bits from time to time.
  template <class Ask>
  auto told(Ask&& ask) -> decltype(ask()) {
    for (;;) {
      try {
        return ask();
      } catch (const TooCoarse& at) {
        motion_.refine(at.what());
      }
    }
  }

  void follow(const BilliardPair& pair, const BilliardWindow& window, bool is_end) {
    Touches touches;
    std::int64_t lives = 0;
    const auto t = told([&] {
      Patience::ask();
      touches.clear();
      lives = 0;
      return lives_.find_contact(pair, window.from, window.to, is_end, touches, lives);
    });
    found_.pair_lives += lives;
    for (auto& [instant, touching] : touches) touches_[instant].merge(touching);
    // A late claim tells of its contact: that is not missing as well.
    if (t && mistimed_ != pair) miss(pair, *t, window);
  }

  // A disk of the pair that turns at their collision.
  GenId mover(const BilliardPair& pair) const { return motion_.is_fixed(pair.b) ? pair.a : pair.b; }

  std::optional<TrueTime> contact(const BilliardPair& pair, const Rational& until) const {
    const PairLines on = motion_.last(pair);
    return motion_.contact(on, motion_.since(on), until);
  }

  void blame(Fault kind, const BilliardClaim& at, std::string truth, const BilliardPair& pair) {
    found_.faults.push_back(
        {kind, at.line, at.t.near.mid, std::move(truth), std::pair(pair.a, pair.b)});
  }

  LatticeImage nearest_image(const BilliardPair& pair, const BilliardClaim& at) const {
    const PairLines on = motion_.last(pair);
    return images_.nearest(pair, middle_of(on.a), middle_of(on.b), at.t.value());
  }

  bool in_time(const TrueTime& t, const BilliardClaim& at) const {
    const Rational claimed = at.t.value();
    const Sign early = order(t, motion_.time(claimed - tolerance_));
    const Sign late = order(t, motion_.time(claimed + tolerance_));
    if (early == Sign::unknown || late == Sign::unknown)
      throw TooCoarse("whether a claim is within the tolerance is not told");
    return early != Sign::negative && late != Sign::positive;
  }

  // The contact that is claimed; none where it is another: that is a fault.
  std::optional<TrueTime> contact_in_time(const BilliardPair& pair, const BilliardClaim& at,
                                          const Rational& latest) {
    auto t = contact(pair, latest);
    if (t && in_time(*t, at)) return t;
    std::string name = name_of(billiard_, pair);
    if (const auto image = touching_image(pair, at, latest)) {
      const std::string other = name_of(billiard_, {pair.a, pair.b, *image});
      blame(Fault::wrong_image, at, other + " touch, and not " + name, pair);
      return std::nullopt;
    }
    if (!t) t = contact(pair, horizon_);
    if (!t) {
      blame(Fault::spurious_event, at,
            name + " do not touch then, nor later up to the horizon, on their true lines", pair);
      return std::nullopt;
    }
    mistimed_ = pair;
    const double truth = t->near.mid, off = std::fabs(truth - at.t.near.mid);
    blame(Fault::wrong_time, at,
          name + " touch at t = " + number_text(truth) + ", which is " + number_text(off) +
              " off the claimed time (--tolerance sets what is allowed)",
          pair);
    return std::nullopt;
  }

  // Another image that touches then, where the one that is named does not.
  std::optional<LatticeImage> touching_image(const BilliardPair& pair, const BilliardClaim& at,
                                             const Rational& latest) const {
    if (pair.a < 0 || !billiard_.lattice.is_periodic()) return std::nullopt;
    const PairLines on = motion_.last(pair);
    for (const LatticeImage& image :
         images_.all(pair, middle_of(on.a), middle_of(on.b), at.t.value())) {
      if (image == pair.image) continue;
      const auto t = contact({pair.a, pair.b, image}, latest);
      if (t && in_time(*t, at)) return image;
    }
    return std::nullopt;
  }

  // Claims whose truth comes before that of one claimed earlier.
  void note_order(const TrueTime& t) {
    if (latest_ && order(t, *latest_) == Sign::negative) {
      ++found_.swaps;
    } else {
      latest_ = t;
    }
  }

  // Two that touch have to.
  void require_mover(const BilliardPair& pair) const {
    if (motion_.is_fixed(pair.a) && motion_.is_fixed(pair.b))
      throw Undecided(name_of(billiard_, pair) + " touch, and cannot move", pair.a, pair.b);
  }

  void miss(const BilliardPair& pair, const TrueTime& t, const BilliardWindow& window) {
    require_mover(pair);
    const double near = t.near.mid;
    const std::int64_t line =
        window.line_after([&](const BilliardTime& claim) { return near < claim.near.mid; });
    found_.faults.push_back({Fault::missing_event, line, near,
                             name_of(billiard_, pair) + " touch at t = " + number_text(near) +
                                 " on their true lines; no collision of them is claimed",
                             std::pair(pair.a, pair.b)});
  }

  // The instants up to the end of a window at which several touch; one at its end is of the next.
  void judge_instants(const BilliardTime& to, bool is_end) {
    while (!touches_.empty()) {
      const auto first = touches_.begin();
      const Rational& t = first->first;
      if (t > to.value() || (t == to.value() && !is_end)) return;
      auto fault = told([&] { return TrueInstant(billiard_, motion_, t, first->second).fault(); });
      if (fault) found_.faults.push_back(*std::move(fault));
      touches_.erase(first);
    }
  }

  const Billiard& billiard_;
  Rational horizon_, tolerance_;
  BilliardMotion motion_;
  TrueResponse response_;
  NearImages images_;
  TrueLives lives_;
  MeetingPairs meeting_;
  Touches touches_;                       // not judged yet
  std::optional<TrueTime> latest_;        // the latest claim's so far
  std::optional<BilliardPair> mistimed_;  // one of its claims is at another time
  BilliardFindings found_;
};

}  // namespace

std::unique_ptr<BilliardTruth> exact_billiard(const Billiard& billiard, const Rational& horizon,
                                              const CertifyOptions& options) {
  return std::make_unique<ExactBilliard>(billiard, horizon, options);
}

}  // namespace voroproof::internal
