#include "tests/property/random_operations.h"

#include <fmt/format.h>

#include <vector>

namespace jrule::property {

namespace {

char const rules[] = R"(
modeler S on gmap(2) {
  embedding position : vertex -> Point3 { merge mean; }
  embedding n        : face -> Int { default 0; merge max; }
}
rule triangle(x: Real = 0) on S {
  left { }
  right {
    a { position = Point3(x, 0, 0); } b { position = Point3(x + 1, 0, 0); } c; d { position = Point3(x, 1, 0); } e; f;
    a -0- b -1- c -0- d -1- e -0- f -1- a;
    a -2- a; b -2- b; c -2- c; d -2- d; e -2- e; f -2- f;
  }
}
rule split on S {
  left { hook a <0,2>; }
  right { a <_,2>; b <1,2> { position = mean(<0>(a).position); } a -0- b; }
}
rule touch(k: Int = 1) on S {
  left { hook f <0,1>; }
  right { f { n = f.n + k; } }
}
rule touch_even(k: Int) on S {
  left { hook f <0,1>; let m = f.n + k; require m < 12; }
  right { f { n = m; } }
}
rule sew on S {
  left { hook a <0>; hook b <0>; a -2- a; b -2- b; }
  right { a; b; a -2- b; }
}
rule unsew on S {
  left { hook a <0>; b <0>; a -2- b; }
  right { a; b; a -2- a; b -2- b; }
}
rule remove_face on S {
  left { hook a <0,1>; a -2- a; }
  right { }
}
)";

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
  std::string text = rules;
  for (std::size_t i = 0; i < count; ++i) {
    Author author{random, i};
    author.text = fmt::format("operation f{}(d: Dart, n: Int) on S -> Int {{\n", i);
    while (author.budget > 0) author.statement();
    text += author.text + fmt::format("return {};\n}}\n", author.integer());
  }
  return text;
}

}  // namespace jrule::property
