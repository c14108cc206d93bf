// Expressions written as text in the place of a rule's or of a default's.
#pragma once

#include <gtest/gtest.h>

#include <tuple>

#include "compiler/sema/expressions.h"
#include "compiler/sema/types.h"
#include "compiler/syntax/parse.h"

namespace jrule::sema {

using ir::ExprPtr;

inline ir::ExprType one(Type type) { return {type, false, false, {}}; }
inline ir::ExprType list_of(Type type) { return {type, true, false, {}}; }

// A rule on 3-G-maps with a name for a value of each type: left nodes `a` and `b`, of which `b` is deleted, and `c`,
// which is added. The typed tree of an expression in its place, or in a default's where there is no rule.
class Expressions : public testing::Test {
 protected:
  Expressions() : group_(gmap(3)) {
    auto modeler = std::make_shared<ir::Modeler>();
    modeler->name = "M";
    modeler->model = gmap(3);
    OrbitType const vertex = orbit_of_dimensions({1, 2, 3}), edge = orbit_of_dimensions({0, 2, 3});
    for (auto const& [name, orbit, type] : {std::tuple{"position", vertex, Type::Point3},
                                            {"uv", vertex, Type::Point2},
                                            {"color", edge, Type::Color},
                                            {"mark", edge, Type::Bool},
                                            {"level", vertex, Type::Int},
                                            {"weight", vertex, Type::Real},
                                            {"normal", orbit_of_dimensions({}), Type::Vec3},
                                            {"tangent", edge, Type::Vec2},
                                            {"twisted", OrbitType{{{{2}, {0}}, {{1}}}}, Type::Real}}) {
      EmbeddingSpec spec;
      spec.name = name;
      spec.orbit = orbit;
      spec.type = type;
      modeler->embeddings.push_back(std::move(spec));
    }
    rule_.modeler = modeler;
    rule_.parameters = {{"flag", Type::Bool, {}}, {"n", Type::Int, {}},    {"h", Type::Real, {}},
                        {"u2", Type::Vec2, {}},   {"u3", Type::Vec3, {}},  {"p2", Type::Point2, {}},
                        {"p3", Type::Point3, {}}, {"red", Type::Color, {}}};
    rule_.nodes.resize(3);
    rule_.nodes[0].name = "a";
    rule_.nodes[1].name = "b";
    rule_.nodes[2].name = "c";
    rule_.nodes[0].left_span = rule_.nodes[1].left_span = source::Span{0, 0, 0};
    rule_.nodes[0].right_span = rule_.nodes[2].right_span = added_;
    dimensions_["i"] = 2;
  }

  ast::ExprPtr parse(std::string const& text) {
    std::string const before = "modeler M on gmap(2) { embedding e : <> -> Real { default ";
    auto const file = sources_.add("test.jrule", before + text + "; } }");
    source::Diagnostics syntax;
    ast::File const ast = syntax::parse(sources_, file, syntax);
    if (ast.items.size() != 1) return {};
    return std::get<ast::Modeler>(ast.items.front()).embeddings.front().default_value;
  }

  ExprPtr check(std::string const& text, std::optional<ir::ExprType> expected = {}) {
    diagnostics_ = {};
    ast::ExprPtr const expr = parse(text);
    EXPECT_TRUE(expr) << text;
    return expr ? check_expression(*expr, {&rule_, &group_, &dimensions_}, expected, diagnostics_) : nullptr;
  }

  std::string print(std::string const& text) {
    ExprPtr const expr = check(text);
    return expr ? ir::print(*expr, rule_) : all_messages();
  }

  std::string all_messages() const {
    std::string text;
    for (auto const& d : diagnostics_.all()) text += std::string(info(d.code).number) + ": " + d.message + "\n";
    return text;
  }

  void expect_type(std::string const& text, ir::ExprType type) {
    ExprPtr const expr = check(text);
    ASSERT_TRUE(expr) << text << ": " << all_messages();
    EXPECT_EQ(to_string(expr->type), to_string(type)) << text;
    EXPECT_TRUE(diagnostics_.all().empty()) << text << ": " << all_messages();
    EXPECT_EQ(sources_.text(expr->span), text);
  }

  // What a diagnostic says, in one text: "J0240 `span`: message", then "| `span`: label" and "= note".
  std::string show(source::Diagnostic const& d) const {
    auto const place = [&](source::Span span) {
      return span == added_ ? std::string("(c)") : "`" + std::string(sources_.text(span)) + "`";
    };
    std::string text = std::string(info(d.code).number) + " " + place(d.span) + ": " + d.message + "\n";
    for (auto const& label : d.labels) text += "| " + place(label.span) + ": " + label.text + "\n";
    for (auto const& note : d.notes) text += "= " + note + "\n";
    for (auto const& fix : d.fixits) text += "+ " + place(fix.span) + " -> `" + fix.replacement + "`\n";
    return text;
  }
  std::string show_all() const {
    std::string text;
    for (auto const& d : diagnostics_.all()) text += show(d);
    return text;
  }
  std::string errors(std::string const& text, std::optional<ir::ExprType> expected = {}) {
    EXPECT_FALSE(check(text, expected)) << text;
    return show_all();
  }

  std::optional<Value> constant(std::string const& text, Type type) {
    diagnostics_ = {};
    ast::ExprPtr const expr = parse(text);
    EXPECT_TRUE(expr) << text;
    if (!expr) return {};
    auto const value = evaluate_default(*expr, one(type), {}, diagnostics_);
    return value ? value->value : std::nullopt;
  }
  std::string constant_errors(std::string const& text, Type type) {
    EXPECT_FALSE(constant(text, type)) << text;
    return show_all();
  }

  source::Sources sources_;
  source::Diagnostics diagnostics_;
  source::Span const added_{99, 1, 2};
  algebra::Group group_;
  DimensionValues dimensions_;
  ir::RuleScheme rule_;
};

}  // namespace jrule::sema
