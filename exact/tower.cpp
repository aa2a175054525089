#include "exact/tower.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "exact/patience.h"

namespace voroproof::internal {

struct Tower::Node {
  const Radical* radical;
  Tower a, b;  // a + b sqrt(radical->radicand), over lower ranks; b is not the plain 0
};

// ---- Enclosures --------------------------------------------------------------

namespace {

constexpr Ball::Precision first_precision = 64, last_precision = 1024;

}  // namespace

// Evaluates elements with one precision; each radical's root is computed once.
class Tower::Evaluation {
 public:
  explicit Evaluation(Ball::Precision precision) : precision_(precision) {}

  Ball operator()(const Tower& x) {
    if (x.is_rational()) return Ball(x.rational(), precision_);
    const Node& node = x.node();
    const Ball a = (*this)(node.a), b = (*this)(node.b);
    return a + b * root(*node.radical);
  }

 private:
  const Ball& root(const Radical& radical) {
    if (roots_.size() <= radical.rank) roots_.resize(radical.rank + 1);
    if (!roots_[radical.rank]) roots_[radical.rank] = sqrt((*this)(radical.radicand));
    return *roots_[radical.rank];
  }

  Ball::Precision precision_;
  std::vector<std::optional<Ball>> roots_;
};

Ball ball(const Tower& x, Ball::Precision precision) { return Tower::Evaluation(precision)(x); }

std::pair<double, double> double_interval(const Tower& x) {
  if (x.is_rational()) return {round_down(x.rational()), round_up(x.rational())};
  std::pair<double, double> bounds;
  for (Ball::Precision precision = first_precision; precision <= last_precision; precision *= 2) {
    ball(x, precision).to_interval(bounds.first, bounds.second);
    if (bounds.second <= std::nextafter(bounds.first, std::numeric_limits<double>::infinity())) {
      break;
    }
  }
  return bounds;
}

// ---- Structure ---------------------------------------------------------------

namespace {

// The degree of a field with that many independent radicals, saturated.
unsigned long field_degree(std::size_t radicals) {
  constexpr std::size_t top_bit = std::numeric_limits<unsigned long>::digits - 1;
  return 1UL << std::min(radicals, top_bit);
}

// The field made last in this thread.
thread_local const RadicalField* innermost = nullptr;

void require_within(const RadicalField& field, const Rational& coefficient) {
  const std::size_t bits = bit_size(coefficient);
  if (bits > field.budget().coefficient_bits) {
    throw BudgetExceeded(bits, field_degree(field.size()));
  }
}

}  // namespace

RadicalField::RadicalField(Budget budget)
    : budget_(budget), outer_(std::exchange(innermost, this)) {}

RadicalField::~RadicalField() { innermost = outer_; }

BudgetExceeded::BudgetExceeded(std::size_t bits, unsigned long degree)
    : std::runtime_error("the budget of exact arithmetic is exceeded: coefficients of " +
                         std::to_string(bits) + " bits in a field of degree " +
                         std::to_string(degree)),
      bits(bits),
      degree(degree) {}

const Tower::Node& Tower::node() const { return *std::get<std::shared_ptr<const Node>>(value_); }

const Radical* Tower::top() const { return is_rational() ? nullptr : node().radical; }

const Tower& Tower::constant_part(const Radical* radical) const {
  return top() == radical ? node().a : *this;
}

const Tower& Tower::radical_part(const Radical* radical) const {
  static const Tower zero;
  return top() == radical ? node().b : zero;
}

Tower Tower::make(const Radical* radical, Tower a, Tower b) {
  Patience::ask();
  const RadicalField& field = *radical->field;
  for (const Tower* part : {&a, &b}) {
    // Others were checked when they were made.
    if (part->is_rational()) require_within(field, part->rational());
  }
  if (b.is_rational() && b.rational() == 0) return a;
  Tower result;
  result.value_ = std::make_shared<const Node>(Node{radical, std::move(a), std::move(b)});
  return result;
}

Tower Tower::plain(Rational q) {
  Patience::ask();
  if (innermost != nullptr) require_within(*innermost, q);
  Tower result;
  result.value_ = std::move(q);
  return result;
}

const Radical* Tower::common_top(const Tower& x, const Tower& y) {
  const Radical* of_x = x.top();
  const Radical* of_y = y.top();
  if (!of_x) return of_y;
  if (!of_y) return of_x;
  if (of_x->field != of_y->field) {
    throw std::invalid_argument("arithmetic of elements of two different radical fields");
  }
  return of_x->rank < of_y->rank ? of_y : of_x;
}

std::size_t bit_size(const Tower& x) {
  if (x.is_rational()) return bit_size(x.rational());
  return std::max(bit_size(x.node().a), bit_size(x.node().b));
}

// ---- Arithmetic --------------------------------------------------------------

Tower operator+(const Tower& x, const Tower& y) {
  const Radical* s = Tower::common_top(x, y);
  if (!s) return Tower::plain(x.rational() + y.rational());
  return Tower::make(s, x.constant_part(s) + y.constant_part(s),
                     x.radical_part(s) + y.radical_part(s));
}

Tower operator-(const Tower& x, const Tower& y) {
  const Radical* s = Tower::common_top(x, y);
  if (!s) return Tower::plain(x.rational() - y.rational());
  return Tower::make(s, x.constant_part(s) - y.constant_part(s),
                     x.radical_part(s) - y.radical_part(s));
}

Tower Tower::operator-() const {
  if (is_rational()) return -rational();
  return make(top(), -node().a, -node().b);
}

Tower operator*(const Tower& x, const Tower& y) {
  const Radical* s = Tower::common_top(x, y);
  if (!s) return Tower::plain(x.rational() * y.rational());
  if (x.top() != s) return Tower::make(s, x * y.node().a, x * y.node().b);
  if (y.top() != s) return Tower::make(s, x.node().a * y, x.node().b * y);
  const Tower::Node& u = x.node();
  const Tower::Node& v = y.node();
  return Tower::make(s, u.a * v.a + u.b * v.b * s->radicand, u.a * v.b + u.b * v.a);
}

Tower Tower::norm() const {
  const Node& n = node();
  return n.a * n.a - n.b * n.b * n.radical->radicand;
}

Tower Tower::inverse() const {
  if (is_rational()) {
    if (rational() == 0) throw std::domain_error("division by zero");
    return plain(1 / rational());
  }
  const Node& n = node();
  const Tower of_norm = norm();
  if (sign(of_norm) == Sign::zero) {  // a = b sqrt(r), or a = -b sqrt(r)
    if (sign(n.a) != sign(n.b)) throw std::domain_error("division by zero");
    return (n.a + n.a).inverse();
  }
  const Tower scale = of_norm.inverse();
  return make(n.radical, n.a * scale, -(n.b * scale));
}

Tower operator/(const Tower& x, const Tower& y) {
  if (x.is_rational() && y.is_rational() && y.rational() != 0) {
    return Tower::plain(x.rational() / y.rational());
  }
  return x * y.inverse();
}

// ---- Signs and order -----------------------------------------------------------

Sign sign(const Tower& x) {
  if (x.is_rational()) return sign(x.rational());
  for (Ball::Precision precision = first_precision; precision <= last_precision; precision *= 2) {
    const Sign enclosed = ball(x, precision).sign();
    if (enclosed != Sign::unknown) return enclosed;
  }
  const Sign of_a = sign(x.node().a);
  const Sign of_b = sign(x.node().b);
  if (of_b == Sign::zero) return of_a;
  if (of_a == Sign::zero || of_a == of_b) return of_b;
  return of_a * sign(x.norm());
}

double round_nearest(const Tower& x) {
  if (x.is_rational()) return round_nearest(x.rational());
  if (sign(x) == Sign::zero) return 0;
  for (Ball::Precision precision = first_precision;; precision *= 2) {
    Patience::ask();
    const auto [lo, hi] = ball(x, precision).rational_interval();
    const double below = round_nearest(lo), above = round_nearest(hi);
    if (below == above) return below;
    if (std::nextafter(below, std::numeric_limits<double>::infinity()) != above) continue;
    // One breakpoint at most is left, and the exact comparison with it decides.
    const Rational breakpoint = rounding_breakpoint(below, above);
    const Sign side = sign(x - Tower(breakpoint));
    if (side == Sign::zero) return round_nearest(breakpoint);
    return side == Sign::negative ? below : above;
  }
}

bool operator==(const Tower& x, const Tower& y) { return sign(x - y) == Sign::zero; }

std::strong_ordering operator<=>(const Tower& x, const Tower& y) {
  return static_cast<int>(sign(x - y)) <=> 0;
}

// ---- Square roots --------------------------------------------------------------

namespace {

struct SquareSplit {
  Rational root;      // > 0
  Rational radicand;  // a positive integer
};

// q > 0 as root^2 * radicand, free of the squares of small primes; radicand = 1
// iff q is the square of a rational.
SquareSplit split_square(const Rational& q) {
  if (const std::optional<Rational> root = rational_sqrt(q)) return {*root, 1};
  constexpr unsigned long last_divisor = 255;
  Integer rest = q.get_num() * q.get_den();
  Rational root(Integer(1), q.get_den());
  for (unsigned long p = 2; p <= last_divisor; ++p) {
    while (mpz_divisible_ui_p(rest.get_mpz_t(), p * p)) {
      mpz_divexact_ui(rest.get_mpz_t(), rest.get_mpz_t(), p * p);
      root *= p;
    }
  }
  return {root, Rational(rest)};
}

}  // namespace

// The rational q with x = q y, if it can be read off matching coefficients: a
// candidate that the caller must verify.
std::optional<Rational> Tower::structural_ratio(const Tower& x, const Tower& y) {
  if (x.is_rational() && y.is_rational()) return Rational(x.rational() / y.rational());
  if (x.top() != y.top()) return std::nullopt;
  return structural_ratio(x.node().b, y.node().b);
}

Tower RadicalField::sqrt(const Tower& x) {
  if (!x.is_rational() && x.top()->field != this) {
    throw std::invalid_argument("square root of an element of another radical field");
  }
  const Sign of_x = sign(x);
  if (of_x == Sign::negative) throw std::domain_error("square root of a negative number");
  if (of_x == Sign::zero) return 0;

  Rational factor = 1;
  Tower radicand = x;
  if (x.is_rational()) {
    const SquareSplit split = split_square(x.rational());
    if (split.radicand == 1) return split.root;
    factor = split.root;
    radicand = split.radicand;
  }
  for (const auto& radical : radicals_) {
    if (const auto ratio = Tower::structural_ratio(radicand, radical->radicand)) {
      const std::optional<Rational> root = rational_sqrt(*ratio);
      if (root && radicand == radical->radicand * *ratio) {
        return Tower::make(radical.get(), 0, factor * *root);
      }
    }
    if (radicand == radical->radicand) return Tower::make(radical.get(), 0, factor);
  }

  if (radicals_.size() >= budget_.radicals) {
    throw BudgetExceeded(bit_size(radicand), field_degree(radicals_.size() + 1));
  }
  radicals_.push_back(std::make_unique<const Radical>(Radical{radicand, radicals_.size(), this}));
  return Tower::make(radicals_.back().get(), 0, factor);
}

}  // namespace voroproof::internal
