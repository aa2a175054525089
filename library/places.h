// Where the generators are at one instant, as precisely as it takes to round what follows from it.
#pragma once

#include <memory>
#include <vector>

#include "engine/engine.h"
#include "history/scene.h"
#include "library/illegal_edge.h"
#include "library/queries/recorded_moment.h"

namespace voroproof::internal {

class Places {
 public:
  // By the motion of the engine, which has been run to t.
  Places(std::shared_ptr<Engine> engine, const Rational& t);
  // Generators at rest, the container first.
  explicit Places(std::vector<MovingSite<Rational>> sites);
  // On the lines on which a history puts the disks.
  Places(const Scene& scene, const std::vector<RecordedState>& states, const Rational& t);

  // Enclosures of at least 160 bits where the motion is known as well.
  const PlacedGenerators& near() const { return near_; }

  // Binary64 numbers nearest to the values, ties to even: by the enclosures, else by exact
  // arithmetic, else by the motion computed with more bits.
  struct Rounded {
    Vec2 center, velocity;
    double radius = 0;
  };
  // Centre, velocity and signed radius of a generator. Throws Undecided where the budgets do not
  // tell what is nearest.
  Rounded generator(GenId g);
  // Centre and radius of the circle of a vertex. Throws likewise.
  Rounded circle(const Triple& vertex);

 private:
  template <class Near, class Exact>
  std::vector<double> rounded(const Near& near, const Exact& exact);
  template <class Exact>
  std::vector<double> exactly(const Exact& exact) const;
  void place();

  std::shared_ptr<Engine> engine_;  // null on the lines of a history
  std::vector<MovingSite<Rational>> lines_;
  std::vector<double> since_;
  Rational t_;
  int bits_ = 160;
  PlacedGenerators near_;
};

}  // namespace voroproof::internal
