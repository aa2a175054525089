#include "certify/turn_leader.h"

#include <utility>
#include <variant>

#include "certify/claim_order.h"
#include "certify/exact_turns.h"

namespace voroproof::internal {

namespace {

// Turns that are taken for the next ones when they are claimed. Nothing else is looked at.
class ForeseenTurns final : public ExactTurns {
 public:
  ForeseenTurns(const Parts& of, ComputedMotion& motion, TrueTurns& source, Births births,
                std::vector<TrueTurn>& turns)
      : ExactTurns(of, source, std::move(births)), s_(of.s), motion_(motion), turns_(turns) {}

  using ExactTurns::take_births;
  void collide(const CollideEvent& claim) override {
    const auto m = next_contact(claim.i, claim.j);
    if (!m) throw Undecided("two are said to collide that do not touch", claim.i, claim.j);
    instants().advance(*m);
    add(turn(claim, *m));
    note(claim, turns_.back());
  }
  void maneuver(const ManeuverEvent& claim, std::size_t k) override {
    instants().advance(Moment::at(s_.scene.maneuvers[k].t));
    add(turn(k));
    s_.replay.note_maneuver(k, claim);
  }

 private:
  void add(const TrueTurn& turn) {
    turns_.push_back(turn);
    turns_.back().states = motion_.after(turn.led.i, turn.led.j);
  }

  Setting& s_;
  ComputedMotion& motion_;
  std::vector<TrueTurn>& turns_;
};

}  // namespace

// The parts of a checker that turns need. There is no diagram, and there are no lives.
class TurnLeader::Course {
 public:
  Course(TurnLeader& leader, HistorySource& claims, std::vector<TrueTurn>& turns)
      : leader_(leader),
        s_(leader.scene_, leader.motion_, nullptr, leader.header_, leader.options_,
           std::move(leader.replay_)),
        claims_(claims, s_.tolerance_up, leader.options_.most_near, leader.options_.events, {}),
        refuter_(s_, claims_, front_),
        edges_(s_, front_, refuter_),
        pairs_(s_, front_, refuter_),
        instants_(s_, claims_, front_, refuter_, edges_, pairs_),
        around_(s_, front_, edges_, pairs_),
        claim_order_(s_, claims_, front_, refuter_, edges_, instants_),
        source_(leader.scene_, leader.motion_),
        turns_({s_, claims_, front_, refuter_, pairs_, around_, instants_}, leader.motion_, source_,
               std::move(leader.births_), turns) {
    s_.exact = &turns_;
  }

  void run(std::optional<double> begin) {
    front_.moment = Moment::at(begin.value_or(0));
    refill();
    if (begin) {
      s_.chronology.begin_present();
      ++front_.instant;
    } else {
      while (claim_order_.take_next_at_start()) {
        process();
        refill();
      }
      s_.chronology.note_collisions(front_.moment);
    }
    front_.begun = true;
    while (!claims_.near().empty() || refill()) {
      refill();
      claim_order_.take_next();
      process();
    }
    instants_.leave();
    leader_.replay_ = std::move(s_.replay);
    leader_.births_ = turns_.take_births();
  }

 private:
  bool refill() {
    return claims_.refill([] {});
  }

  // The claim that was taken.
  void process() {
    const Event& claim = *claims_.current();
    if (const auto* c = std::get_if<CollideEvent>(&claim)) {
      turns_.collide(*c);
    } else {
      const auto& m = std::get<ManeuverEvent>(claim);
      const auto k = s_.replay.scheduled(m, exact_time(claim));
      if (!k) throw Undecided("the scene schedules no such maneuver");
      turns_.maneuver(m, *k);
    }
    claims_.done();
  }

  TurnLeader& leader_;
  Setting s_;
  Front front_;
  Claims claims_;
  Refuter refuter_;
  EdgeLives edges_;
  PairLives pairs_;
  Instants instants_;
  CellsAround around_;
  ClaimOrder claim_order_;
  ComputedTurns source_;
  ForeseenTurns turns_;
};

TurnLeader::TurnLeader(const Scene& scene, MotionInput input, const HistoryHeader& header,
                       const CertifyOptions& options)
    : scene_(scene),
      header_(header),
      options_(options),
      motion_(std::move(input), options.motion),
      births_(scene.disks.size()),
      replay_(scene, options_) {
  options_.events = EventKinds::collisions;
}

std::shared_ptr<LedPart> TurnLeader::begin(Part& part) {
  part.replay.take_turns(replay_);
  auto led = std::make_shared<LedPart>();
  led->motion = motion_.snapshot();
  led->facts = motion_.facts();
  led->log = motion_.log();
  led->births = births_;
  return led;
}

bool TurnLeader::lead(const Part& part, HistorySource& claims, std::vector<TrueTurn>& turns) {
  try {
    Course(*this, claims, turns).run(part.begin);
    return true;
  } catch (const Undecided&) {
    return false;
  } catch (const Refuted&) {
    return false;
  }
}

}  // namespace voroproof::internal
