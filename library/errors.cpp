#include "voroproof/error.h"

#include <utility>

#include "certify/certifier.h"
#include "exact/patience.h"
#include "exact/tower.h"
#include "filtered/motion/options.h"
#include "history/error.h"
#include "library/values.h"

namespace voroproof {

Error::~Error() = default;

InputError::InputError(const std::string& what, std::string file, std::int64_t line,
                       std::string field, std::string reason)
    : Error(what),
      file_(std::move(file)),
      line_(line),
      field_(std::move(field)),
      reason_(std::move(reason)) {}
InputError::~InputError() = default;
OutputError::~OutputError() = default;
Undecided::~Undecided() = default;
Interrupted::~Interrupted() = default;

namespace internal {

void rethrow_public() {
  try {
    throw;
  } catch (const InputError& error) {
    throw voroproof::InputError(error.what(), error.file(), error.line(), error.field(),
                                error.reason());
  } catch (const OutputError& error) {
    throw voroproof::OutputError(error.what());
  } catch (const Undecided& error) {
    throw voroproof::Undecided(error.what());
  } catch (const BudgetExceeded& error) {
    throw voroproof::Undecided(error.what());
  } catch (const Interrupted& error) {
    throw voroproof::Interrupted(error.what());
  } catch (const GivenUp& error) {
    throw voroproof::Interrupted(error.what());
  } catch (const CertificationInterrupted&) {
    throw voroproof::Interrupted("interrupted");
  }
}

}  // namespace internal
}  // namespace voroproof
