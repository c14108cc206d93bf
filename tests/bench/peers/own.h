// What all contenders of our own share.
#pragma once

#include <map>
#include <memory>
#include <stdexcept>
#include <string>

#include "tests/bench/peers/contest.h"

namespace jrule::bench {

/// The cells by their orbits, if the row wants them.
Counts count_cells(Map const& map, Row const& row);

/// Throws what a Result says.
template <class Result>
void expect(Result const& result) {
  if (!result) throw std::runtime_error(to_string(result.error()));
}

/// One input for each mesh, made when it is first asked for, of which every repetition gets a copy.
template <class Input>
class Originals {
 public:
  template <class Make>
  Input const& operator()(std::string const& mesh, Make make) const {
    auto const found = inputs_->find(mesh);
    return found != inputs_->end() ? found->second : inputs_->emplace(mesh, make()).first->second;
  }

 private:
  std::shared_ptr<std::map<std::string, Input>> inputs_ = std::make_shared<std::map<std::string, Input>>();
};

}  // namespace jrule::bench
