// What all values come to, and who is made of whom.
#pragma once

#include "core/values/value_graph.h"

#include <memory>
#include <span>
#include <vector>

namespace fff {

/// A value, cheap to copy and safe to share between threads.
class EvaluatedValues
{
public:
    /// Nothing of no values.
    EvaluatedValues() = default;
    /// The same for any order of the list. `previous`, of other values or the same, saves work and
    /// changes nothing: only what changed is worked out, and what depends on it as far as that
    /// changes, too.
    static EvaluatedValues of(const Values &values, const EvaluatedValues &previous);
    static EvaluatedValues of(const Values &values) { return of(values, EvaluatedValues()); }

    /// Null where there is an error, or no such value.
    const Worth *worth(ValueId id) const;
    /// What is wrong with it: its text, a name, a kind, its range, a circle, or a value that it is
    /// made of (isFollowing). Null: nothing.
    const ExpressionError *error(ValueId id) const;
    /// Those with errors, the causes before what follows from them, each in the order of the list.
    std::vector<ValueId> wrong() const;

    /// What it is made of, directly, as first seen in its text.
    std::vector<ValueId> uses(ValueId id) const;
    /// What is made of it, directly; in the order of the list.
    std::vector<ValueId> users(ValueId id) const;
    /// All that changes with it, each before what is made of it; without itself.
    std::vector<ValueId> dependents(ValueId id) const;

    /// For the expressions of fields. Holds what it needs; names of values with errors are unknown
    /// there.
    Names names() const;

    const Values &values() const { return m_values; }
    /// How many were worked out, not taken over.
    int workedOutCount() const { return m_workedOut; }

private:
    struct Outcome
    {
        Understood<Worth> worth;
    };
    using OutcomePointer = std::shared_ptr<const Outcome>;

    int indexOf(ValueId id) const;
    std::vector<ValueId> idsOf(std::span<const int> indices) const;
    Understood<Worth> outcomeOf(int index) const;
    Understood<Worth> expressionOf(const KnownValue &known, int index) const;
    ExpressionError circleOf(int index) const;
    bool isUnchanged(int index, int before, const EvaluatedValues &previous) const;

    Values m_values;
    std::shared_ptr<const ValueGraph> m_graph;
    std::shared_ptr<const std::vector<std::pair<ValueId, int>>> m_indices; // ascending
    std::vector<OutcomePointer> m_outcomes;                                // as in the list
    int m_workedOut = 0;
};

} // namespace fff
