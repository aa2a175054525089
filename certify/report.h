// The report of a certification, as JSON (docs/certificate.md lists its fields).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "certify/certifier.h"

namespace voroproof::internal {

// What a report says of the run besides the certificate.
struct CertificationRun {
  std::string producer, scene_file, history_file;
  // Of the contents. That of the history is empty where not all of it is known: of a shard behind
  // which the history goes on, and of a stream that was not read to its end.
  std::string scene_sha256, history_sha256;
  std::string history_producer;
  int disks = 0;
  Rational horizon;
  std::string evidence{};  // of a refutation: whether its witness was checked, and by what
  // What each second checker said that was asked, by the name of its field.
  std::vector<std::pair<std::string, std::string>> second{};
};

// One line: "s CERTIFIED" and so on.
std::string_view verdict_line(Verdict verdict);

// Why, in one line, for a person; empty for a certified history.
std::string reason_line(const Certificate& certificate);

// What was accepted by leniency (docs/claim.md, section 5): the name of its count in the report,
// and in words for a person. Counts of zero are listed, too.
struct Leniency {
  std::string_view name;
  std::int64_t count;
  std::string_view words;
};
std::vector<Leniency> leniencies(const Certificate& certificate);

// "horizon 5 of the scene's 1000", where the history has another; else empty.
std::string horizon_line(const Certificate& certificate);

// What a certificate says, wherever it is said: by the program, in reports and tables, in movies,
// in the library and in Python.
struct VerdictWords {
  std::string verdict;  // "CERTIFIED" and so on, or "CERTIFIED (collisions alone)"
  std::string about;    // which events, which truth, up to when, within which tolerances
  // What the verdict is not about, and what was accepted that is not exact; each a line.
  std::vector<std::string> reservations;
};
VerdictWords words_of(const CertifyOptions& options, const Rational& horizon,
                      const Certificate& certificate);

// The text of the report file.
std::string report_text(const CertificationRun& run, const CertifyOptions& options,
                        const Certificate& certificate);

}  // namespace voroproof::internal
