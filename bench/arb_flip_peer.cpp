#include <arb.h>
#include <gmp.h>

#include "bench/flip_peer.h"

namespace voroproof::internal::bench {

namespace {

constexpr slong kBits = 128;
constexpr int kMaxDepth = 40;

// A vector of Arb numbers that owns them.
class Balls {
 public:
  explicit Balls(slong size) : size_(size), data_(_arb_vec_init(size)) {}
  Balls(const Balls& o) : Balls(o.size_) { _arb_vec_set(data_, o.data_, size_); }
  Balls(Balls&& o) noexcept : size_(o.size_), data_(o.data_) { o.data_ = nullptr; }
  Balls& operator=(Balls o) noexcept {
    std::swap(size_, o.size_);
    std::swap(data_, o.data_);
    return *this;
  }
  ~Balls() {
    if (data_ != nullptr) _arb_vec_clear(data_, size_);
  }
  slong size() const { return size_; }
  arb_ptr operator[](slong k) const { return data_ + k; }

 private:
  slong size_;
  arb_ptr data_;
};

// Bernstein coefficients over (0, end) of a polynomial in powers of t:
// b_j = sum_i a_i end^i C(j,i) / C(n,i).
Balls bernstein(const Balls& powers, double end) {
  const slong n = powers.size() - 1;
  Balls scaled(n + 1), out(n + 1), work(3);
  arb_set_d(work[0], end);
  arb_one(work[1]);
  for (slong i = 0; i <= n; ++i) {
    arb_bin_uiui(work[2], static_cast<ulong>(n), static_cast<ulong>(i), kBits);
    arb_mul(scaled[i], powers[i], work[1], kBits);
    arb_div(scaled[i], scaled[i], work[2], kBits);
    arb_mul(work[1], work[1], work[0], kBits);
  }
  for (slong j = 0; j <= n; ++j) {
    for (slong i = 0; i <= j; ++i) {
      arb_bin_uiui(work[2], static_cast<ulong>(j), static_cast<ulong>(i), kBits);
      arb_addmul(out[j], scaled[i], work[2], kBits);
    }
  }
  return out;
}

// The sign changes of the coefficients; -1 where a ball contains zero.
int variations(const Balls& b) {
  int changes = 0;
  for (slong k = 0; k < b.size(); ++k) {
    if (arb_contains_zero(b[k])) return -1;
    if (k > 0 && arb_is_positive(b[k]) != arb_is_positive(b[k - 1])) ++changes;
  }
  return changes;
}

// de Casteljau's halving: b becomes the left half, the right half is returned.
Balls split(Balls& b) {
  const slong n = b.size() - 1;
  Balls right(n + 1);
  arb_set(right[n], b[n]);
  for (slong level = 1; level <= n; ++level) {
    for (slong k = n; k >= level; --k) {
      arb_add(b[k], b[k], b[k - 1], kBits);
      arb_mul_2exp_si(b[k], b[k], -1);
    }
    arb_set(right[n - level], b[n]);
  }
  return right;
}

class ArbIsolator : public RootIsolator {
 public:
  explicit ArbIsolator(const std::vector<RootTask>& tasks) {
    fmpz_t integer;
    fmpz_init(integer);
    for (const RootTask& task : tasks) {
      Balls powers(static_cast<slong>(task.coefficients.size()));
      for (slong k = 0; k < powers.size(); ++k) {
        fmpz_set_mpz(integer, task.coefficients[static_cast<std::size_t>(k)].get_mpz_t());
        arb_set_fmpz(powers[k], integer);
      }
      tasks_.push_back({std::move(powers), task.end});
    }
    fmpz_clear(integer);
  }

  long isolate() override {
    long roots = 0;
    for (const Task& task : tasks_) {
      bool complete = true;
      roots += count(bernstein(task.powers, task.end), 0, complete);
      if (!complete) ++undecided_;
    }
    return roots;
  }

  long undecided() const override { return undecided_; }

 private:
  struct Task {
    Balls powers;
    double end;
  };

  static long count(Balls b, int depth, bool& complete) {
    const int changes = variations(b);
    if (changes == 0 || changes == 1) return changes;
    if (depth == kMaxDepth) {
      complete = false;
      return 0;
    }
    Balls right = split(b);
    const long left_roots = count(std::move(b), depth + 1, complete);
    return left_roots + count(std::move(right), depth + 1, complete);
  }

  std::vector<Task> tasks_;
  long undecided_ = 0;
};

}  // namespace

std::unique_ptr<RootIsolator> arb_isolator(const std::vector<RootTask>& tasks) {
  return std::make_unique<ArbIsolator>(tasks);
}

}  // namespace voroproof::internal::bench
