// Many histories, right and wrong, judged and counted; a function of the seeds.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tests/adversary/families.h"
#include "tests/adversary/faults.h"
#include "tests/adversary/judge.h"
#include "tests/adversary/rewrite.h"

namespace voroproof::internal::adversary {

// All that makes one history.
struct Recipe {
  std::uint64_t seed = 0;
  Family family = Family::generic;
  Fault fault{};
  Rewriting rewriting = Rewriting::none;
  bool fuzzed = false;
  bool centres = true, velocities = true;  // whether lines give p and v
  bool by_engine = false;  // the project's own engine writes it: right, also where ties last
  bool long_decimals = false;
  Units units{};  // in which certifier and kernel get it; the oracle knows the usual ones only
};

// The history of a recipe, and the scene with the horizon that it has.
struct Made {
  Recipe recipe;
  SceneData scene;
  History history;
  std::vector<double> hints;
  bool struck = false;
};

// What the seed asks for; family and fault as given, where they are.
Recipe recipe_of(std::uint64_t seed, std::optional<Family> family, std::optional<FaultKind> fault);

// Any that the range of values has room for, often where doubles of doubles underflow.
Units random_units(Random& random);

// Nothing where no scene comes about, or the fault finds no place in it.
std::optional<Made> make(const Recipe& recipe);

// The scene in the recipe's units; nothing where the reader refuses it.
std::optional<ReadScene> read(const Made& made);

// Makes the recipe with another scene.
std::optional<Made> make(const Recipe& recipe, SceneData scene);

// The kind that a history is counted as: its fault, or "rewritten", "fuzzed".
std::string kind_of(const Recipe& recipe);

struct Count {
  std::int64_t made = 0;
  std::array<std::int64_t, 6> certifier{}, kernel{};  // by verdict
  std::int64_t oracle_right = 0, oracle_wrong = 0, oracle_unclear = 0;
  std::array<std::int64_t, static_cast<std::size_t>(Find::count)> finds{};
};

class Campaign {
 public:
  // With `all` the oracle judges all histories, else those not refuted and those meant right. The
  // kernel, which takes most of the time, is asked of one seed in `kernel_every`.
  explicit Campaign(bool all, std::uint64_t kernel_every = 1)
      : all_(all), kernel_every_(kernel_every) {}

  // Judges what the seed makes under both truths, and tells of each.
  void run(std::uint64_t seed, std::optional<Family> family, std::optional<FaultKind> fault,
           const std::function<void(const Made&, Truth, const Judgement&)>& judged);

  // The counts by kind and truth, and by family and truth.
  const std::map<std::pair<std::string, int>, Count>& by_kind() const { return by_kind_; }
  const std::map<std::pair<std::string, int>, Count>& by_family() const { return by_family_; }
  const std::map<std::string, std::int64_t>& undecided() const { return undecided_; }
  std::int64_t histories() const { return histories_; }
  double seconds_making() const { return seconds_[0]; }
  double seconds_judging() const { return seconds_[1]; }

 private:
  bool all_;
  std::uint64_t kernel_every_;
  std::int64_t histories_ = 0;
  std::array<double, 2> seconds_{};
  std::map<std::pair<std::string, int>, Count> by_kind_, by_family_;
  std::map<std::string, std::int64_t> undecided_;
};

// Judges a history as a campaign does.
Judgement judge_all(const ReadScene& scene, const Made& made, Truth truth, bool always_oracle,
                    bool with_kernel);

// A smaller recipe's history that is still this find, if there is one.
Made minimized(const Made& made, Truth truth, Find find);

}  // namespace voroproof::internal::adversary
