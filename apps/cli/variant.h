// A build for any x86-64 processor hands over to one for newer processors, where that is installed.
#pragma once

namespace voroproof::internal {

// Where this program is the one for any processor, the processor has what the other one is compiled
// for, and that is installed (packaging/cmake/Variants.cmake): becomes it, with the same arguments.
// Returns otherwise, and where the environment has VOROPROOF_VARIANT=baseline. Both give the same
// bytes.
void become_faster_variant(char** argv);

}  // namespace voroproof::internal
