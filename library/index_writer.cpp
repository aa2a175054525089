#include <utility>

#include "certify/fingerprint.h"
#include "certify/part_reader.h"
#include "history/byte_source.h"
#include "history/error.h"
#include "history/json_text.h"
#include "history/output_file.h"
#include "history/scene_motion.h"
#include "library/certification.h"
#include "library/history_index.h"
#include "library/index_format.h"
#include "library/replay_writer.h"

namespace voroproof::internal {
namespace {

// The history between two entries is so many times longer than the first of them, at least.
constexpr std::int64_t kRatio = 20;

// Whether the claim says how the disks that it turns go on.
bool tells_velocities(const Event& event) {
  if (const auto* c = std::get_if<CollideEvent>(&event)) return c->v[1].has_value();
  const auto* m = std::get_if<ManeuverEvent>(&event);
  return m == nullptr || m->v.has_value();
}

std::string cut_text(const Cut& cut, const std::string& digest) {
  const auto count = [](std::int64_t x) { return std::to_string(x); };
  return "{\"part\":" + count(cut.part) + ",\"t\":" + number_text(cut.t) +
         ",\"flips\":" + count(cut.claims.flips) +
         ",\"collisions\":" + count(cut.claims.collisions) +
         ",\"maneuvers\":" + count(cut.claims.maneuvers) + ",\"line\":" + count(cut.line) +
         ",\"offset\":" + count(cut.offset) + ",\"digest\":\"" + digest + "\",\"state_sha256\":\"" +
         cut.state_sha256 + "\"}";
}

class IndexWriter {
 public:
  IndexWriter(const std::string& path, const std::string& history_path)
      : history_path_(history_path),
        bytes_(static_cast<std::int64_t>(ByteSource(history_path).known_size())),
        file_(path) {
    if (bytes_ == 0) throw InputError(history_path, 0, "", "an index is of a plain file alone");
  }

  void header(const std::string& producer, const std::string& header_sha256,
              const CertifyOptions& options) {
    file_.write("{\"format\":\"" + std::string(index_format) +
                "\",\"version\":1,\"producer\":" + string_text(producer) + ",\"header_sha256\":\"" +
                header_sha256 + "\",\"tolerance\":" + number_text(options.tolerance) +
                ",\"unoriented\":" + (options.unoriented ? "true" : "false") + "}\n");
  }

  // Whether the history up to here is long enough for another entry.
  bool due(std::int64_t offset) const { return offset >= next_; }

  void entry(const PartReader& reader, bool told) {
    const Cut cut = reader.cut();
    finish_entry(cut.offset);
    from_ = cut.offset;
    std::string text = std::string(",\"told\":") + (told ? "true" : "false") + ",\"state\":";
    ReplayWriter(text).put(reader.replay());
    head_ = "{\"cut\":" + cut_text(cut, reader.digest().state());
    tail_ = std::move(text) + "}\n";
    ++entries_;
    next_ = cut.offset + kRatio * static_cast<std::int64_t>(tail_.size());
  }

  std::int64_t finish() {
    finish_entry(bytes_);
    file_.write("{\"end\":{\"bytes\":" + std::to_string(bytes_) +
                ",\"entries\":" + std::to_string(entries_) + "}}\n");
    file_.commit();
    return entries_;
  }

 private:
  void finish_entry(std::int64_t until) {
    if (entries_ == 0) return;
    file_.write(head_ + ",\"until\":" + std::to_string(until) + ",\"sha256\":\"" +
                sha256_of_stretch(history_path_, from_, until) + "\"");
    file_.write(tail_);
  }

  std::string history_path_;
  std::int64_t bytes_;
  OutputFile file_;
  // The entry that is not written yet: the hash of what follows is missing.
  std::string head_, tail_;
  std::int64_t from_ = 0;
  std::int64_t next_ = 0;
  std::int64_t entries_ = 0;
};

}  // namespace

std::int64_t write_index(const std::string& path, const std::string& producer, Claim& claim,
                         const std::string& history_path, const CertifyOptions& asked) {
  CertifyOptions options = asked;
  options.truth = Truth::recorded;
  options.propose_initial = construct_initial;
  IndexWriter writer(path, history_path);
  const MotionInput input = motion_input(claim.scene);
  std::vector<std::string> remarks;
  PartReader reader(claim.scene, input, *claim.history, options, remarks, true);
  writer.header(producer, fingerprint_of(claim.scene, reader.header()), options);
  bool told = true;
  std::int64_t events = 0;
  while (std::optional<Part> part = reader.next()) {
    while (const auto event = part->claims->next()) {
      told = told && tells_velocities(*event);
      // The last part may be long.
      if (++events % 4096 == 0 && options.monitor && !options.monitor(time(*event), events)) {
        throw CertificationInterrupted{events, time(*event)};
      }
    }
    if (reader.done()) break;
    if (writer.due(reader.offset())) writer.entry(reader, told);
  }
  return writer.finish();
}

}  // namespace voroproof::internal
