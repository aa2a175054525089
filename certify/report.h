// The report of a certification, as JSON (packaging/schemas/report.schema.json).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "certify/certificate.h"
#include "certify/options.h"

namespace voroproof::internal {

// The least tolerances under which a history is certified, as powers of ten.
struct LeastTolerances {
  Rational times, velocities;
};

// The facts of a report about the run, besides the certificate.
struct CertificationRun {
  std::string producer, scene_file, history_file;
  // Hashes of the contents. The history's is empty where not all of it is known: for a shard behind
  // which the history goes on, and for a stream that was not read to its end.
  std::string scene_sha256, history_sha256;
  std::string history_producer;
  int disks = 0;
  Rational horizon;
  std::string evidence{};  // on a refutation: whether its witness was checked, and by what
  std::optional<LeastTolerances> least{};  // where they were asked for, and there are any
  // The words of each second checker that was asked, by the name of its field.
  std::vector<std::pair<std::string, std::string>> second{};
};

// One line: "s CERTIFIED" and so on.
std::string_view verdict_line(Verdict verdict);

// Why, in one line, for a person; empty for a certified history.
std::string reason_line(const Certificate& certificate);

// A kind of claim that was accepted by leniency (docs/claim.md, section 5): the name of its count
// in the report, and in words for a person. Counts of zero are listed, too.
struct Leniency {
  std::string_view name;
  std::int64_t count;
  std::string_view words;
};
std::vector<Leniency> leniencies(const Certificate& certificate);

// "horizon 5 of the scene's 1000", where the history has another; else empty.
std::string horizon_line(const Certificate& certificate);

// The words for a certificate, wherever they are used: by the program, in reports and tables, in
// movies, in the library and in Python.
struct VerdictWords {
  std::string verdict;  // "CERTIFIED" and so on, or "CERTIFIED (collisions alone)"
  std::string about;    // which events, which truth, up to when, within which tolerances
  // Matters outside the verdict, and accepted claims that are not exact; each a line.
  std::vector<std::string> reservations;
};
VerdictWords words_of(const CertifyOptions& options, const Rational& horizon,
                      const Certificate& certificate);

// The words for the verdict about the history of a world, whose scene has the horizon `of_scene`.
VerdictWords words_of_world(Verdict verdict, const Rational& horizon, const Rational& of_scene,
                            const Rational& tolerance);

// The text of the report file.
std::string report_text(const CertificationRun& run, const CertifyOptions& options,
                        const Certificate& certificate);

}  // namespace voroproof::internal
