// A report of certify as the certificate that it was written from.
#pragma once

#include "certify/report.h"
#include "library/json_field.h"

namespace voroproof::internal {

// All throw InputError where the report is none. A report does not hold what the certifier counts
// of its own work (Certificate::tiers): that is left empty.
Certificate read_certificate(const JsonField& report);
CertificationRun read_run(const JsonField& report);
// The options that a report states; the others are as they are by default.
CertifyOptions read_options(const JsonField& report);

// A whole number that counts something: none of as many as there may be reports sums up to more
// than 2^63.
std::int64_t read_count(const JsonField& field);
Rational read_exact(const JsonField& field);

}  // namespace voroproof::internal
