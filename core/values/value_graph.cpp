#include "core/values/value_graph.h"

#include <algorithm>
#include <utility>

namespace fff {

namespace {

constexpr std::size_t kMostTold = 12; // of a circle: a sentence of hundreds of names says less

void addUses(ValueGraph &graph, const Values &values)
{
    const int count = static_cast<int>(values.list.size());
    for (int i = 0; i < count; ++i) {
        const KnownValue &known = *values.list[static_cast<std::size_t>(i)];
        const auto [at, isNew] = graph.byName.try_emplace(known.folded, i);
        if (!isNew && known.value.id < values.list[static_cast<std::size_t>(at->second)]->value.id)
            at->second = i;
    }
    graph.uses.resize(values.list.size());
    graph.users.resize(values.list.size());
    for (int i = 0; i < count; ++i) {
        const KnownValue &known = *values.list[static_cast<std::size_t>(i)];
        if (!known.typed)
            continue;
        for (const std::string &name : known.typed->names())
            if (const auto found = graph.byName.find(name); found != graph.byName.end()) {
                graph.uses[static_cast<std::size_t>(i)].push_back(found->second);
                graph.users[static_cast<std::size_t>(found->second)].push_back(i);
            }
    }
}

/// Strongly connected components, each after all that it uses.
class Components
{
public:
    explicit Components(const std::vector<std::vector<int>> &uses)
        : m_uses(uses), m_seen(uses.size(), -1), m_low(uses.size(), -1), m_isOpen(uses.size())
    {
    }

    std::vector<std::vector<int>> all()
    {
        for (std::size_t i = 0; i < m_uses.size(); ++i)
            if (m_seen[i] < 0)
                visit(static_cast<int>(i));
        return std::move(m_components);
    }

private:
    struct Step
    {
        int of = 0;
        std::size_t next = 0; // of its uses
    };

    static std::size_t at(int i) { return static_cast<std::size_t>(i); }

    void enter(int i)
    {
        m_seen[at(i)] = m_low[at(i)] = m_count++;
        m_isOpen[at(i)] = true;
        m_open.push_back(i);
        m_steps.push_back({i});
    }

    void visit(int root)
    {
        enter(root);
        while (!m_steps.empty()) {
            Step &step = m_steps.back();
            const int of = step.of;
            if (step.next < m_uses[at(of)].size()) {
                const int used = m_uses[at(of)][step.next++];
                if (m_seen[at(used)] < 0)
                    enter(used);
                else if (m_isOpen[at(used)])
                    m_low[at(of)] = std::min(m_low[at(of)], m_seen[at(used)]);
                continue;
            }
            m_steps.pop_back();
            if (!m_steps.empty()) {
                const int before = m_steps.back().of;
                m_low[at(before)] = std::min(m_low[at(before)], m_low[at(of)]);
            }
            if (m_low[at(of)] == m_seen[at(of)])
                close(of);
        }
    }

    void close(int first)
    {
        std::vector<int> component;
        do {
            component.push_back(m_open.back());
            m_isOpen[at(m_open.back())] = false;
            m_open.pop_back();
        } while (component.back() != first);
        m_components.push_back(std::move(component));
    }

    const std::vector<std::vector<int>> &m_uses;
    std::vector<int> m_seen, m_low;
    std::vector<bool> m_isOpen;
    std::vector<int> m_open;
    std::vector<Step> m_steps;
    int m_count = 0;
    std::vector<std::vector<int>> m_components;
};

/// The shortest way from `first` round to itself within the component. Which one of several follows
/// from what was typed, not from the order of the list.
std::vector<int> wayRound(const ValueGraph &graph, const std::vector<int> &component, int first)
{
    std::map<int, int> from; // who was reached from whom
    for (const int member : component)
        from[member] = -1;
    std::vector<int> reached{first};
    for (std::size_t i = 0; i < reached.size(); ++i)
        for (const int used : graph.uses[static_cast<std::size_t>(reached[i])]) {
            if (used == first) {
                std::vector<int> way;
                for (int at = reached[i]; at != first; at = from[at])
                    way.push_back(at);
                way.push_back(first);
                std::reverse(way.begin(), way.end());
                return way;
            }
            const auto member = from.find(used);
            if (member == from.end() || member->second >= 0)
                continue;
            member->second = reached[i];
            reached.push_back(used);
        }
    return {};
}

void addCircle(ValueGraph &graph, const Values &values, const std::vector<int> &component)
{
    const int first =
        *std::min_element(component.begin(), component.end(), [&values](int a, int b) {
            const auto &one = *values.list[static_cast<std::size_t>(a)];
            const auto &other = *values.list[static_cast<std::size_t>(b)];
            return std::pair(one.folded, one.value.id) < std::pair(other.folded, other.value.id);
        });
    const std::vector<int> way = wayRound(graph, component, first);
    if (way.empty()) // one value that is not made of itself
        return;
    for (const int member : component)
        graph.isInCircle[static_cast<std::size_t>(member)] = true;
    const std::size_t told = std::min(way.size(), kMostTold);
    for (std::size_t i = 0; i < way.size(); ++i) {
        std::vector<int> &circle = graph.circles[static_cast<std::size_t>(way[i])];
        for (std::size_t k = 0; k < told; ++k)
            circle.push_back(way[(i + k) % way.size()]);
        if (told < way.size())
            circle.push_back(-1);
    }
}

} // namespace

ValueGraph graphOf(const Values &values)
{
    ValueGraph graph;
    addUses(graph, values);
    graph.circles.resize(values.list.size());
    graph.isInCircle.resize(values.list.size());
    for (const std::vector<int> &component : Components(graph.uses).all()) {
        graph.order.insert(graph.order.end(), component.begin(), component.end());
        addCircle(graph, values, component);
    }
    return graph;
}

} // namespace fff
