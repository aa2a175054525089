#include "history/evtsq_writer.h"

#include <bit>
#include <cstdio>

#include "history/error.h"
#include "history/output_file.h"

namespace voroproof::internal {

namespace {

// Rounded half up, as two decimals.
std::string two_decimals(const Rational& q) {
  const Rational scaled = q * 100 + Rational(1, 2);
  const Integer hundredths = scaled.get_num() / scaled.get_den();
  std::string digits = hundredths.get_str();
  if (digits.size() < 3) digits.insert(0, 3 - digits.size(), '0');
  return digits.insert(digits.size() - 2, ".");
}

// The decimal with 15 digits after the point that is nearest.
std::string fixed_text(double x) {
  std::string text(400, '\0');
  const int length = std::snprintf(text.data(), text.size(), "%.15f", x);
  text.resize(static_cast<std::size_t>(length));
  return text;
}

class Lines {
 public:
  Lines(OutputFile& file, const EvtsqFormat& format) : file_(file), format_(format) {}

  void write(const FlipEvent& e) {
    begin("E", e.t);
    // Head and tail: the third generators of the end and of the start.
    for (const GenId g : {e.quad.l, e.quad.r, e.quad.e, e.quad.s}) add(std::to_string(g));
    end();
  }

  void write(const CollideEvent& e, const Vec2& container_center) {
    begin("C", e.t);
    add(std::to_string(e.i));
    add(std::to_string(e.j));
    if (format_.centers) {
      add(e.p[0].value_or(container_center));
      add(*e.p[1]);
    }
    end();
  }

  void write(const ManeuverEvent& e) {
    begin("V", e.t);
    add(std::to_string(e.disk));
    add(*e.v);
    if (format_.centers && e.p) add(*e.p);
    end();
  }

 private:
  void begin(const char* letter, double t) {
    line_ = letter;
    add(t);
  }
  void add(const std::string& text) { line_ += '\t' + text; }
  void add(double x) { add(format_.hexadecimal ? hexadecimal_text(x) : fixed_text(x)); }
  void add(const Vec2& v) {
    add(v[0]);
    add(v[1]);
  }
  void end() {
    line_ += '\n';
    file_.write(line_);
  }

  OutputFile& file_;
  const EvtsqFormat& format_;
  std::string line_;
};

}  // namespace

std::string hexadecimal_text(double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  std::string text;
  for (int byte = 0; byte < 8; ++byte) {
    const auto value = static_cast<unsigned>(bits >> (8 * byte) & 0xff);
    text += "0123456789abcdef"[value >> 4];
    text += "0123456789abcdef"[value & 15];
  }
  return text;
}

void write_evtsq(OutputFile& file, HistorySource& history, const HistoryCounts& totals,
                 const EvtsqSource& source, const EvtsqFormat& format) {
  // Names of others' choice stay in their lines.
  const auto field = [](const std::string& text) { return printable(text, text.size()); };
  file.write("#SOURCE:\t" + field(source.name) + "\n#DVD_GENERATOR:\t" +
             field(history.header().producer) + "\n#EVENT_SEQUENCE_FILE_FORMAT_VERSION:\t" +
             (format.centers ? "1.10" : "1.00") + "\n#TIME:\t-\n#SIMULATION_TIME:\t" +
             two_decimals(history.header().horizon) + "\n#RESTITUTION_COEFFICIENT:\t" +
             two_decimals(source.restitution) + "\n" +
             std::to_string(totals.flips + totals.collisions + totals.maneuvers) + "\n");
  Lines lines(file, format);
  while (const auto event = history.next()) {
    const auto refuse = [&](const std::string& reason) {
      throw InputError(source.history, history.line(), "", reason);
    };
    if (const auto* f = std::get_if<FlipEvent>(&*event)) {
      lines.write(*f);
    } else if (const auto* c = std::get_if<CollideEvent>(&*event)) {
      if (format.centers && !c->p[1])
        refuse("a collision without centres: only version 1.0 can say it");
      lines.write(*c, source.container_center);
    } else {
      const auto& m = std::get<ManeuverEvent>(*event);
      if (!m.v) refuse("a maneuver without velocity");
      lines.write(m);
    }
  }
  if (std::holds_alternative<HistoryStop>(history.ending())) {
    throw InputError(source.history, history.line(), "stopped",
                     "an event sequence cannot say that it stops early");
  }
}

}  // namespace voroproof::internal
