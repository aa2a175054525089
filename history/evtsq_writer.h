// Writing an event sequence (docs/formats.md).
#pragma once

#include <string>

#include "exact/rational.h"
#include "history/history_source.h"
#include "history/output_file.h"

namespace voroproof::internal {

struct EvtsqFormat {
  bool centers = true;      // version 1.1; else 1.0
  bool hexadecimal = true;  // numbers without loss; else with 15 digits after the point
};

// Where the events come from, for the header and for messages.
struct EvtsqSource {
  std::string name;     // name of the disk file
  std::string history;  // the file that `history` reads
  Rational restitution;
  Vec2 container_center{};
};

// A binary64 as the 16 digits of its bytes (FieldLines::hexadecimal).
std::string hexadecimal_text(double x);

// Writes the events of `history`, `totals` of them, reading it to its end. Throws InputError where
// it is not right in form, or has what such a file cannot say: a stop.
void write_evtsq(OutputFile& file, HistorySource& history, const HistoryCounts& totals,
                 const EvtsqSource& source, const EvtsqFormat& format);

}  // namespace voroproof::internal
