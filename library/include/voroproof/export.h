// The mark of all that the library exports. Everything else of it is hidden.
#pragma once

#if defined(_WIN32)
#error "voroproof is built for systems with ELF libraries"
#endif
#define VOROPROOF_API __attribute__((visibility("default")))
