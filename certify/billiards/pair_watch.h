// Whether the collisions claimed of two are those of their recorded paths: the rules of
// docs/claim.md, section 9, for one pair.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "certify/billiards/billiard_truth.h"
#include "certify/billiards/billiard_window.h"
#include "certify/billiards/near_images.h"
#include "exact/algebraic.h"

namespace voroproof::internal {

// base + u, u an algebraic number.
struct EntryTime {
  Rational base;
  AlgebraicNumber<Rational> u;
  std::strong_ordering operator<=>(const Rational& t) const { return compare(u, t - base); }
  double rounded() const { return round_nearest(Rational(base + to_rational(round_nearest(u)))); }
};

// A maximal interval of time in which the two overlap.
struct OverlapEpisode {
  EntryTime entry;
  bool deep = false;               // whether it is deeper than the rounding so far
  bool told = false;               // a fault of it has been told
  std::optional<Rational> answer;  // the time of the claim that answers its entry
  std::int64_t answer_line = 0;
  std::int64_t line = 0;  // the first claim's after the entry
};

// A pair between two windows. Nothing has to be kept of two that are apart.
struct PairState {
  std::optional<OverlapEpisode> open;  // in progress
  std::vector<OverlapEpisode> ended;   // not answered yet
  // A claim was answered at that time, and the episode may be in progress. Doubles did not tell.
  std::optional<CompactRational> answered;
  std::int64_t answered_line = 0;
  bool is_empty() const { return !open && ended.empty() && !answered; }
};

class PairWatch {
 public:
  // `billiard` must outlive it. `extent`: rounding is in proportion to it (docs/claim.md).
  // `filters`: doubles decide where they can; what is found is the same without.
  PairWatch(const Billiard& billiard, const Rational& horizon, const Rational& tolerance,
            const Rational& extent, bool filters);

  // Follows the pair through the window, for which `meeting` has been asked. `a` is ignored for a
  // wall. `claims`: those of this pair, in order.
  void follow(const BilliardPair& pair, const BilliardPath& a, const BilliardPath& b,
              std::span<const BilliardClaim> claims, const BilliardWindow& window,
              const MeetingPairs& meeting, PairState& state, BilliardFindings& found) const;

  const BilliardGaps<Rational>& exact() const { return exact_; }
  const BilliardGaps<DoubleBall>& near() const { return near_; }

  const NearImages& images() const { return images_; }

  // "disks 0 and 1", "disk 3 and wall -2", with the image where it is another than the disk itself.
  std::string name(const BilliardPair& pair) const;

 private:
  // The pair between two turns of either, on lines that both keep, in the time after `from`.
  struct Life {
    const BilliardPair& pair;
    const BilliardPath &path_a, &path_b;
    std::size_t index_a, index_b;
    const BilliardTime &from, &to;
    GapForm<DoubleBall> near{};  // in the time since `from`
    double length_up = 0, length_down = 0;

    const BilliardLine& a() const { return path_a[index_a]; }
    const BilliardLine& b() const { return path_b[index_b]; }
    Rational since() const { return from.value(); }
    Rational length() const { return to.value() - from.value(); }
    // When their lines began: earlier than `from` where a window began since.
    Rational begin() const;
  };

  // The pair on its way through a window.
  struct Walk {
    const BilliardPair& pair;
    const BilliardWindow& window;
    const MeetingPairs& meeting;
    PairState& state;
    BilliardFindings& found;

    // The line of the first claim after that time.
    std::int64_t line_after(const EntryTime& x) const {
      return window.line_after([&](const BilliardTime& t) { return (x <=> t.value()) < 0; });
    }
  };

  bool certainly_regular(const Life& life, bool answered, bool claimed) const;
  void live(Life& life, const BilliardClaim* claim, Walk& walk) const;
  void judge_life(const Life& life, Walk& walk) const;
  void count_left_out(const Life& life, Walk& walk) const;
  void judge_claim(const Life& life, const BilliardClaim& claim, Walk& walk) const;
  bool have_parted(const Life& life) const;
  bool answer_open(const Life& life, const Rational& t, Walk& walk) const;
  bool answers(const Life& life, const BilliardClaim& claim, Walk& walk) const;
  bool comes_near(const Life& life, const Rational& t, Walk& walk) const;
  BilliardFault fault_of(const Life& life, const BilliardClaim& claim) const;
  std::optional<LatticeImage> touching_image(const Life& life, const Rational& t) const;
  bool is_deeper_in(const Life& life, const Rational& depth, const Rational& lo,
                    const Rational& hi) const;
  void settle(const Life& life, Walk& walk) const;
  bool has_mover(const BilliardPair& pair) const;
  void require_mover(const BilliardPair& pair) const;  // for two that touch
  void open(const EntryTime& entry, Walk& walk) const;
  void close(const EntryTime& exit, Walk& walk) const;
  void expire(const BilliardTime& at, Walk& walk) const;
  void finish(Walk& walk) const;
  void miss(const OverlapEpisode& episode, Walk& walk) const;
  Polynomial<Rational> form(const Life& life, const Rational& depth) const;
  Rational rounding(const Life& life) const;

  const Billiard& billiard_;
  Rational horizon_, tolerance_, extent_;
  double tolerance_down_, tolerance_up_;
  bool filters_;
  BilliardGaps<Rational> exact_;
  BilliardGaps<DoubleBall> near_;
  NearImages images_;
};

}  // namespace voroproof::internal
