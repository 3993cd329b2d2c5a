#include "core/nesting/search.h"

#include <algorithm>
#include <memory>
#include <numeric>
#include <thread>

namespace fff::nest {

namespace {

constexpr std::size_t kIslands = 2;
constexpr int kMeetings = 8; // while exploring, and as many while compressing
constexpr double kExploringShare = 0.8;
/// More pieces than this take too long to be taken apart at once.
constexpr std::size_t kMostItems = 250;
/// Of work at most that what lay before is taken apart for.
constexpr double kSecondsApart = 0.5;
constexpr double kMoreLength = 1.03;

/// Some sheets of a layout, as one search has them.
struct Group
{
    std::vector<int> kinds;         // of its sheets
    std::vector<std::size_t> items; // pieces
    Ground ground;
    State start;
};

/// The last of `sheets` is to become shorter; those that cost nothing come first.
Group groupOf(const Prepared &prepared, const Laid &laid, const std::vector<std::size_t> &sheets)
{
    Group group;
    double left = 0.0;
    for (const std::size_t index : sheets) {
        const Laid::Sheet &sheet = laid.sheets[index];
        const Prepared::Sheet &kind = prepared.sheets[static_cast<std::size_t>(sheet.kind)];
        const Vec2 by(left - kind.box.min.x(), 0.0);
        group.kinds.push_back(sheet.kind);
        group.start.freeSheets += kind.isFree ? 1 : 0;
        group.ground.sheets.push_back({kind.box.min + by, kind.box.max + by});
        left += kind.box.size().x() * 1.01 + 1.0;
        for (const Shape &obstacle : kind.obstacles)
            group.ground.obstacles.push_back({&obstacle, by - obstacle.moved});
        for (std::size_t i = 0; i < sheet.pieces.size(); ++i) {
            group.items.push_back(static_cast<std::size_t>(sheet.pieces[i]));
            group.start.poses.push_back(sheet.poses[i]);
            group.start.poses.back().at += by;
            group.start.on.push_back(group.kinds.size() - 1);
        }
    }
    group.start.sheets = group.ground.sheets;
    Laid lastOnly;
    lastOnly.sheets.push_back(laid.sheets[sheets.back()]);
    group.start.length = usedLength(prepared, lastOnly);
    Box2 &last = group.start.sheets.back();
    last.max.x() = last.min.x() + group.start.length;
    if (prepared.isStrip)
        group.ground.sheets = group.start.sheets;
    return group;
}

/// The sheets of a state, each where its kind's box is.
std::vector<Laid::Sheet> sheetsOf(const Prepared &prepared, const Group &group, const State &state)
{
    std::vector<Laid::Sheet> sheets(state.sheets.size());
    std::vector<Vec2> shifts;
    for (std::size_t i = 0; i < state.sheets.size(); ++i) {
        std::size_t from = 0;
        while (group.ground.sheets[from].min.x() != state.sheets[i].min.x())
            ++from;
        sheets[i].kind = group.kinds[from];
        shifts.emplace_back(prepared.sheets[static_cast<std::size_t>(sheets[i].kind)].box.min.x() -
                                state.sheets[i].min.x(),
                            0.0);
    }
    for (std::size_t item = 0; item < group.items.size(); ++item) {
        Pose pose = state.poses[item];
        const std::size_t on = state.on[item];
        pose.at += shifts[on];
        sheets[on].pieces.push_back(static_cast<int>(group.items[item]));
        sheets[on].poses.push_back(pose);
    }
    return sheets;
}

/// Which of a layout's sheets are searched together next: of those that cost something, if any, the
/// one with the least on it, last, and others as far as they are not too much.
std::vector<std::size_t> chosenSheets(const Prepared &prepared, const Laid &laid, Random &random)
{
    const auto isFree = [&](std::size_t sheet) {
        return prepared.sheets[static_cast<std::size_t>(laid.sheets[sheet].kind)].isFree;
    };
    std::vector<std::pair<bool, double>> covered; // what is free comes last
    for (std::size_t i = 0; i < laid.sheets.size(); ++i)
        covered.emplace_back(
            isFree(i), std::accumulate(laid.sheets[i].pieces.begin(), laid.sheets[i].pieces.end(),
                                       0.0, [&](double sum, int piece) {
                                           const auto index = static_cast<std::size_t>(piece);
                                           return sum + prepared.shapes[index].area;
                                       }));
    const auto least = static_cast<std::size_t>(std::min_element(covered.begin(), covered.end()) -
                                                covered.begin());
    std::vector<std::size_t> others;
    for (std::size_t i = 0; i < laid.sheets.size(); ++i)
        if (i != least)
            others.push_back(i);
    random.shuffle(others);
    std::vector<std::size_t> chosen;
    std::size_t count = laid.sheets[least].pieces.size();
    for (const std::size_t sheet : others) {
        count += laid.sheets[sheet].pieces.size();
        if (count > kMostItems)
            break;
        chosen.push_back(sheet);
    }
    std::sort(chosen.begin(), chosen.end());
    std::stable_partition(chosen.begin(), chosen.end(), isFree);
    chosen.push_back(least);
    return chosen;
}

/// Explorations of one group, a thread each.
class Archipelago
{
public:
    Archipelago(const Prepared &prepared, const Group &group, Random &random, bool usesThreads)
        : m_usesThreads(usesThreads)
    {
        for (std::size_t i = 0; i < kIslands; ++i)
            m_islands.push_back(std::make_unique<Exploration>(
                prepared.shapes, group.items, group.ground, group.start, random.next()));
    }

    /// Until each has done so much.
    /// tell  told how much of it is done, at each meeting
    template <class Tell>
    void run(Steps work, const std::stop_token &stop, Tell tell)
    {
        const auto exploring = static_cast<Steps>(kExploringShare * static_cast<double>(work));
        for (int leg = 0; leg < 2 * kMeetings && !stop.stop_requested(); ++leg) {
            const bool explores = leg < kMeetings;
            const Steps done = explores ? 0 : exploring;
            const Steps part = explores ? exploring : work - exploring;
            const Steps until = done + part * (leg % kMeetings + 1) / kMeetings;
            each([&](Exploration &island) {
                if (explores)
                    island.explore(until, stop);
                else
                    island.compress(exploring, until, stop);
            });
            meet(leg + 1 >= kMeetings);
            tell(static_cast<double>(until) / static_cast<double>(work));
        }
    }

    const State &best() const
    {
        const State *best = &m_islands.front()->best();
        for (const auto &island : m_islands)
            if (island->best().isBetterThan(*best))
                best = &island->best();
        return *best;
    }
    Steps used() const
    {
        Steps used = 0;
        for (const auto &island : m_islands)
            used = std::max(used, island->used());
        return used;
    }

private:
    template <class Do>
    void each(Do work)
    {
        std::vector<std::jthread> threads;
        for (std::size_t i = 1; i < m_islands.size() && m_usesThreads; ++i)
            threads.emplace_back([&work, island = m_islands[i].get()] { work(*island); });
        for (std::size_t i = 0; i < (m_usesThreads ? 1 : m_islands.size()); ++i)
            work(*m_islands[i]);
    }

    /// Who is far behind takes over the best; at the end of the exploring, all do.
    void meet(bool all)
    {
        constexpr double kFarBehind = 1.004;
        const State ahead = best();
        for (const auto &island : m_islands) {
            const State &own = island->best();
            if (ahead.takesFewerSheets(own) || (all && ahead.isBetterThan(own)) ||
                own.length > kFarBehind * ahead.length)
                island->adopt(ahead);
        }
    }

    std::vector<std::unique_ptr<Exploration>> m_islands;
    bool m_usesThreads;
};

void addPoles(Prepared &prepared)
{
    for (Shape &shape : prepared.shapes)
        shape.addPoles();
    for (Prepared::Sheet &sheet : prepared.sheets)
        for (Shape &obstacle : sheet.obstacles)
            obstacle.addPoles();
}

} // namespace

std::optional<Laid> takenApart(Prepared &prepared, const Laid &laid, std::uint64_t seed,
                               std::stop_token stop, Steps &steps)
{
    constexpr Patience kLittle{2, 40};
    if (laid.count() == 0 || laid.count() > kMostItems)
        return std::nullopt;
    addPoles(prepared);
    std::vector<std::size_t> sheets(laid.sheets.size());
    std::iota(sheets.begin(), sheets.end(), std::size_t{0});
    const Group group = groupOf(prepared, laid, sheets);
    Board board(prepared.shapes, group.ground.sheets, group.items.size());
    // Hardly more of the last sheet than was used: nothing is to be strewn over the rest.
    std::vector<Box2> room = group.ground.sheets;
    room.back().max.x() =
        std::min(room.back().max.x(), room.back().min.x() + kMoreLength * group.start.length);
    board.setSheets(room);
    for (std::size_t i = 0; i < group.items.size(); ++i)
        board.add(group.items[i], group.start.poses[i]);
    for (const Ground::Obstacle &obstacle : group.ground.obstacles)
        board.addObstacle(*obstacle.shape, obstacle.at);
    for (std::size_t item = 0; item < board.count(); ++item) {
        Pose pose = board.pose(item);
        const auto inside = board.within(board.posed(item), pose.at, board.sheetOf(item));
        if (!inside)
            return std::nullopt;
        pose.at = *inside;
        board.place(item, pose);
    }
    Separation separation(board, seed);
    Meter meter{0, workOf(kSecondsApart), std::move(stop)};
    const bool isFree = separation.run(kLittle, meter);
    steps += meter.used;
    if (!isFree)
        return std::nullopt;
    State state = group.start;
    state.sheets = group.ground.sheets;
    state.poses = separation.poses();
    for (std::size_t item = 0; item < board.count(); ++item)
        state.on[item] = board.sheetOf(item);
    Laid apart;
    for (Laid::Sheet &sheet : sheetsOf(prepared, group, state))
        if (!sheet.pieces.empty())
            apart.sheets.push_back(std::move(sheet));
    return apart;
}

Laid improved(Prepared &prepared, Laid laid, const Options &options, const LongWork &longWork,
              Steps &steps)
{
    if (laid.count() == 0 || options.work <= 0)
        return laid;
    addPoles(prepared);
    Random random(options.seed);
    // Where all pieces are too many for one search, several have a share of the work.
    const auto rounds = static_cast<Steps>((laid.count() + kMostItems - 1) / kMostItems);
    Steps done = 0;
    for (Steps round = 0; round < rounds && !longWork.isStopped(); ++round) {
        const std::vector<std::size_t> chosen = chosenSheets(prepared, laid, random);
        const Group group = groupOf(prepared, laid, chosen);
        Archipelago islands(prepared, group, random, options.usesThreads);
        const Steps work = options.work / rounds;
        islands.run(work, longWork.stop, [&](double share) {
            longWork.tell((static_cast<double>(round) + share) / static_cast<double>(rounds));
        });
        done += islands.used();
        Laid next;
        next.left = laid.left;
        for (std::size_t i = 0; i < laid.sheets.size(); ++i)
            if (std::find(chosen.begin(), chosen.end(), i) == chosen.end())
                next.sheets.push_back(std::move(laid.sheets[i]));
        for (Laid::Sheet &sheet : sheetsOf(prepared, group, islands.best()))
            if (!sheet.pieces.empty())
                next.sheets.push_back(std::move(sheet));
        laid = std::move(next);
    }
    steps += done;
    return laid;
}

} // namespace fff::nest
