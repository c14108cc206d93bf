#include "compiler/ir/program.h"

#include <algorithm>
#include <iterator>
#include <set>

namespace jrule::ir {

namespace {

template <class... Functions>
struct Overloaded : Functions... {
  using Functions::operator()...;
};

bool is_always_true(ExprPtr const& condition) {
  auto const* constant = std::get_if<Constant>(&condition->value);
  return constant && constant->value == Value{true};
}

std::vector<ExprPtr> join(std::vector<ExprPtr> first, std::vector<ExprPtr> const& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

std::vector<ExprPtr> expressions(Origin const& origin) {
  return std::visit(Overloaded{[](ExprPtr const& value) { return std::vector{value}; },
                               [](RuleCall const& call) { return join(call.darts, call.values); },
                               [](OperationCall const& call) { return call.arguments; }},
                    origin);
}

}  // namespace

bool ends(Block const& block) {
  return std::any_of(block.begin(), block.end(), [](Statement const& s) { return ends(s); });
}

bool ends(Statement const& statement) {
  return std::visit(Overloaded{[](Return const&) { return true; }, [](Fail const&) { return true; },
                               [](If const& s) { return ends(s.then_block) && ends(s.else_block); },
                               [](Try const& s) { return ends(s.body) && ends(s.otherwise); },
                               // There is no way out of a loop but its condition, `return` and `fail`.
                               [](While const& s) { return is_always_true(s.condition); },
                               [](auto const&) { return false; }},
                    statement.value);
}

std::vector<Block const*> blocks(Statement const& statement) {
  using Blocks = std::vector<Block const*>;
  return std::visit(Overloaded{[](If const& s) { return Blocks{&s.then_block, &s.else_block}; },
                               [](For const& s) { return Blocks{&s.body}; }, [](While const& s) { return Blocks{&s.body}; },
                               [](Try const& s) { return Blocks{&s.body, &s.otherwise}; },
                               [](auto const&) { return Blocks{}; }},
                    statement.value);
}

std::vector<ExprPtr> expressions(Statement const& statement) {
  using List = std::vector<ExprPtr>;
  return std::visit(Overloaded{[](Set const& s) { return expressions(s.value); },
                               [](Do const& s) { return expressions(s.call); },
                               [](If const& s) { return List{s.condition}; }, [](For const& s) { return List{s.over.at}; },
                               [](While const& s) { return List{s.condition}; },
                               [](Return const& s) { return s.value ? expressions(*s.value) : List{}; },
                               [](ApplyAll const& s) { return join(s.values, {s.at}); },
                               [](auto const&) { return List{}; }},
                    statement.value);
}

Origin const* origin(Statement const& statement) {
  auto const called = [](Origin const& o) { return std::holds_alternative<ExprPtr>(o) ? nullptr : &o; };
  return std::visit(Overloaded{[&](Set const& s) { return called(s.value); }, [&](Do const& s) { return called(s.call); },
                               [&](Return const& s) { return s.value ? called(*s.value) : nullptr; },
                               [](auto const&) -> Origin const* { return nullptr; }},
                    statement.value);
}

std::vector<Called> calls(Block const& block) {
  std::vector<Called> all;
  for (Statement const& statement : block) {
    if (Origin const* const o = origin(statement)) {
      auto const* rule = std::get_if<RuleCall>(o);
      auto const* operation = std::get_if<OperationCall>(o);
      all.push_back(rule ? Called{true, rule->rule, rule->span} : Called{false, operation->operation, operation->span});
    }
    if (auto const* everywhere = std::get_if<ApplyAll>(&statement.value)) all.push_back({true, everywhere->rule, everywhere->span});
    for (Block const* inner : blocks(statement)) {
      for (Called const& called : calls(*inner)) all.push_back(called);
    }
  }
  return all;
}

namespace {

// Those that it declares, and those that it assigns to.
void collect_sets(Block const& block, std::set<std::size_t>& declared, std::set<std::size_t>& assigned) {
  for (Statement const& statement : block) {
    if (auto const* set = std::get_if<Set>(&statement.value)) (set->declares ? declared : assigned).insert(set->variable);
    if (auto const* loop = std::get_if<For>(&statement.value)) declared.insert(loop->variable);
    for (Block const* inner : blocks(statement)) collect_sets(*inner, declared, assigned);
  }
}

}  // namespace

std::vector<std::size_t> assigned(Block const& block) {
  std::set<std::size_t> declared, assigned;
  collect_sets(block, declared, assigned);
  std::vector<std::size_t> outside;
  std::set_difference(assigned.begin(), assigned.end(), declared.begin(), declared.end(), std::back_inserter(outside));
  return outside;
}

std::vector<std::size_t> assigned_anywhere(Block const& block) {
  std::set<std::size_t> declared, assigned;
  collect_sets(block, declared, assigned);
  return {assigned.begin(), assigned.end()};
}

namespace {

void renumber(Block& block, std::vector<std::size_t> const& number) {
  auto const change = [&](Origin& o) {
    if (auto* call = std::get_if<OperationCall>(&o)) call->operation = number[call->operation];
  };
  for (Statement& statement : block) {
    std::visit(Overloaded{[&](Set& s) { change(s.value); }, [&](Do& s) { change(s.call); },
                          [&](Return& s) { if (s.value) change(*s.value); },
                          [&](If& s) { renumber(s.then_block, number); renumber(s.else_block, number); },
                          [&](For& s) { renumber(s.body, number); }, [&](While& s) { renumber(s.body, number); },
                          [&](Try& s) { renumber(s.body, number); renumber(s.otherwise, number); }, [](auto&) {}},
               statement.value);
  }
}

}  // namespace

void keep_operations(Program& program, std::vector<bool> good) {
  auto& operations = program.operations;
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i < operations.size(); ++i) {
      auto const all = calls(operations[i].body);
      bool const broken = std::any_of(all.begin(), all.end(), [&](Called const& c) { return !c.is_rule && !good[c.index]; });
      if (!good[i] || !broken) continue;
      good[i] = false;
      changed = true;
    }
  }
  std::vector<std::size_t> number(operations.size());
  std::vector<Operation> kept;
  for (std::size_t i = 0; i < operations.size(); ++i) {
    number[i] = kept.size();
    if (good[i]) kept.push_back(std::move(operations[i]));
  }
  for (Operation& operation : kept) renumber(operation.body, number);
  operations = std::move(kept);
}

RuleScheme expression_scope(Operation const& operation) {
  RuleScheme rule;
  rule.name = operation.name;
  rule.modeler = operation.modeler;
  return rule;
}

}  // namespace jrule::ir
