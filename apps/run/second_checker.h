// Second checkers beside the certifier: `certify --kernel`, `certify --proved`.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "certify/certifier.h"
#include "certify/report.h"

namespace voroproof::internal {

// One that judges the same files by rules and code of its own.
struct SecondChecker {
  std::string_view option;  // by which it is asked for
  std::string_view name;    // in sentences
  std::string_view field;   // the report's field for what it said
  // Why it cannot judge: because of an option, or because it is not installed. Empty where it can.
  std::string (*refusal)(const CertifyOptions& options);
  // In a process of its own, whose output is read: judges the bytes of a scene and of a history,
  // and prints its verdict as the last line (`s CERTIFIED`, ...), before it the reason as
  // `c line N: ...`. Gives the exit code.
  int (*work)(const std::string& scene, const std::string& history, const CertifyOptions& options);
};

// The kernel (docs/kernel.md), which is a part of this program.
SecondChecker kernel_checker();

// The proved checker (docs/proved.md), which is the program voroproof-proved: beside this one, in
// the folder certify/proofs/ beside it, where a build has it, or in a folder of PATH.
SecondChecker proved_checker();

// Those that are asked for. Throws UsageError where one cannot judge what is asked (under these
// options; of a history that is not the `whole` one), or is not there.
std::vector<SecondChecker> second_checkers(bool kernel, bool proved, const CertifyOptions& options,
                                           bool whole);

// The words of the second checkers, each with its own.
using SecondWords = std::vector<std::pair<SecondChecker, std::string>>;

// Has the checker judge the same files (`run` names them, and has the hashes of what the certifier
// has judged) under the same options, and makes the certificate that of
// both: certified only where both certify, undecided where the second does not decide what was
// certified. Gives what the second said, in one line. Several times a second asks whether to
// `go_on`; where not, the checker's process is ended and nothing is given. Throws std::logic_error,
// with both verdicts and the names of the files, where one of the two certifies what the other
// refutes or cannot read; InputError for files that have other bytes by now; UsageError for files
// of other engines, which second checkers do not read; std::bad_alloc where the second has not
// enough memory.
std::string judged_by(const SecondChecker& second, Certificate& certificate,
                      const CertificationRun& run, const CertifyOptions& options,
                      const std::function<bool()>& go_on);

}  // namespace voroproof::internal
