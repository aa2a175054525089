// What a run of certify or of simulate left, taken up by another, and certificates of shards.
#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "apps/run/begun_certificate.h"
#include "apps/run/begun_history.h"
#include "apps/run/history_sink.h"
#include "certify/certifier.h"
#include "exact/tower.h"
#include "filtered/motion/options.h"
#include "history/claim.h"
#include "history/error.h"
#include "kinetic/engine.h"
#include "library/certification.h"
#include "library/explanation.h"
#include "library/maneuver_input.h"
#include "library/shard_file.h"
#include "tests/fuzz/memory_file.h"
#include "tests/fuzz/pieces.h"
#include "tests/fuzz/target.h"
#include "tests/history/temporary_directory.h"

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

class Nobody final : public EventSink {
 public:
  void begin(const std::vector<Quad>&) override {}
  void flip(double, const Quad&) override {}
  void collide(double, GenId, GenId, const RoundedState&, const RoundedState&) override {}
  void maneuver(double, GenId, const RoundedState&) override {}
};

}  // namespace

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
    if (!begun || begun->complete(folder.file("history"))) return;
    EngineOptions options;
    options.motion.max_bits = most_bits;
    int questions = 0;
    options.monitor = [&](double, std::uint64_t) { return ++questions < most_questions; };
    Engine engine(motion_input(scene), maneuver_input(scene), options);
    Nobody nobody;
    try {
      engine.resume([&](EventSink& told) { begun->tell(told); }, to_rational(begun->t0()), nobody);
    } catch (const OtherRun& other) {
      throw InputError("history", 0, "", other.what());
    }
  });
}

}  // namespace voroproof::internal::fuzz
