#include "voroproof/queries.h"

#include <stdexcept>

#include "library/true_moment.h"
#include "library/values.h"
#include "queries/nearest.h"

namespace voroproof {

struct Instant::Implementation {
  internal::Rational t;
  internal::TrueMoment moment;
  internal::TierCounts counts{};

  internal::Clearance clearance() {
    return internal::Clearance(moment.motion, t, moment.diagram, 0, counts);
  }
};

namespace {

using internal::enclosure_value;
using internal::with_public_errors;

ClosestPairs value_of(const internal::ClosestPairs& closest) {
  return {closest.pairs, enclosure_value(closest.gap)};
}

}  // namespace

Instant::Instant(const Scene& scene, const Number& t, int max_bits) {
  with_public_errors([&] {
    const internal::Rational at = internal::instant(t);
    implementation_ = std::make_unique<Implementation>(
        Implementation{at, internal::true_moment(internal::checked_scene(scene), {}, at,
                                                 internal::engine_options(max_bits))});
  });
}
Instant::Instant(Instant&&) noexcept = default;
Instant& Instant::operator=(Instant&&) noexcept = default;
Instant::~Instant() = default;

std::vector<NearDisk> Instant::nearest(const Number& x, const Number& y, std::size_t count) {
  return with_public_errors([&] {
    std::vector<NearDisk> out;
    for (const auto& near : internal::nearest_disks(
             implementation_->moment.motion, implementation_->t,
             {internal::rational(x), internal::rational(y)}, count, implementation_->counts)) {
      out.push_back({near.disk, enclosure_value(near.distance), near.tied});
    }
    return out;
  });
}

std::vector<Neighbour> Instant::neighbours(int disk) {
  if (disk < 0 || disk >= implementation_->moment.motion.size()) {
    throw std::invalid_argument("disk: there is no disk " + std::to_string(disk));
  }
  return with_public_errors([&] {
    internal::Clearance clearance = implementation_->clearance();
    std::vector<Neighbour> out;
    for (const auto& n : internal::neighbours(clearance, disk)) {
      out.push_back({n.generator, n.edges, enclosure_value(n.gap)});
    }
    return out;
  });
}

ClosestPairs Instant::closest_generators() {
  return with_public_errors([&] {
    internal::Clearance clearance = implementation_->clearance();
    return value_of(internal::closest_generators(clearance));
  });
}

ClosestPairs Instant::closest_disks() {
  return with_public_errors([&] {
    internal::Clearance clearance = implementation_->clearance();
    return value_of(internal::closest_disks(clearance));
  });
}

}  // namespace voroproof
