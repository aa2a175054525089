// The second checker beside the first: `certify --kernel`.
#pragma once

#include <functional>
#include <string>

#include "certify/certifier.h"

namespace voroproof::internal {

// Has the kernel (docs/kernel.md) judge the same files under the same options, in a process of its
// own, and makes the
// certificate that of both: certified only where both certify, undecided where the kernel does not
// decide what the certifier certified. Gives what the kernel said, in one line. Several times a
// second asks whether to `go_on`; where not, the kernel is ended and nothing is given. Throws
// std::logic_error, with both verdicts and the names of the files, where one of the two certifies
// what the other refutes or cannot read; and UsageError for files that the kernel does not read.
std::string judged_by_kernel(Certificate& certificate, const std::string& scene_path,
                             const std::string& history_path, const CertifyOptions& options,
                             const std::function<bool()>& go_on);

}  // namespace voroproof::internal
