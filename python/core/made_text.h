// Scenes as text that Python has made of values.
#pragma once

#include <string>

#include "voroproof/error.h"

namespace voroproof::python {

// Calls read(), which reads such a text as "scene": its errors name no line.
template <class Read>
auto without_lines(Read&& read) {
  try {
    return read();
  } catch (const InputError& e) {
    const std::string field = e.field().empty() ? "" : e.field() + ": ";
    throw InputError("scene: " + field + e.reason(), e.file(), 0, e.field(), e.reason());
  }
}

}  // namespace voroproof::python
