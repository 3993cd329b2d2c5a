#include "core/values/evaluated_values.h"

#include "core/values/expression_words.h"
#include "core/values/number_text.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fff {

namespace {

std::size_t at(int index)
{
    return static_cast<std::size_t>(index);
}

/// Whether the same graph holds for both: alike in all but what is typed around the names.
bool isSameGraph(const Values &a, const Values &b)
{
    const auto isSame = [](const ValuePointer &one, const ValuePointer &other) {
        if (one == other)
            return true;
        if (one->value.id != other->value.id || one->folded != other->folded ||
            one->typed.has_value() != other->typed.has_value())
            return false;
        return !one->typed || one->typed->names() == other->typed->names();
    };
    return std::equal(a.list.begin(), a.list.end(), b.list.begin(), b.list.end(), isSame);
}

TextRange allOf(const Value &value)
{
    return {0, value.typed.size()};
}

std::optional<ExpressionError> rangeError(const Value &value, const Worth &worth)
{
    const Named typed = quoted(value.typed, allOf(value));
    const auto said = [&](const Text &text, double bound) {
        Worth other = worth;
        other.number = bound;
        return ExpressionError{{text, {typed, argumentOf(worth), argumentOf(other)}}, allOf(value)};
    };
    if (worth.type == Worth::Type::Number) {
        const double slack = kSameNumber * std::max(1.0, std::abs(worth.number));
        if (value.range.least && worth.number < *value.range.least - slack)
            return said(expression_words::kBelowRange, *value.range.least);
        if (value.range.most && worth.number > *value.range.most + slack)
            return said(expression_words::kAboveRange, *value.range.most);
    }
    const bool isOther =
        value.kind == ValueKind::Choice &&
        std::find(value.choices.begin(), value.choices.end(), worth.text) == value.choices.end();
    if (isOther)
        return ExpressionError{
            {expression_words::kNoChoice, {typed, quoted(worth.text, {0, worth.text.size()})}},
            allOf(value)};
    return std::nullopt;
}

} // namespace

EvaluatedValues EvaluatedValues::of(const Values &values, const EvaluatedValues &previous)
{
    EvaluatedValues result;
    if (values.list.empty())
        return result;
    result.m_values = values;
    if (previous.m_graph && isSameGraph(values, previous.m_values)) {
        result.m_graph = previous.m_graph;
        result.m_indices = previous.m_indices;
    } else {
        result.m_graph = std::make_shared<const ValueGraph>(graphOf(values));
        std::vector<std::pair<ValueId, int>> indices;
        for (std::size_t i = 0; i < values.list.size(); ++i)
            indices.emplace_back(values.list[i]->value.id, static_cast<int>(i));
        std::sort(indices.begin(), indices.end());
        result.m_indices =
            std::make_shared<const std::vector<std::pair<ValueId, int>>>(std::move(indices));
    }
    result.m_outcomes.resize(values.list.size());
    for (const int index : result.m_graph->order) {
        const int before = previous.indexOf(values.list[at(index)]->value.id);
        OutcomePointer &outcome = result.m_outcomes[at(index)];
        if (before >= 0 && result.isUnchanged(index, before, previous)) {
            outcome = previous.m_outcomes[at(before)];
            continue;
        }
        ++result.m_workedOut;
        outcome = std::make_shared<const Outcome>(Outcome{result.outcomeOf(index)});
        // What depends on it does not change with it.
        if (before >= 0 && previous.m_outcomes[at(before)]->worth == outcome->worth)
            outcome = previous.m_outcomes[at(before)];
    }
    return result;
}

/// All that it is made of has been looked at.
bool EvaluatedValues::isUnchanged(int index, int before, const EvaluatedValues &previous) const
{
    const std::vector<int> &uses = m_graph->uses[at(index)];
    const std::vector<int> &used = previous.m_graph->uses[at(before)];
    if (m_values.list[at(index)] != previous.m_values.list[at(before)] ||
        m_graph->isInCircle[at(index)] || previous.m_graph->isInCircle[at(before)] ||
        uses.size() != used.size())
        return false;
    const auto firstOf = [](const EvaluatedValues &values, int i) {
        return values.m_graph->byName.find(values.m_values.list[at(i)]->folded)->second == i;
    };
    if (m_graph != previous.m_graph && firstOf(*this, index) != firstOf(previous, before))
        return false;
    for (std::size_t i = 0; i < uses.size(); ++i)
        if (m_values.list[at(uses[i])]->value.id != previous.m_values.list[at(used[i])]->value.id ||
            m_outcomes[at(uses[i])] != previous.m_outcomes[at(used[i])])
            return false;
    return true;
}

Understood<Worth> EvaluatedValues::outcomeOf(int index) const
{
    const KnownValue &known = *m_values.list[at(index)];
    if (m_graph->byName.find(known.folded)->second != index)
        return misunderstood(expression_words::kNamedTwice, allOf(known.value),
                             {Named{known.value.name}});
    if (!known.typed)
        return tl::unexpected(known.typed.error());
    if (!m_graph->circles[at(index)].empty())
        return tl::unexpected(circleOf(index));
    return expressionOf(known, index);
}

Understood<Worth> EvaluatedValues::expressionOf(const KnownValue &known, int index) const
{
    for (const int used : m_graph->uses[at(index)]) {
        // In the same circle it has not been looked at.
        const OutcomePointer &outcome = m_outcomes[at(used)];
        if (outcome && outcome->worth)
            continue;
        const KnownValue &cause = *m_values.list[at(used)];
        ExpressionError error{{expression_words::kFollows, {Named{cause.value.name}}},
                              known.typed->placeOf(cause.folded),
                              true};
        return tl::unexpected(std::move(error));
    }
    const Names lookUp = [this](std::string_view name) -> const Worth * {
        const auto found = m_graph->byName.find(name);
        return found == m_graph->byName.end() ? nullptr : &*m_outcomes[at(found->second)]->worth;
    };
    Understood<Worth> worth = known.typed->worth(lookUp);
    if (worth)
        if (auto error = rangeError(known.value, *worth))
            return tl::unexpected(*std::move(error));
    return worth;
}

ExpressionError EvaluatedValues::circleOf(int index) const
{
    std::string path;
    for (const int member : m_graph->circles[at(index)])
        path += (member < 0 ? "\u2026" : m_values.list[at(member)]->value.name) + " \u2192 ";
    path += m_values.list[at(index)]->value.name;
    const int next =
        m_graph->circles[at(index)].size() > 1 ? m_graph->circles[at(index)][1] : index;
    return {{expression_words::kCircle, {Named{std::move(path)}}},
            m_values.list[at(index)]->typed->placeOf(m_values.list[at(next)]->folded)};
}

int EvaluatedValues::indexOf(ValueId id) const
{
    if (!m_indices)
        return -1;
    const auto found = std::lower_bound(m_indices->begin(), m_indices->end(), std::pair(id, -1));
    return found == m_indices->end() || found->first != id ? -1 : found->second;
}

std::vector<ValueId> EvaluatedValues::idsOf(std::span<const int> indices) const
{
    std::vector<ValueId> ids;
    for (const int index : indices)
        ids.push_back(m_values.list[at(index)]->value.id);
    return ids;
}

const Worth *EvaluatedValues::worth(ValueId id) const
{
    const int index = indexOf(id);
    return index < 0 || !m_outcomes[at(index)]->worth ? nullptr : &*m_outcomes[at(index)]->worth;
}

const ExpressionError *EvaluatedValues::error(ValueId id) const
{
    const int index = indexOf(id);
    return index < 0 || m_outcomes[at(index)]->worth ? nullptr
                                                     : &m_outcomes[at(index)]->worth.error();
}

std::vector<ValueId> EvaluatedValues::wrong() const
{
    std::vector<ValueId> ids;
    for (const bool isFollowing : {false, true})
        for (std::size_t i = 0; i < m_outcomes.size(); ++i)
            if (!m_outcomes[i]->worth && m_outcomes[i]->worth.error().isFollowing == isFollowing)
                ids.push_back(m_values.list[i]->value.id);
    return ids;
}

std::vector<ValueId> EvaluatedValues::uses(ValueId id) const
{
    const int index = indexOf(id);
    return index < 0 ? std::vector<ValueId>() : idsOf(m_graph->uses[at(index)]);
}

std::vector<ValueId> EvaluatedValues::users(ValueId id) const
{
    const int index = indexOf(id);
    return index < 0 ? std::vector<ValueId>() : idsOf(m_graph->users[at(index)]);
}

std::vector<ValueId> EvaluatedValues::dependents(ValueId id) const
{
    const int index = indexOf(id);
    if (index < 0)
        return {};
    std::vector<bool> depends(m_outcomes.size());
    std::vector<int> reached{index};
    for (std::size_t i = 0; i < reached.size(); ++i)
        for (const int user : m_graph->users[at(reached[i])])
            if (!depends[at(user)] && user != index) {
                depends[at(user)] = true;
                reached.push_back(user);
            }
    std::vector<int> ordered;
    for (const int i : m_graph->order)
        if (depends[at(i)])
            ordered.push_back(i);
    return idsOf(ordered);
}

Names EvaluatedValues::names() const
{
    return [graph = m_graph, outcomes = m_outcomes](std::string_view name) -> const Worth * {
        if (!graph)
            return nullptr;
        const auto found = graph->byName.find(name);
        if (found == graph->byName.end() || !outcomes[at(found->second)]->worth)
            return nullptr;
        return &*outcomes[at(found->second)]->worth;
    };
}

} // namespace fff
