// The answer to a query: JSON for programs (docs/formats.md, section 12), a table for people.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "exact/enclosure.h"
#include "exact/names.h"
#include "history/scene.h"
#include "library/queries/clearance.h"

namespace voroproof::internal {

using OrderedJson = nlohmann::ordered_json;

struct Answer {
  OrderedJson json;   // an object
  std::string table;  // lines
};

// The head of every answer.
OrderedJson answer_head(const std::string& query, const Scene& scene);

OrderedJson json_of(double x);
OrderedJson json_of(const Rational& q);
OrderedJson json_of(const Enclosure& e);  // [lo, hi]
OrderedJson json_of(const Quad& q);
OrderedJson json_of(const Triple& v);
OrderedJson json_of(
    const ClearanceNode& node);  // {"vertex": [i,j,k]}, {"gate": [i,j]} or {"far": i}

// A short text; an enclosure is given by about its middle.
std::string short_text(const Enclosure& e);
std::string short_text(double x);
std::string short_text(const ClearanceNode& node);
std::string text_of(GenId g);  // "wall" for the container

// Columns, as wide as their widest cell; the first row is the heading.
std::string table_of(const std::vector<std::vector<std::string>>& rows);

// Prints the table to `out`, and writes the JSON to the file where one is named. Throws
// OutputError.
void give(const Answer& answer, const std::string& path, std::ostream& out);

}  // namespace voroproof::internal
