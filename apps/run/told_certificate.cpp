#include "apps/run/told_certificate.h"

#include <iostream>

#include "history/error.h"
#include "history/json_text.h"

namespace voroproof::internal {
namespace {

constexpr std::size_t longest_shown = 4096;

void tell_counts(std::ostream& out, const ShardFile& file, const SecondWords& second) {
  const Certificate& c = file.shard.certificate;
  out << "c ";
  if (file.options.judges_flips()) out << c.flips << " flips, ";
  // Claims behind a fault that nobody saw before them are judged as if there were none.
  out << c.collisions << " collisions, " << c.maneuvers << " maneuvers "
      << (c.verdict == Verdict::certified ? "proved" : "judged") << "; certified prefix "
      << c.prefix_events << " events, t = " << number_text(c.prefix_t) << "; swaps " << c.swaps
      << '\n';
  for (const std::string& remark : c.remarks)
    out << "c " << printable(remark, longest_shown) << '\n';
  for (const auto& [checker, said] : second) {
    out << "c " << checker.name << ": " << printable(said, longest_shown) << '\n';
  }
  if (!file.run.evidence.empty()) out << "c evidence: " << file.run.evidence << '\n';
}

}  // namespace

ExitCode exit_code(Verdict verdict) {
  if (verdict == Verdict::certified) return ExitCode::ok;
  return verdict == Verdict::refuted ? ExitCode::refuted : ExitCode::undecided;
}

void tell(std::ostream& out, const ShardFile& file, const SecondWords& second,
          const std::string& shard, bool quiet) {
  const Certificate& c = file.shard.certificate;
  if (c.verdict != Verdict::certified) {
    std::cerr << "voroproof: " << printable(file.run.history_file, longest_shown) << ": "
              << printable(reason_line(c), longest_shown) << '\n';
  }
  if (!quiet) tell_counts(out, file, second);
  const VerdictWords words = words_of(file.options, file.run.horizon, c);
  out << "c " << (shard.empty() ? words.about : about_shard(file, words.about)) << '\n';
  for (const std::string& line : words.reservations) out << "c " << line << '\n';
  out << "s " << shard << verdict_line(c.verdict).substr(2) << '\n';
}

}  // namespace voroproof::internal
