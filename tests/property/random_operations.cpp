#include "tests/property/random_operations.h"

#include <fmt/format.h>

#include <vector>

#include "tests/process/process.h"

namespace jrule::property {

namespace {

// The body of one operation: variables by their types, as far as they are known at the place that is written.
struct Author {
  Random& random;
  std::size_t number;  // of the operation
  std::string text{};
  std::size_t next = 0;
  std::vector<std::string> darts{"d"}, integers{"n"};
  std::vector<std::string> splits{};  // results of `split`
  int budget = 14;                    // of statements

  std::string fresh(char const* kind) { return fmt::format("{}{}", kind, next++); }

  std::string dart() {
    std::size_t const kind = random.below(10);
    if (!splits.empty() && kind < 2) return random.pick(splits) + ".b";
    if (!splits.empty() && kind == 2) return fmt::format("{}.b[{}]", random.pick(splits), random.pick(darts));
    if (kind < 6) return fmt::format("{}@{}", random.pick(darts), random.pick<std::string>({"0", "1", "2", "[0,1]", "[1,2,1]"}));
    return random.pick(darts);
  }
  std::string orbit() {
    return fmt::format("{}({}){}", random.pick<std::string>({"<0,1>", "<1,2>", "<0>", "connected"}), random.pick(darts), "");
  }
  std::string integer() {
    switch (random.below(7)) {
      case 0: return fmt::format("{}", random.below(5));
      case 1: return fmt::format("count(<0,1>({}) by <0>)", dart());
      case 2: return dart() + ".n";
      case 3: return fmt::format("{} + {}", random.pick(integers), random.pick(integers));
      case 4: return fmt::format("sum(v.n for v in connected({}) by face)", random.pick(darts));
      case 5: return fmt::format("(if {} then {} else {})", truth(), random.pick(integers), random.below(9));
      default: return random.pick(integers);
    }
  }
  std::string truth() {
    switch (random.below(4)) {
      case 0: return fmt::format("{} == {}", random.pick(darts), dart());
      case 1: return fmt::format("{}@2 != {}", random.pick(darts), random.pick(darts));
      case 2: return fmt::format("mean(<0,1>({}).position).x < {} and {} < 9", random.pick(darts), random.below(4), random.pick(integers));
      default: return fmt::format("{} < {}", random.pick(integers), random.below(8));
    }
  }
  std::string call() {
    switch (random.below(9)) {
      case 0: return fmt::format("triangle({})", random.below(2) == 0 ? "" : random.pick(integers));
      case 1: return fmt::format("split({})", dart());
      case 2: return fmt::format("touch({}, k: {})", dart(), integer());
      case 3: return fmt::format("touch_even(k: {}, f: {})", random.below(5), dart());
      case 4: return fmt::format("sew({}, {})", dart(), dart());
      case 5: return fmt::format("unsew({})", dart());
      case 6: return random.chance(30) ? fmt::format("remove_face({})", dart()) : fmt::format("touch({})", dart());
      default: return number == 0 ? fmt::format("touch({})", dart()) : fmt::format("f{}({}, {})", random.below(number), dart(), random.below(4));
    }
  }

  // What is declared in a block is forgotten behind it.
  void block(int most) {
    auto const outside = std::tuple(darts, integers, splits);
    text += "{\n";
    for (int i = 0; i < most && budget > 0; ++i) statement();
    text += "}";
    std::tie(darts, integers, splits) = outside;
  }

  void statement() {
    --budget;
    switch (random.below(15)) {
      case 0:
      case 1: {
        std::string const value = integer(), name = fresh("i");
        text += fmt::format("let {} = {};\n", name, value);
        integers.push_back(name);
        return;
      }
      case 2: {
        std::string const value = dart(), name = fresh("x");
        text += fmt::format("let {} = {};\n", name, value);
        darts.push_back(name);
        return;
      }
      case 3: {
        std::string const at = dart(), name = fresh("r");
        text += fmt::format("let {} = split({});\n", name, at);
        splits.push_back(name);
        return;
      }
      case 4: {
        std::string const name = fresh("t");
        text += fmt::format("let {} = triangle({});\nlet {}d = {}.a;\n", name, random.below(5), name, name);
        darts.push_back(name + "d");
        return;
      }
      case 5:
        if (random.chance(50)) {
          text += fmt::format("{} = {};\n", random.pick(integers), integer());
        } else if (!splits.empty() && random.chance(50)) {
          text += fmt::format("{} = split({});\n", random.pick(splits), dart());
        } else {
          text += fmt::format("{} = {};\n", random.pick(darts), dart());
        }
        return;
      case 6:
        text += fmt::format("if {} ", truth());
        block(3);
        if (random.chance(60)) {
          text += " else ";
          block(3);
        }
        text += "\n";
        return;
      case 7: {
        std::string const name = fresh("e");
        text += fmt::format("for {} in {} by {} ", name, fmt::format("<0,1>({})", random.pick(darts)), random.pick<std::string>({"<0>", "<>", "<1>"}));
        auto const outside = darts;
        darts.push_back(name);
        block(3);
        darts = outside;
        text += "\n";
        return;
      }
      case 8: {
        std::string const name = fresh("w");
        text += fmt::format("let {0} = 0;\nwhile {0} < {1} ", name, random.between(1, 3));
        text += "{\n" + name + " = " + name + " + 1;\n";
        auto const outside = std::tuple(darts, integers, splits);
        for (int i = 0; i < 2 && budget > 0; ++i) statement();
        std::tie(darts, integers, splits) = outside;
        text += "}\n";
        return;
      }
      case 9:
      case 10:
        text += "try ";
        block(4);
        text += " else ";
        block(2);
        text += "\n";
        return;
      case 11: text += fmt::format("apply_all {} on {};\n", random.pick<std::string>({"touch()", "touch_even(2)", "remove_face()"}), random.pick<std::string>({fmt::format("connected({})", random.pick(darts)), fmt::format("<0,1>({})", dart())})); return;
      case 12:
        if (random.chance(30)) {
          text += fmt::format("if {} {{ fail \"no {}\"; }}\n", truth(), random.below(10));
        } else if (random.chance(20)) {
          text += fmt::format("if {} {{ return {}; }}\n", truth(), integer());
        }
        return;
      default: text += call() + ";\n";
    }
  }
};

}  // namespace

std::string random_operations(std::size_t count, Random& random) {
  std::string text = tests::read(JRULE_SOURCE_DIR "/tests/data/polygons.jrule");
  for (std::size_t i = 0; i < count; ++i) {
    Author author{random, i};
    author.text = fmt::format("operation f{}(d: Dart, n: Int) on S -> Int {{\n", i);
    while (author.budget > 0) author.statement();
    text += author.text + fmt::format("return {};\n}}\n", author.integer());
  }
  return text;
}

}  // namespace jrule::property
