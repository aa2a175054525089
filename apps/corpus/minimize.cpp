#include "apps/corpus/minimize.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <optional>
#include <sstream>
#include <utility>

#include "apps/corpus/scratch_folder.h"
#include "exact/ball.h"
#include "history/error.h"
#include "history/scene_writer.h"

namespace voroproof::internal {
namespace {

std::string text_of(const Scene& scene) {
  std::ostringstream text;
  write_scene(text, scene);
  return text.str();
}

// Whether such a scene may be: its disks apart and in the container, and so on.
bool is_valid(const Scene& scene) {
  try {
    parse_scene(text_of(scene), "");
    return true;
  } catch (const InputError&) {
    return false;
  }
}

Mistake mistake_of(const ProgramResult& result) {
  Mistake mistake{result.outcome, {}, 0, result.reason};
  const CaseJudgement* judgement = result.decisive();
  if (judgement && judgement->verdict == CaseJudgement::Verdict::refuted) {
    mistake.kind = judgement->kind;
    mistake.t = judgement->t;
  }
  return mistake;
}

// Extensions belong to disks and maneuvers by their numbers.
void forget_extensions(Scene& scene) {
  scene.disk_extensions.clear();
  scene.maneuver_extensions.clear();
}

void erase_maneuvers(Scene& scene, std::size_t first, std::size_t count) {
  forget_extensions(scene);
  const auto from = scene.maneuvers.begin() + static_cast<std::ptrdiff_t>(first);
  scene.maneuvers.erase(from, from + static_cast<std::ptrdiff_t>(count));
}

void erase_disks(Scene& scene, std::size_t first, std::size_t count) {
  forget_extensions(scene);
  const auto from = scene.disks.begin() + static_cast<std::ptrdiff_t>(first);
  scene.disks.erase(from, from + static_cast<std::ptrdiff_t>(count));
  std::erase_if(scene.maneuvers, [&](const Maneuver& m) {
    const auto disk = static_cast<std::size_t>(m.disk);
    return first <= disk && disk < first + count;
  });
  for (Maneuver& m : scene.maneuvers) {
    if (static_cast<std::size_t>(m.disk) >= first) m.disk -= static_cast<int>(count);
  }
}

// x rounded to nearest to so many bits.
Rational with_bits(const Rational& x, int bits) { return Ball(x, bits).midpoint(); }

// A number of about so many bits that is larger than x > 0.
Rational above(const Rational& x, int bits) {
  return with_bits(x + x / Rational(Integer(1) << (bits - 1)), bits);
}

// A number of a disk; a mass that follows from the radius keeps to it.
using Field = CompactRational DiskInput::*;
constexpr std::array<Field, 5> fields{&DiskInput::x, &DiskInput::y, &DiskInput::radius,
                                      &DiskInput::vx, &DiskInput::vy};

void set(DiskInput& disk, Field field, const Rational& value) {
  const Rational radius = disk.radius.value();
  const bool follows = disk.mass.value() == radius * radius;
  disk.*field = value;
  if (follows) disk.mass = Rational(disk.radius.value() * disk.radius.value());
}

}  // namespace

Minimization::Minimization(Scene scene, const CorpusRunOptions& options)
    : scene_(std::move(scene)), options_(options) {
  mistake_ = judge({scene_})[0];
}

std::vector<Mistake> Minimization::judge(const std::vector<Scene>& scenes) {
  const ScratchFolder scratch;
  std::vector<CorpusCase> cases;
  for (const Scene& scene : scenes) {
    CorpusCase& c = cases.emplace_back();
    c.folder = scratch.folder(cases.size());
    std::ofstream(c.scene(), std::ios::binary) << text_of(scene);
  }
  runs_ += cases.size();
  std::vector<Mistake> mistakes;
  for (const ProgramResult& result : against_program(cases, options_)) {
    mistakes.push_back(mistake_of(result));
  }
  return mistakes;
}

// Takes the first of the changes after which the mistake is still made; as many are tried at a time
// as run side by side.
bool Minimization::take(const std::vector<Change>& changes) {
  for (std::size_t k = 0; k < changes.size();) {
    std::vector<Scene> scenes;
    for (; k < changes.size() && scenes.size() < options_.jobs; ++k) {
      Scene changed = scene_;
      changes[k](changed);
      if (is_valid(changed)) scenes.push_back(std::move(changed));
    }
    if (scenes.empty()) continue;
    const std::vector<Mistake> mistakes = judge(scenes);
    for (std::size_t i = 0; i < scenes.size(); ++i) {
      if (!mistakes[i].is_like(mistake_)) continue;
      scene_ = std::move(scenes[i]);
      mistake_ = mistakes[i];
      return true;
    }
  }
  return false;
}

// To just after the divergence, or to less where there is none.
bool Minimization::shorten() {
  std::vector<Change> changes;
  const auto to = [&](const Rational& horizon) {
    if (horizon >= scene_.horizon) return;
    changes.emplace_back([horizon](Scene& scene) {
      scene.horizon = horizon;
      std::erase_if(scene.maneuvers, [&](const Maneuver& m) { return m.t > horizon; });
      forget_extensions(scene);
    });
  };
  if (mistake_.outcome == CaseOutcome::refuted) {
    for (const int bits : {2, 4, 8, 16}) to(above(to_rational(mistake_.t), bits));
  } else {
    to(0);
    for (const int part : {16, 4, 2}) to(with_bits(scene_.horizon / part, 4));
  }
  return take(changes);
}

// Erases parts of a list of so many, first all of it, then halves, and so on.
bool Minimization::drop(const std::function<std::size_t(const Scene&)>& size, Erase erase) {
  bool any = false;
  for (std::size_t part = size(scene_); part > 0;) {
    std::vector<Change> changes;
    for (std::size_t k = 0; k + part <= size(scene_); k += part) {
      changes.emplace_back([=](Scene& scene) { erase(scene, k, part); });
    }
    if (take(changes)) {
      any = true;
    } else {
      part /= 2;
    }
  }
  return any;
}

bool Minimization::simplify_numbers() {
  bool any = false;
  for (std::size_t k = 0; k < scene_.disks.size(); ++k) {
    for (const Field field : fields) {
      const Rational value = (scene_.disks[k].*field).value();
      std::vector<Change> changes;
      const auto to = [&](const Rational& simpler) {
        if (simpler == value) return false;
        changes.emplace_back([k, field, simpler](Scene& s) { set(s.disks[k], field, simpler); });
        return true;
      };
      bool differs = to(0);
      for (int bits = 2; differs && bits <= 16; bits *= 2) differs = to(with_bits(value, bits));
      any = take(changes) || any;
    }
  }
  std::vector<Change> rounder;
  for (const int bits : {2, 4, 8}) {
    if (with_bits(scene_.container_radius, bits) == scene_.container_radius) break;
    const Rational radius = above(scene_.container_radius, bits);
    rounder.emplace_back([radius](Scene& s) { s.container_radius = radius; });
  }
  return take(rounder) || any;
}

void Minimization::run() {
  // It says how the whole scene was made.
  scene_.comment.clear();
  scene_.seed.reset();
  bool smaller = true;
  while (smaller) {
    smaller = shorten();
    smaller = drop([](const Scene& s) { return s.disks.size(); }, erase_disks) || smaller;
    smaller = drop([](const Scene& s) { return s.maneuvers.size(); }, erase_maneuvers) || smaller;
    if (!smaller) smaller = simplify_numbers();
  }
}

}  // namespace voroproof::internal
