#include "tests/adversary/judge.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <fstream>
#include <iterator>

#include "certify/evidence/evidence.h"
#include "history/error.h"
#include "history/sha256.h"
#include "tests/certify/claimed_history.h"
#ifdef VOROPROOF_KERNEL
#include "certify/kernel/kernel.h"
#endif

namespace voroproof::internal::adversary {
namespace {

Quad quad(const Edge& q) { return canonical(Quad{q[0], q[1], q[2], q[3]}); }

}  // namespace

testing::ClaimedHistory claimed(const ReadScene& scene, const History& history) {
  testing::ClaimedHistory h;
  h.header.scene_sha256 = scene.scene.sha256;
  h.header.horizon = to_rational(history.horizon);
  h.header.producer = "adversary 1";
  h.header.initial.emplace();
  for (const Edge& q : history.initial) h.header.initial->push_back(quad(q));
  std::sort(h.header.initial->begin(), h.header.initial->end());
  for (const Line& line : history.lines) {
    switch (line.kind) {
      case Line::Kind::flip:
        h.events.emplace_back(FlipEvent{line.t, quad(line.edge), {}});
        break;
      case Line::Kind::maneuver:
        h.events.emplace_back(ManeuverEvent{line.t, line.j, {}, {}, {}});
        if (history.velocities) std::get<ManeuverEvent>(h.events.back()).v = line.v[1];
        if (history.centres) std::get<ManeuverEvent>(h.events.back()).p = line.p[1];
        break;
      case Line::Kind::collide: {
        CollideEvent e{.t = line.t, .i = line.i, .j = line.j};
        if (history.velocities) {
          e.v[1] = line.v[1];
          if (line.i >= 0) e.v[0] = line.v[0];
        }
        if (history.centres) {
          e.p[1] = line.p[1];
          if (line.i >= 0) e.p[0] = line.p[0];
        }
        h.events.emplace_back(e);
        break;
      }
    }
  }
  h.count();
  return h;
}

namespace {

// With CGAL's word on the witness: where that contradicts, the certifier has failed.
Answer refuted(const Divergence& d) {
  const EvidenceCheck evidence = check_evidence(d);
  if (evidence.evidence == Evidence::contradicted) return {Verdict::failed, evidence.sentence};
  return {Verdict::refuted,
          std::string(fault_names[static_cast<std::size_t>(d.fault)]) + ", line " +
              std::to_string(d.line) + ": " + d.truth,
          d.true_time ? std::optional(d.true_time->at(1)) : std::nullopt};
}

Answer ask_certifier(const Scene& scene, const testing::ClaimedHistory& history, Truth truth,
                     const Asking& asking) {
  CertifyOptions options;
  options.tolerance = asking.tolerance;
  options.motion.max_bits = asking.bits;
  options.motion.max_radicals = 2;
  options.truth = truth == Truth::exact ? voroproof::internal::Truth::exact
                                        : voroproof::internal::Truth::recorded;
  try {
    const Certificate c = testing::certify(scene, history, options);
    switch (c.verdict) {
      case voroproof::internal::Verdict::certified:
        return {Verdict::certified, {}};
      case voroproof::internal::Verdict::refuted:
        return refuted(*c.divergence);
      case voroproof::internal::Verdict::undecided:
        return {Verdict::undecided, c.reason};
    }
  } catch (const InputError& error) {
    return {Verdict::invalid, error.what()};
  } catch (const std::exception& error) {
    return {Verdict::failed, error.what()};
  }
  return {};
}

#ifdef VOROPROOF_KERNEL
Answer ask_kernel(const std::string& scene, const std::string& history, Truth truth,
                  const Rational& tolerance) {
  namespace k = voroproof_kernel;
  k::Options options;
  options.tolerance = tolerance.get_str();
  options.truth = truth == Truth::exact ? k::Truth::exact : k::Truth::recorded;
  try {
    const k::Result r = k::check(scene, history, options);
    const Verdict v = r.verdict == k::Verdict::certified   ? Verdict::certified
                      : r.verdict == k::Verdict::refuted   ? Verdict::refuted
                      : r.verdict == k::Verdict::undecided ? Verdict::undecided
                                                           : Verdict::invalid;
    return {v, r.reason};
  } catch (const std::exception& error) {
    return {Verdict::failed, error.what()};
  }
}
#else
Answer ask_kernel(const std::string&, const std::string&, Truth, const Rational&) { return {}; }
#endif

}  // namespace

Find find_of(const Judgement& j) {
  const Verdict c = j.certifier.verdict, k = j.kernel.verdict;
  if (c == Verdict::failed || k == Verdict::failed) return Find::failure;
  if (k != Verdict::absent && (c == Verdict::invalid) != (k == Verdict::invalid)) {
    return Find::failure;
  }
  if (j.opinion && j.opinion->finding == Finding::wrong) {
    if (c == Verdict::certified) return Find::certifier_lax;
    if (k == Verdict::certified) return Find::kernel_lax;
  }
  if (j.opinion && j.opinion->finding == Finding::right) {
    if (c == Verdict::refuted) return Find::certifier_strict;
    if (k == Verdict::refuted) return Find::kernel_strict;
  }
  const bool opposed = (c == Verdict::certified && k == Verdict::refuted) ||
                       (c == Verdict::refuted && k == Verdict::certified);
  return opposed ? Find::disagreement : Find::none;
}

std::optional<ReadScene> read(const SceneData& scene) {
  ReadScene r{scene_text(scene), {}};
  try {
    r.scene = parse_scene(r.text, "scene");
  } catch (const InputError&) {
    return std::nullopt;
  }
  return r;
}

Rational tolerance_in(const Units& units) {
  Rational scaled(1, 1000000);
  if (units.time < 0) {
    scaled >>= static_cast<mp_bitcnt_t>(-units.time);
  } else {
    scaled <<= static_cast<mp_bitcnt_t>(units.time);
  }
  return scaled;
}

Judgement judge(const ReadScene& scene, const History& history, Truth truth, const Asking& asking) {
  Judgement j;
  j.certifier = ask_certifier(scene.scene, claimed(scene, history), truth, asking);
  if (asking.with_kernel) {
    const auto text = history_text(history, scene.scene.sha256, asking.long_decimals);
    j.kernel = ask_kernel(scene.text, text, truth, asking.tolerance);
  }
  return j;
}

Judgement judge_files(const std::string& scene_path, const std::string& history_path, Truth truth,
                      const Asking& asking) {
  const auto text = [](const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    return std::string{std::istreambuf_iterator<char>(in), {}};
  };
  Judgement j;
  try {
    const Scene scene = read_scene(scene_path);
    const auto history = testing::read_claimed_history(history_path, scene);
    j.certifier = history ? ask_certifier(scene, *history, truth, asking)
                          : Answer{Verdict::invalid, "not a complete history"};
  } catch (const InputError& error) {
    j.certifier = {Verdict::invalid, error.what()};
  }
  j.kernel = ask_kernel(text(scene_path), text(history_path), truth, asking.tolerance);
  return j;
}

void ask_oracle(Judgement& j, const SceneData& scene, const History& history, Truth truth,
                const std::vector<double>& hints) {
  std::vector<double> looks = hints;
  if (j.certifier.when) {
    // What is said to be missing may be undone soon after.
    for (const double later : {1e-13, 1e-11, 1e-9, 1e-7}) {
      looks.push_back(*j.certifier.when + later * (1 + *j.certifier.when));
    }
  }
  j.opinion = truth == Truth::exact ? judge_exact(scene, history, looks)
                                    : judge_recorded(scene, history, looks);
  for (const Line& line : history.lines) {
    const bool hidden = j.certifier.when && std::abs(line.t - *j.certifier.when) <= 2.1 * tolerance;
    if (hidden && j.opinion->finding == Finding::right) {
      j.opinion = {Finding::unclear, "what is said to be missing is too near to a claim"};
    }
  }
}

}  // namespace voroproof::internal::adversary
