// The lines of `incircle` and `exists`.
#include <array>
#include <cmath>
#include <string_view>

#include "corpus/truth/hardness.h"
#include "corpus/truth/lines.h"
#include "corpus/truth/proof.h"

namespace voroproof::truth {

namespace {

using internal::Sign;

constexpr std::array<std::string_view, 10> classes{
    "generic", "near", "tie", "equal", "close", "far", "wide", "container", "wall", "point"};

template <class T, std::size_t N, class Make>
std::array<Numbers<T>, N> numbers(const Generators& g, const Make& make) {
  return [&]<std::size_t... k>(std::index_sequence<k...>) {
    return std::array<Numbers<T>, N>{make(g[k])...};
  }
  (std::make_index_sequence<N>{});
}

template <std::size_t N>
auto exactly(const Generators& g) {
  return numbers<Rational, N>(g, [](const Generator& x) { return at(x, 0); });
}
template <std::size_t N>
auto held(const Generators& g, int bits) {
  return numbers<Ball, N>(g, [&](const Generator& x) { return in_balls(x, bits); });
}

template <std::size_t N>
bool are_apart(const Generators& g) {
  const auto exact = exactly<N>(g);
  return truth::are_apart({exact.begin(), exact.end()});
}

std::string line(std::string_view name, const Proof& proof, Sign sign, const Generators& all) {
  std::string text =
      std::string(name) + ' ' + proof.text() + ' ' + std::to_string(static_cast<int>(sign));
  for (const Generator& g : all) text += ' ' + text_at_rest(g);
  return text;
}

}  // namespace

std::string incircle_line(std::uint64_t k) {
  const std::string_view name = classes[k % classes.size()];
  for (Dice dice(1, k);;) {
    const Distance distance = distance_of(dice, name);
    Generators g = touching(dice, 4, ingredients(dice, name));
    if (name == "close") make_close(dice, g);
    put_at(distance, dice, g);
    change_frame(dice, name, g);
    if (!are_apart<4>(g)) continue;
    const auto exact = exactly<4>(g);
    if (exists_sign(std::array{exact[0], exact[1], exact[2]}) != Sign::positive) continue;
    const Sign sign = gap_sign(exact);
    if (!keeps_promise(distance, sign)) continue;
    return line(name, proof_of_sign(sign, [&](int bits) { return gap_sign(held<4>(g, bits)); }),
                sign, g);
  }
}

std::string exists_line(std::uint64_t k) {
  const std::string_view name = classes[k % classes.size()];
  for (Dice dice(2, k);;) {
    const Ingredients with = ingredients(dice, name);
    const bool by_line = !with.container && with.walls == 0;
    const Distance distance = by_line ? distance_of(dice, name) : Distance::any;
    Generators g = by_line ? touching_line(dice, with) : touching(dice, 3, with);
    if (!by_line && dice.one_in(2)) std::swap(g[0], g[1]);
    if (name == "close") make_close(dice, g);
    put_at(distance, dice, g);
    // Some get behind others.
    if (!by_line) perturb(dice, g, std::ldexp(1.0, dice.whole(20, 26)));
    change_frame(dice, name, g);
    if (!are_apart<3>(g)) continue;
    const Sign sign = exists_sign(exactly<3>(g));
    if (by_line && !keeps_promise(distance, sign)) continue;
    return line(name, proof_of_sign(sign, [&](int bits) { return exists_sign(held<3>(g, bits)); }),
                sign, g);
  }
}

}  // namespace voroproof::truth
