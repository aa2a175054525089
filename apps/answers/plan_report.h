// The report of a plan and of its certain clearance, as JSON (docs/formats.md).
#pragma once

#include <string>

#include "library/planning/planner.h"

namespace voroproof::internal {

struct PlanRun {
  std::string producer;
  std::string assignment;    // "given" or "optimal"
  std::string scene_sha256;  // hash of the scene file; empty where none was written
};

std::string plan_report_text(const PlanRun& run, const PlanResult& result);

}  // namespace voroproof::internal
