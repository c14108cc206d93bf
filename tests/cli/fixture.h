// A folder of its own for each test, in which `jrule` runs.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/process/process.h"

namespace jrule::tests {

class CommandLine : public ::testing::Test {
 protected:
  CommandLine() {
    auto const* const test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::temp_directory_path() /
              ("jrule-" + std::string(test->name()) + "-" + std::to_string(getpid()));
    std::filesystem::create_directories(folder_);
  }
  ~CommandLine() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path const& folder() const { return folder_; }
  void file(std::string const& name, std::string const& text) const { write(folder_ / name, text); }
  std::string content(std::string const& name) const { return read(folder_ / name); }

  Outcome jrule(std::vector<std::string> words) const {
    words.insert(words.begin(), JRULE_EXECUTABLE);
    return run(folder_, words);
  }
  /// The names in the folder, sorted: what a command left there.
  std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (auto const& entry : std::filesystem::directory_iterator(folder_)) names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
  }

  static std::string demo(std::string const& name) { return JRULE_SOURCE_DIR "/examples/demo/" + name; }
  static std::string bunny() { return JRULE_SOURCE_DIR "/examples/data/bunny.obj"; }

 private:
  std::filesystem::path folder_;
};

}  // namespace jrule::tests
