// certify, from the bytes of its two files to the words of its report, held against the kernel.
#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "certify/certifier.h"
#include "certify/kernel/kernel.h"
#include "certify/report.h"
#include "exact/tower.h"
#include "filtered/motion/options.h"
#include "history/claim.h"
#include "history/error.h"
#include "library/certification.h"
#include "library/explanation.h"
#include "tests/fuzz/memory_file.h"
#include "tests/fuzz/pieces.h"
#include "tests/fuzz/target.h"

namespace voroproof::internal::fuzz {
namespace {

constexpr int most_bits = 512;
constexpr int most_disks = 12;
constexpr int most_lines = 120;
constexpr int most_questions = 200;  // of the certifier, whether to go on

struct Pair {
  std::string scene, history;
};

Pair pair_of(std::string_view bytes) {
  std::vector<std::string> pieces = pieces_of(bytes, 2);
  name_scene(pieces[1], pieces[0]);
  return {std::move(pieces[0]), std::move(pieces[1])};
}

const char* name(voroproof_kernel::Verdict verdict) {
  switch (verdict) {
    case voroproof_kernel::Verdict::certified:
      return "certified";
    case voroproof_kernel::Verdict::refuted:
      return "refuted";
    case voroproof_kernel::Verdict::undecided:
      return "undecided";
    case voroproof_kernel::Verdict::invalid:
      break;
  }
  return "invalid";
}

// The kernel reads one format, and has no initial diagram where the history has none.
void ask_kernel(const Pair& pair, const CertifyOptions& options, const HistoryHeader& header) {
  if (!pair.scene.starts_with('{') || !header.initial) return;
  voroproof_kernel::Options same;
  same.truth = options.truth == Truth::exact ? voroproof_kernel::Truth::exact
                                             : voroproof_kernel::Truth::recorded;
  same.strict = options.strict;
  same.unoriented = options.unoriented;
  const auto result = voroproof_kernel::check(pair.scene, pair.history, same);
  using voroproof_kernel::Verdict;
  if (result.verdict == Verdict::certified || result.verdict == Verdict::undecided) return;
  throw std::logic_error(std::string("certified, and the kernel says: ") + name(result.verdict) +
                         ": " + result.reason);
}

bool certifies(const Pair& pair, CertifyOptions options) {
  Claim claim = open_claim(file_with<0>(pair.scene), file_with<1>(pair.history));
  if (claim.scene.disks.size() > most_disks) return false;
  const HistoryHeader header = claim.history->header();
  require_meaningful(options, header.horizon);
  options.propose_initial = construct_initial;
  int questions = 0;
  options.monitor = [&](double, std::int64_t) { return ++questions < most_questions; };
  Certificate certificate;
  try {
    certificate = certify(claim.scene, *claim.history, options);
  } catch (const CertificationInterrupted&) {
    return false;
  }
  const std::string evidence =
      checked_evidence(certificate, file_with<0>(pair.scene), file_with<1>(pair.history));
  const std::string report = report_text(
      certification_run("fuzz", "scene", "history", claim, evidence), options, certificate);
  explain_report_text(report, "report");
  if (certificate.verdict != Verdict::certified) return false;
  if (options.judges_flips()) ask_kernel(pair, options, header);
  return true;
}

}  // namespace

bool certifies(std::string_view bytes) {
  const Pair pair = pair_of(bytes);
  if (std::count(pair.history.begin(), pair.history.end(), '\n') > most_lines) return false;
  CertifyOptions options;
  options.motion.max_bits = most_bits;
  bool all = true;
  try {
    for (const Truth truth : {Truth::exact, Truth::recorded}) {
      options.truth = truth;
      for (const bool lenient : {false, true}) {
        options.strict = !lenient;
        options.unoriented = lenient;
        all = certifies(pair, options) && all;
      }
      options.events = EventKinds::collisions;
      certifies(pair, options);
      options.events = EventKinds::all;
    }
    return all;
  } catch (const InputError&) {
  } catch (const std::invalid_argument&) {  // of require_meaningful()
  } catch (const Undecided&) {
  } catch (const BudgetExceeded&) {
  }
  return false;
}

}  // namespace voroproof::internal::fuzz
