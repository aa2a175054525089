// Writes wrong worlds as files, for checkers that are no part of this program.
//
// usage: write_worlds DIRECTORY COUNT [SEED]
//
// DIRECTORY/K.scene.json and K.history.jsonl of the first COUNT seeds K from SEED on that make one.
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>

#include "tests/adversary/campaign.h"

int main(int argc, char** argv) {
  using namespace voroproof::internal::adversary;
  if (argc < 3) {
    std::cerr << "usage: write_worlds DIRECTORY COUNT [SEED]\n";
    return 2;
  }
  const std::filesystem::path directory = argv[1];
  const int count = std::stoi(argv[2]);
  std::filesystem::create_directories(directory);
  std::uint64_t seed = argc > 3 ? std::stoull(argv[3]) : 1;
  for (int written = 0; written < count; ++seed) {
    Recipe recipe = recipe_of(seed, {}, {});
    recipe.units = {};  // with the usual tolerance
    const auto made = make(recipe);
    const auto scene = made ? read(*made) : std::nullopt;
    if (!scene) continue;
    const std::string stem = (directory / std::to_string(seed)).string();
    std::ofstream(stem + ".scene.json") << scene->text;
    std::ofstream(stem + ".history.jsonl")
        << history_text(made->history, scene->scene.sha256, made->recipe.long_decimals);
    ++written;
  }
  return 0;
}
