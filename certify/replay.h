// The state that a history's claims lead to when they are taken at their word: the diagram, and
// what has happened to the disks. Under the recorded truth that is all of the motion.
#pragma once

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "certify/collision_law.h"
#include "certify/options.h"
#include "certify/path.h"
#include "certify/shard.h"
#include "exact/prefetch.h"
#include "exact/topology/diagram.h"
#include "filtered/motion/given_motion.h"

namespace voroproof::internal {

class JsonReader;

class Replay : public GivenStates {
 public:
  using HalfEdge = Diagram::HalfEdge;

  // The place of a claim in the diagram: the half-edge that flips; or the disks that turn, by the
  // first of them and some half-edge that starts at the last.
  struct Place {
    static constexpr GenId kNone = container_id - 1;
    HalfEdge half = -1;   // -1: there is none
    GenId turns = kNone;  // kNone: none turns

    bool is_none() const { return half < 0 && turns == kNone; }
  };

  // The replay at t = 0, before the diagram is known. `scene` and `options` outlive it and its
  // copies.
  Replay(const Scene& scene, const CertifyOptions& options);

  int disks() const { return static_cast<int>(scene_->disks.size()); }

  // ---- The diagram. ----
  Diagram& diagram() { return diagram_; }
  const Diagram& diagram() const { return diagram_; }
  // The half-edge with this quadruplet, or -1.
  HalfEdge find(const Quad& q) const;
  // The half-edge with this quadruplet, its two third generators exchanged, or -1.
  HalfEdge find_mirrored(const Quad& q) const;
  // A V-edge between the two, or -1. With one disk there is one edge, 0, without incidences.
  int adjacency(GenId i, GenId j) const;
  // The generators on both sides of a V-edge, the smaller first.
  std::pair<GenId, GenId> pair_of(int edge) const {
    if (diagram_.edges() == 0) return {container_id, 0};
    const GenId i = diagram_.org(2 * edge), j = diagram_.dest(2 * edge);
    return {std::min(i, j), std::max(i, j)};
  }

  // ---- The disks. ----
  // The velocity as last claimed, or computed where the claim gives none.
  const Velocity& velocity(GenId g) const { return velocities_[g]; }
  // Both velocities; zero for the container.
  ExactPair velocities(GenId i, GenId j) const;
  BallPair near_velocities(GenId i, GenId j) const;
  // Recorded truth: the path of the disk, on its present line.
  const Path& path(GenId g) const { return paths_[g]; }
  // Recorded truth: where the two are at that time; zero for the container.
  ExactPair positions(GenId i, GenId j, const Rational& t) const;
  // Where the two are at the time of the claim, enclosed; zero for the container.
  BallPair near_positions(const CollideEvent& claim) const;
  // Whether the motion of the disk has ever changed.
  bool moved(GenId g) const { return turns_[g + 1].last != 0; }
  // How many changes of the motion there have been, and whether the one of g was not after so many.
  int changes() const { return changes_; }
  bool unchanged_since(GenId g, int changes) const { return turns_[g + 1].last <= changes; }
  // Whether the last thing that happened to both disks was their own collision.
  bool partners(GenId i, GenId j) const {
    return i != container_id && moved(i) && turns_[i + 1].last == turns_[j + 1].last;
  }
  // Whether the last thing that happened to the disk was a collision with the container.
  bool hit_container(GenId g) const { return turns_[g + 1].at_container; }
  // How many claims have moved the generator so far; 0 for the container.
  int turns(GenId g) const { return turns_[g + 1].count; }

  // The collision has happened; `computed` are the velocities where the claim gives none, and are
  // there if it does not.
  void note_collision(const CollideEvent& claim, const std::optional<ExactPair>& computed);
  // Recorded truth: from the time of the claim on, the disk goes on with its velocity.
  void turn(GenId g, const Event& claim);
  // Recorded truth: gives `motion`, the scene's, the present line of the disk, and of all disks.
  // This replay must be at hand as long as the motion.
  void move(GivenMotion& motion, GenId g) const;
  void move(GivenMotion& motion) const;
  void state(GenId g, DiskInput& disk) const override;
  // Recorded truth, for a claim without velocities: by the law with the centres that it gives, else
  // with those of the paths; rounded to binary64. Throws Undecided, as CollisionLaw does.
  ExactPair computed_velocities(const CollideEvent& claim, const ExactPair& path) const;
  // The centres that the claim gives, else those of the paths.
  static ExactPair recorded_centers(const CollideEvent& claim, ExactPair path);

  // ---- Maneuvers, by their index in the scene. ----
  // Which one is claimed: in any order among those of one instant.
  std::optional<std::size_t> scheduled(const ManeuverEvent& claim, const Rational& t) const;
  bool maneuver_done(std::size_t k) const {
    return k < next_maneuver_ || done_maneuvers_.contains(k);
  }
  // The first that has not been claimed; their number where all have.
  std::size_t next_maneuver() const { return next_maneuver_; }
  void note_maneuver(std::size_t k, const ManeuverEvent& claim);

  // Takes the claim for true; under the exact truth only of a flip. No place where it makes no
  // sense on what is known.
  Place take(const Event& event);
  // Exact truth: has the turns of the other, of before the same claim.
  void take_turns(const Replay& other);
  // Recorded truth: all that this replay knows, and that what comes after it depends on.
  void add_to(Fingerprint& fingerprint) const;
  // Recorded truth: becomes what the text of an index says (docs/formats.md, section 19). Throws
  // InputError where it is none of this scene, or has not the hash that the cut names.
  void read(const IndexedCut& at);
  // The place of the claim, as far as the present diagram tells.
  Place place_of(const Event& event) const;
  // Asks for the memory where take() will begin: of a flip, to look for the edge.
  void prefetch(const Event& event) const;
  // Asks for the memory of a disk's path, velocity and turns.
  [[gnu::always_inline]] void prefetch(GenId g) const {
    if (g < 0) return;
    internal::prefetch(&paths_[g]);
    internal::prefetch(&velocities_[g]);
    prefetch_turns(g);
  }
  // Asks for the memory of what is known of its turns.
  [[gnu::always_inline]] void prefetch_turns(GenId g) const { internal::prefetch(&turns_[g + 1]); }

 private:
  friend class ReplayWriter;
  // The half-edge that has flipped, or -1.
  HalfEdge flip(const FlipEvent& claim);
  // The disk has turned with the last change.
  void note_turn(GenId g, bool at_container) {
    Turns& turns = turns_[g + 1];
    turns = {changes_, turns.count + 1, at_container};
  }
  void read_text(JsonReader& json);
  void read_disk(JsonReader& json, std::size_t g);

  const Scene* scene_;
  const CertifyOptions* options_;
  Diagram diagram_;
  std::vector<Velocity> velocities_;
  std::vector<Path> paths_;  // under the recorded truth
  int changes_ = 0;
  struct Turns {
    int last = 0;  // which of all changes of motion it was; 0 for none
    int count = 0;
    bool at_container = false;  // the last of them
  };
  std::vector<Turns> turns_;  // by generator, the container first
  std::size_t next_maneuver_ = 0;
  std::set<std::size_t> done_maneuvers_;  // done, though past next_maneuver_
};

}  // namespace voroproof::internal
