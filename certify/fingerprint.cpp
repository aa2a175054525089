#include "certify/fingerprint.h"
#include "history/scene_writer.h"

#include <sstream>

namespace voroproof::internal {

void Fingerprint::add_piece() {
  sha_.add({piece_.data(), used_});
  used_ = 0;
}

void Fingerprint::add(std::string_view text) {
  add(static_cast<std::int64_t>(text.size()));
  add_bytes(text.data(), text.size());
}

void Fingerprint::add(const Rational& q) { add(std::string_view(q.get_str())); }

void Fingerprint::add(const ExactVec2& v) {
  add(v[0]);
  add(v[1]);
}

void Fingerprint::add(const Quad& q) {
  const GenId ids[] = {q.l, q.r, q.s, q.e};
  add_bytes(ids, sizeof ids);
}

void Fingerprint::add(const HistoryHeader& header) {
  add(std::string_view(header.scene_sha256));
  add(header.horizon);
  add(header.horizon_error);
  add(header.oriented);
  add(header.initial.has_value());
  if (!header.initial) return;
  add(static_cast<std::int64_t>(header.initial->size()));
  for (const Quad& q : *header.initial) add(q);
}

std::string Fingerprint::hex() {
  add_piece();
  return sha_.hex();
}

std::string fingerprint_of(const Scene& scene, const HistoryHeader& header) {
  std::ostringstream text;
  write_scene(text, scene);
  Fingerprint fingerprint;
  fingerprint.add(text.view());
  fingerprint.add(header);
  return fingerprint.hex();
}

}  // namespace voroproof::internal
