// The strong guarantee, by exhaustion: an application fails at each place where it may, and each time the map is bit for bit
// what it was, and the application then succeeds as if nothing had been.
//
// A subject is a copyable object with a `map()`: a generated modeler, or Interpreted. `apply(subject)` returns a Result.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "jrule/result.h"
#include "tests/integration/allocations.h"
#include "tests/integration/contents.h"

namespace jrule::test {

/// A copy of the subject to which the rule has been applied; fails the test if it is not applicable.
template <class Subject, class Apply>
Subject applied(Subject subject, Apply const& apply) {
  auto const result = apply(subject);
  EXPECT_TRUE(result) << to_string(result.error());
  return subject;
}

/// After a failure: is the subject what it was, and does the application succeed now?
template <class Subject, class Apply>
void expect_unharmed(Subject& subject, Apply const& apply, Contents const& before, Contents const& after, Describe describe) {
  ASSERT_TRUE(contents(subject.map(), describe) == before);
  auto const result = apply(subject);
  ASSERT_TRUE(result) << to_string(result.error());
  ASSERT_TRUE(contents(subject.map(), describe) == after);
}

/// Each allocation of the application fails, alone or with all that follow, which is returned as Kind::no_memory. Returns how
/// many they are.
template <class Subject, class Apply>
std::size_t every_allocation_fails(Subject const& start, Apply const& apply, Fail how, Describe describe = nullptr) {
  Contents const before = contents(start.map(), describe), after = contents(applied(start, apply).map(), describe);
  for (std::size_t k = 1;; ++k) {
    SCOPED_TRACE("allocation " + std::to_string(k));
    Subject subject = start;
    FailingAllocation failing(k, how);
    auto const result = apply(subject);
    if (!failing.stop()) {
      EXPECT_TRUE(contents(subject.map(), describe) == after);
      return k - 1;
    }
    if (result) {
      // It was for what can wait: values that no dart has any more are dropped another time.
      EXPECT_TRUE(equal_but_for_handles(contents(subject.map(), describe), after));
    } else {
      EXPECT_EQ(result.error().kind, Error::Kind::no_memory) << to_string(result.error());
      expect_unharmed(subject, apply, before, after, describe);
    }
    if (testing::Test::HasFatalFailure()) return k;
  }
}

}  // namespace jrule::test
