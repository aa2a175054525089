#include "certify/fingerprint.h"

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

void Fingerprint::add(const Event& event, std::int64_t line) {
  // Nearly all are flips at a time that is a double. Their first number is even.
  if (const auto* f = std::get_if<FlipEvent>(&event); f != nullptr && f->exact == nullptr) {
    const struct {
      std::int64_t line;
      double t;
      Quad quad;
    } plain{2 * line, f->t, f->quad};
    static_assert(sizeof plain == 32, "nothing is between the members");
    return add_bytes(&plain, sizeof plain);
  }
  add(2 * line + 1);
  add(static_cast<std::int64_t>(event.index()));
  add(time(event));
  const auto add_vector = [this](const std::optional<Vec2>& v) {
    add(v.has_value());
    if (!v) return;
    add((*v)[0]);
    add((*v)[1]);
  };
  if (const auto* f = std::get_if<FlipEvent>(&event)) {
    add(f->quad);
  } else if (const auto* c = std::get_if<CollideEvent>(&event)) {
    add(c->i);
    add(c->j);
    for (const auto* vectors : {&c->v, &c->p}) {
      for (const auto& v : *vectors) add_vector(v);
    }
  } else {
    const auto& m = std::get<ManeuverEvent>(event);
    add(m.disk);
    add_vector(m.v);
    add_vector(m.p);
  }
  std::visit(
      [this](const auto& claim) {
        add(claim.exact != nullptr);
        if (claim.exact == nullptr) return;
        add(claim.exact->t);
        for (const auto* vectors : {&claim.exact->v, &claim.exact->p}) {
          for (const auto& v : *vectors) {
            add(v.has_value());
            if (v) add(*v);
          }
        }
      },
      event);
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
