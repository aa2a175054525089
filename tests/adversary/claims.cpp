#include "tests/adversary/claims.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace voroproof::internal::adversary {
namespace {

class Text {
 public:
  explicit Text(bool long_decimals) : long_decimals_(long_decimals) {}
  Text& operator<<(const char* s) {
    out_ += s;
    return *this;
  }
  Text& operator<<(const std::string& s) {
    out_ += s;
    return *this;
  }
  Text& operator<<(int k) {
    out_ += std::to_string(k);
    return *this;
  }
  Text& operator<<(double x) {
    std::array<char, 40> digits;
    if (x == 0) x = 0;  // never -0
    const auto end = long_decimals_ ? std::to_chars(digits.begin(), digits.end(), x,
                                                    std::chars_format::scientific, 16)
                                    : std::to_chars(digits.begin(), digits.end(), x);
    std::string text(digits.begin(), end.ptr);
    // JSON's exponents as this project writes them: without plus and leading zeros.
    if (const auto e = text.find('e'); e != text.npos) {
      std::string exponent = text.substr(e + 1);
      const bool negative = exponent[0] == '-';
      exponent.erase(0, exponent.find_first_not_of("+-0"));
      text = text.substr(0, e) + (exponent.empty() ? "" : negative ? "e-" : "e") + exponent;
    }
    out_ += text;
    return *this;
  }
  Text& operator<<(const Pair2& v) { return *this << "[" << v[0] << "," << v[1] << "]"; }
  Text& operator<<(const Edge& q) {
    return *this << "[" << q[0] << "," << q[1] << "," << q[2] << "," << q[3] << "]";
  }
  std::string take() { return std::move(out_); }

 private:
  bool long_decimals_;
  std::string out_;
};

void put(Text& out, const Line& line, const History& h) {
  out << "{\"t\":" << line.t;
  switch (line.kind) {
    case Line::Kind::flip:
      out << ",\"flip\":" << canonical(line.edge);
      break;
    case Line::Kind::maneuver:
      out << ",\"maneuver\":" << line.j;
      if (h.velocities) out << ",\"v\":" << line.v[1];
      if (h.centres) out << ",\"p\":" << line.p[1];
      break;
    case Line::Kind::collide:
      out << ",\"collide\":[" << line.i << "," << line.j << "]";
      for (const bool velocity : {true, false}) {
        if (!(velocity ? h.velocities : h.centres)) continue;
        const auto& of = velocity ? line.v : line.p;
        out << (velocity ? ",\"v\":[" : ",\"p\":[");
        if (line.i < 0) {
          out << "null";
        } else {
          out << of[0];
        }
        out << "," << of[1] << "]";
      }
      break;
  }
  out << "}\n";
}

void scale(double& x, int exponent) { x = std::ldexp(x, exponent); }

void scale(Pair2& pair, int exponent) {
  for (double& x : pair) scale(x, exponent);
}

}  // namespace

SceneData in_units(SceneData s, const Units& units) {
  const int speed = units.length - units.time;
  for (double* x : {&s.cx, &s.cy, &s.radius}) scale(*x, units.length);
  scale(s.horizon, units.time);
  for (DiskData& d : s.disks) {
    for (double* x : {&d.x, &d.y, &d.radius}) scale(*x, units.length);
    for (double* v : {&d.vx, &d.vy}) scale(*v, speed);
  }
  for (ManeuverData& m : s.maneuvers) {
    scale(m.t, units.time);
    for (double* v : {&m.vx, &m.vy}) scale(*v, speed);
  }
  return s;
}

History in_units(History h, const Units& units) {
  scale(h.horizon, units.time);
  for (Line& line : h.lines) {
    scale(line.t, units.time);
    for (Pair2& v : line.v) scale(v, units.length - units.time);
    for (Pair2& p : line.p) scale(p, units.length);
  }
  return h;
}

std::string scene_text(const SceneData& s) {
  Text out(false);
  out << "{\"format\": \"voroproof-scene\", \"version\": 1,\n \"container\": {\"center\": "
      << Pair2{s.cx, s.cy} << ", \"radius\": " << s.radius
      << ", \"restitution\": " << s.wall_restitution << "},\n \"container_law\": \""
      << (s.whole ? "whole" : "normal") << "\",\n \"restitution\": " << s.restitution
      << ",\n \"horizon\": " << s.horizon << ",\n \"disks\": [";
  const char* separator = "\n";
  for (const DiskData& d : s.disks) {
    out << separator << "  {\"center\": " << Pair2{d.x, d.y} << ", \"radius\": " << d.radius
        << ", \"velocity\": " << Pair2{d.vx, d.vy} << ", \"mass\": " << d.mass << "}";
    separator = ",\n";
  }
  out << "],\n \"maneuvers\": [";
  separator = "\n";
  for (const ManeuverData& m : s.maneuvers) {
    out << separator << "  {\"t\": " << m.t << ", \"disk\": " << m.disk
        << ", \"velocity\": " << Pair2{m.vx, m.vy} << "}";
    separator = ",\n";
  }
  out << "]}\n";
  return out.take();
}

std::string history_text(const History& h, const std::string& sha256, bool long_decimals) {
  Text out(long_decimals);
  out << "{\"format\":\"voroproof-history\",\"version\":1,\"scene_sha256\":\"" << sha256
      << "\",\"horizon\":" << h.horizon << ",\"producer\":\"adversary 1\",\"initial\":[";
  std::vector<Edge> edges;
  for (const Edge& q : h.initial) edges.push_back(canonical(q));
  std::sort(edges.begin(), edges.end());
  for (std::size_t k = 0; k < edges.size(); ++k) out << (k == 0 ? "" : ",") << edges[k];
  out << "]}\n";
  std::array<int, 3> counts{};
  for (const Line& line : h.lines) {
    put(out, line, h);
    ++counts[static_cast<std::size_t>(line.kind)];
  }
  out << "{\"end\":{\"t\":" << h.horizon << ",\"flips\":" << counts[0]
      << ",\"collisions\":" << counts[1] << ",\"maneuvers\":" << counts[2] << "}}\n";
  return out.take();
}

}  // namespace voroproof::internal::adversary
