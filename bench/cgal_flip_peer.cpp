#ifdef VOROPROOF_BENCH_CGAL_KERNEL

#include <CGAL/Algebraic_kernel_d_1.h>
#include <CGAL/Gmpz.h>

#include <iterator>
#include <utility>

#include "bench/flip_peer.h"

namespace voroproof::internal::bench {

namespace {

using Kernel = CGAL::Algebraic_kernel_d_1<CGAL::Gmpz>;

class CgalIsolator : public RootIsolator {
 public:
  explicit CgalIsolator(const std::vector<RootTask>& tasks) {
    for (const RootTask& task : tasks) {
      std::vector<CGAL::Gmpz> c;
      for (const Integer& k : task.coefficients) c.emplace_back(k.get_mpz_t());
      polynomials_.emplace_back(c.begin(), c.end());
      ends_.emplace_back(task.end);
    }
  }

  long isolate() override {
    long roots = 0;
    const auto solve = kernel_.solve_1_object();
    for (std::size_t k = 0; k < polynomials_.size(); ++k) {
      found_.clear();
      solve(polynomials_[k], Kernel::Bound(0), ends_[k], std::back_inserter(found_));
      roots += static_cast<long>(found_.size());
    }
    return roots;
  }

 private:
  Kernel kernel_;
  std::vector<Kernel::Polynomial_1> polynomials_;
  std::vector<Kernel::Bound> ends_;
  std::vector<std::pair<Kernel::Algebraic_real_1, Kernel::Multiplicity_type>> found_;
};

}  // namespace

std::unique_ptr<RootIsolator> cgal_isolator(const std::vector<RootTask>& tasks) {
  return std::make_unique<CgalIsolator>(tasks);
}

}  // namespace voroproof::internal::bench

#endif
