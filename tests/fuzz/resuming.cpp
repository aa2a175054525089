// What a run of certify or of simulate left, taken up by another; certificates of shards; an index.
#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "apps/run/begun_certificate.h"
#include "apps/run/begun_history.h"
#include "apps/run/history_sink.h"
#include "certify/certifier.h"
#include "engine/engine.h"
#include "exact/tower.h"
#include "filtered/motion/options.h"
#include "history/claim.h"
#include "history/error.h"
#include "history/history_writer.h"
#include "library/certification.h"
#include "library/explanation.h"
#include "library/history_index.h"
#include "library/maneuver_input.h"
#include "library/shard_file.h"
#include "library/snapshot.h"
#include "tests/fuzz/memory_file.h"
#include "tests/fuzz/pieces.h"
#include "tests/fuzz/target.h"
#include "tests/history/temporary_directory.h"
#include "tests/library/index_entry.h"

namespace voroproof::internal::fuzz {
namespace {

// As the seeds name it.
constexpr const char* this_program = "voroproof " VOROPROOF_VERSION;

constexpr int most_bits = 512;
constexpr int most_disks = 12;
constexpr int most_lines = 400;
constexpr int most_questions = 200;  // of the engine, whether to go on
constexpr std::size_t most_shards_joined = 4;

// Runs it; whether it was not refused.
template <class Run>
bool accepts(Run&& run) {
  try {
    run();
    return true;
  } catch (const InputError&) {
  } catch (const OtherHistory&) {
  } catch (const Undecided&) {
  } catch (const BudgetExceeded&) {
  }
  return false;
}

bool is_small(const Scene& scene, const std::string& history) {
  return scene.disks.size() <= most_disks &&
         std::count(history.begin(), history.end(), '\n') <= most_lines;
}

// As the verb ends.
void tell(const ShardFile& file) {
  explain_report_text(report_text(file.run, file.options, file.shard.certificate), "report");
}

// A scene and its history, of more than one part.
class Simulated {
 public:
  Simulated() {
    const Scene scene = read_scene(VOROPROOF_SHARDS_SCENE);
    HistoryWriter writer(history());
    HistorySink sink(writer,
                     {.scene_sha256 = scene.sha256,
                      .horizon = scene.horizon,
                      .producer = this_program,
                      .initial = {}},
                     static_cast<int>(scene.disks.size()));
    Engine engine(motion_input(scene), maneuver_input(scene), {});
    engine.run(sink);
    writer.end();
    writer.close();
  }

  std::string scene() const { return VOROPROOF_SHARDS_SCENE; }
  std::string history() const { return folder_.file("history"); }
  const TemporaryDirectory& folder() const { return folder_; }

 private:
  TemporaryDirectory folder_;
};

// Certifies the history of the scene up to its second part, and keeps what there is to go on with.
class BegunShard {
 public:
  explicit BegunShard(const Simulated& simulated) {
    options_.truth = Truth::recorded;
    options_.propose_initial = construct_initial;
    ShardTask task;
    task.is_due = [this] { return !begun_; };
    task.proved = [this](Shard so_far) { begun_ = std::move(so_far); };
    const Claim claim = open_claim(simulated.scene(), simulated.history());
    whole_ = certify_shard(claim.scene, *claim.history, options_, task).certificate;
    if (!begun_ || !begun_->end) throw std::logic_error("the history has no second part");
  }

  const CertifyOptions& options() const { return options_; }
  const Cut& end() const { return *begun_->end; }

  // Throws std::logic_error where what comes next does not lead to the certificate of the whole.
  void require_whole(Shard next, const CertificationRun& run) const {
    Shard joined = *begun_;
    append(joined, std::move(next));
    if (report_text(run, options_, joined.certificate) != report_text(run, options_, whole_)) {
      throw std::logic_error("with an index the report is another");
    }
  }

 private:
  CertifyOptions options_;
  std::optional<Shard> begun_;
  Certificate whole_;
};

// Gives each entry of an index the hash of its own state: else none that was changed would be
// looked at. What is no index, and what has no such state, stays as it is.
std::string with_hashes_of_states(std::string_view bytes, const Scene& scene,
                                  const CertifyOptions& options) {
  std::istringstream in{std::string(bytes)};
  std::string text;
  for (std::string line; std::getline(in, line); text += line + '\n') {
    nlohmann::ordered_json entry = nlohmann::ordered_json::parse(line, nullptr, false);
    if (!entry.is_object()) continue;
    try {
      entry = testing::with_hash_of_state(entry, scene, options);
    } catch (const nlohmann::json::exception&) {
      continue;
    } catch (const InputError&) {
      continue;
    }
    line = entry.dump();
  }
  return text;
}

}  // namespace

bool reads_index(std::string_view bytes) {
  static const Simulated simulated;
  static const BegunShard begun(simulated);
  const Claim claim = open_claim(simulated.scene(), simulated.history());
  const IndexFile index{
      .path = file_with(with_hashes_of_states(bytes, claim.scene, begun.options())),
      .producer = this_program};
  accepts([&] {
    snapshot(claim.scene, simulated.history(), to_rational(begun.end().t) + 2, {},
             {.index = index});
  });
  return accepts([&] {
    ShardTask task{.from = begun.end()};
    task.start = find_start(index, claim, simulated.history(), begun.options(), task);
    Shard next = certify_shard(claim.scene, *claim.history, begun.options(), task);
    begun.require_whole(std::move(next),
                        certification_run(this_program, "scene", "history", claim, {}));
    if (!task.start) throw InputError(index.path, 0, "", "no entry is of use");
  });
}

bool reads_shard(std::string_view bytes) {
  return accepts([&] {
    const std::string text = shard_text(read_shard(file_with(bytes)));
    if (shard_text(read_shard(file_with(text))) != text) {
      throw std::logic_error("a certificate of a shard is not the same when it is read again");
    }
  });
}

bool merges(std::string_view bytes) {
  static const TemporaryDirectory folder;
  std::vector<std::string> paths;
  for (const std::string& piece : pieces_of(bytes, most_shards_joined)) {
    if (!piece.empty()) {
      paths.push_back(folder.write("shard" + std::to_string(paths.size()), piece));
    }
  }
  if (paths.empty()) return false;
  return accepts([&] { tell(merge_shards(paths)); });
}

bool resumes_certificate(std::string_view bytes) {
  static const Simulated simulated;
  return accepts([&] {
    const Claim claim = open_claim(simulated.scene(), simulated.history());
    ShardFile file;
    file.options.truth = Truth::recorded;
    file.options.propose_initial = construct_initial;
    file.run = certification_run(this_program, "scene", "history", claim, {});
    const std::string report = simulated.folder().file("report");
    simulated.folder().write("report.partial", std::string(bytes));
    std::optional<Shard> left = BegunCertificate(report).find(file);
    if (!left) throw std::logic_error("what is there was not found");
    const ShardTask task{.from = left->end};
    file.shard = *std::move(left);
    append(file.shard, certify_shard(claim.scene, *claim.history, file.options, task));
    tell(file);
    if (file.shard.certificate.verdict == Verdict::refuted) {
      throw std::logic_error("a right history is refuted");
    }
  });
}

bool resumes_history(std::string_view bytes) {
  static const TemporaryDirectory folder;
  std::vector<std::string> pieces = pieces_of(bytes, 2);
  name_scene(pieces[1], pieces[0]);
  return accepts([&] {
    const Scene scene = parse_scene(pieces[0], "scene");
    if (!is_small(scene, pieces[1])) return;
    const HistoryHeader wanted{.scene_sha256 = scene.sha256,
                               .horizon = scene.horizon,
                               .producer = this_program,
                               .initial = {}};
    const auto begun = BegunHistory::find(folder.write("history", pieces[1]), wanted,
                                          static_cast<int>(scene.disks.size()));
    if (!begun || begun->complete()) return;
    EngineOptions options;
    options.motion.max_bits = most_bits;
    int questions = 0;
    options.monitor = [&](double, std::uint64_t) { return ++questions < most_questions; };
    Engine engine(motion_input(scene), maneuver_input(scene), options);
    NoSink sink;
    try {
      engine.resume(
          begun->kept().run, [&](EventSink& told) { begun->tell(told); }, sink);
    } catch (const OtherRun& other) {
      throw InputError("history", 0, "", other.what());
    }
  });
}

}  // namespace voroproof::internal::fuzz
