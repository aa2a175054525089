// What becomes of many witnesses.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <iostream>
#include <map>
#include <string>
#include <string_view>

#include "certify/evidence/evidence.h"

namespace voroproof::internal::testing {

class Tally {
 public:
  // Checks the witness of a refutation; a test that meets a false one fails and shows `where`.
  void add(const Divergence& d, const std::string& where) {
    const EvidenceCheck check = check_evidence(d);
    EXPECT_NE(check.evidence, Evidence::contradicted) << check.sentence << "\n"
                                                      << d.truth << "\n"
                                                      << where;
    ++counts_[fault_names[static_cast<int>(d.fault)]][static_cast<int>(check.evidence)];
  }

  int count(Evidence evidence) const {
    int sum = 0;
    for (const auto& [fault, counts] : counts_) sum += counts[static_cast<int>(evidence)];
    return sum;
  }

  void print() const {
    std::cout << "fault: confirmed, not checkable, none, contradicted\n";
    for (const auto& [fault, c] : counts_) print(fault, c);
    print("all", {count(Evidence::confirmed), count(Evidence::not_checkable), count(Evidence::none),
                  count(Evidence::contradicted)});
  }

 private:
  using Counts = std::array<int, 4>;  // by the values of Evidence
  static void print(std::string_view fault, const Counts& c) {
    std::cout << fault << ": " << c[0] << ", " << c[1] << ", " << c[2] << ", " << c[3] << '\n';
  }
  std::map<std::string_view, Counts> counts_;
};

}  // namespace voroproof::internal::testing
