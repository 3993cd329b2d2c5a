#include "core/nesting/exploration.h"

#include "core/nesting/filling.h"

#include <algorithm>
#include <cmath>

namespace fff::nest {

namespace {

constexpr double kFirstShortening = 0.03, kLeastShortening = 0.001, kMostShortening = 0.1;
constexpr double kBolder = 1.5, kShyer = 0.5;
// When compressing: the first step and the last one.
constexpr double kFirstPress = 0.0015, kLastPress = 0.00002;
constexpr Patience kExploring{3, 60};
constexpr Patience kCompressing{3, 40};
// How many failed layouts are remembered.
constexpr std::size_t kRemembered = 12;

} // namespace

Exploration::Exploration(std::span<const Shape> shapes, const std::vector<std::size_t> &items,
                         const Ground &ground, const State &start, std::uint64_t seed)
    : m_shapes(shapes), m_board(shapes, ground.sheets, items.size()), m_random(seed),
      m_separation(
          [&]() -> Board & {
              for (std::size_t i = 0; i < items.size(); ++i)
                  m_board.add(items[i], start.poses[i]);
              for (const Ground::Obstacle &obstacle : ground.obstacles)
                  m_board.addObstacle(*obstacle.shape, obstacle.at);
              return m_board;
          }(),
          m_random.next()),
      m_sheets(ground.sheets), m_freeSheets(start.freeSheets), m_best(start),
      m_step(kFirstShortening)
{
}

void Exploration::restore(const State &state)
{
    m_board.setSheets(state.sheets);
    m_sheets = state.sheets;
    m_freeSheets = state.freeSheets;
    m_separation.setPoses(state.poses);
}

void Exploration::adopt(const State &state)
{
    m_best = state;
    m_failed.clear();
    restore(m_best);
}

/// Sheets that nothing lies on any more go; the one with the least on it is the last one then. One
/// that costs nothing stays for what may come to lie there, and is not emptied, while others cost.
void Exploration::dropEmpty()
{
    struct Load
    {
        std::size_t count = 0;
        double area = 0.0;
        Box2 sheet;
        bool isFree = false;
    };
    std::vector<Load> loads(m_sheets.size());
    for (std::size_t item = 0; item < m_board.count(); ++item) {
        Load &load = loads[m_board.sheetOf(item)];
        ++load.count;
        load.area += m_board.shape(item).area;
    }
    bool areAllFree = true; // that anything lies on
    for (std::size_t i = 0; i < loads.size(); ++i) {
        loads[i].sheet = m_sheets[i];
        loads[i].isFree = i < m_freeSheets;
        areAllFree = areAllFree && (loads[i].isFree || loads[i].count == 0);
    }
    if (m_sheets.size() == m_best.sheets.size() && loads.back().count > 0)
        return;
    std::erase_if(loads, [areAllFree](const Load &load) {
        return load.count == 0 && (areAllFree || !load.isFree);
    });
    m_freeSheets = static_cast<std::size_t>(
        std::count_if(loads.begin(), loads.end(), [](const Load &load) { return load.isFree; }));
    const auto first = loads.begin() + static_cast<std::ptrdiff_t>(areAllFree ? 0 : m_freeSheets);
    const auto least = std::min_element(
        first, loads.end(), [](const Load &a, const Load &b) { return a.area < b.area; });
    std::swap(*least, loads.back());
    m_sheets.clear();
    for (const Load &load : loads)
        m_sheets.push_back(load.sheet);
    m_board.setSheets(m_sheets);
}

/// What lies free of each other now, close to the left.
void Exploration::keep()
{
    dropEmpty();
    const std::size_t sheet = m_sheets.size() - 1;
    slideLeft(m_board, sheet, m_meter);
    double right = last().min.x();
    std::vector<std::size_t> on;
    for (std::size_t item = 0; item < m_board.count(); ++item) {
        on.push_back(m_board.sheetOf(item));
        if (on.back() == sheet)
            right = std::max(right, m_board.box(item).max.x());
    }
    last().max.x() = right;
    m_board.setSheets(m_sheets);
    m_best = {m_separation.poses(), std::move(on), m_sheets, m_freeSheets, right - last().min.x()};
    m_failed.clear();
}

/// Onto its sheet, or onto another one where it is too large for that.
bool Exploration::squeeze(std::size_t item)
{
    Pose pose = m_board.pose(item);
    const std::size_t sheet = m_board.sheetOf(item);
    if (const auto inside = m_board.within(m_board.posed(item), pose.at, sheet)) {
        pose.at = *inside;
        m_board.place(item, pose);
        return true;
    }
    const Shape &shape = m_board.shape(item);
    const std::size_t first = m_random.below(m_sheets.size());
    for (std::size_t i = 0; i < m_sheets.size(); ++i) {
        const std::size_t other = (first + i) % m_sheets.size();
        for (std::size_t turn = 0; turn < shape.turns.size(); ++turn) {
            const Vec2 middle = m_sheets[other].center() - shape.turns[turn].box.center();
            const Vec2 away = m_sheets[other].size().cwiseProduct(
                Vec2(m_random.between(-0.5, 0.5), m_random.between(-0.5, 0.5)));
            if (const auto inside = m_board.within(shape.turns[turn], middle + away, other)) {
                pose = Pose();
                pose.at = *inside;
                pose.turn = static_cast<int>(turn);
                m_board.place(item, pose);
                return true;
            }
        }
    }
    return false;
}

/// What is to the right of `split` on the last sheet moves to the left by as much as it becomes
/// shorter. Whether everything has a sheet then.
bool Exploration::shorten(double length, double split)
{
    const std::size_t sheet = m_sheets.size() - 1;
    const double less = last().size().x() - length;
    std::vector<std::size_t> onIt;
    for (std::size_t item = 0; item < m_board.count(); ++item)
        if (m_board.sheetOf(item) == sheet)
            onIt.push_back(item);
    last().max.x() -= less;
    m_board.setSheets(m_sheets);
    for (const std::size_t item : onIt) {
        if (m_board.box(item).center().x() > split) {
            Pose pose = m_board.pose(item);
            pose.at.x() -= less;
            m_board.place(item, pose);
        }
        if (!squeeze(item))
            return false;
    }
    return true;
}

double Exploration::leastLength() const
{
    double least = m_sheets.size() > 1 ? std::numeric_limits<double>::infinity() : 0.0;
    for (std::size_t item = 0; item < m_board.count(); ++item) {
        double width = std::numeric_limits<double>::infinity();
        for (const Posed &posed : m_board.shape(item).turns)
            width = std::min(width, posed.box.size().x());
        if (m_board.posed(item).box.size().x() < width)
            width = m_board.posed(item).box.size().x();
        // A strip has to have room for all, the last of several sheets for some.
        least = m_sheets.size() > 1 ? std::min(least, width) : std::max(least, width);
    }
    return least;
}

void Exploration::dropLast()
{
    std::vector<std::size_t> homeless;
    for (std::size_t item = 0; item < m_board.count(); ++item)
        if (m_board.sheetOf(item) == m_sheets.size() - 1)
            homeless.push_back(item);
    m_sheets.pop_back();
    m_freeSheets = std::min(m_freeSheets, m_sheets.size());
    m_board.setSheets(m_sheets);
    for (const std::size_t item : homeless) {
        Pose pose = m_board.pose(item);
        const std::size_t sheet = m_random.below(m_sheets.size());
        const Vec2 away = m_sheets[sheet].size().cwiseProduct(
            Vec2(m_random.between(-0.5, 0.5), m_random.between(-0.5, 0.5)));
        pose.at = m_sheets[sheet].center() + away - m_board.posed(item).box.center();
        m_board.place(item, pose);
        squeeze(item);
    }
}

/// Whether the shapes have room on all sheets but the last.
bool Exploration::isDropWorthTrying() const
{
    constexpr double kDensest = 0.9;
    if (m_best.sheets.size() < 2)
        return false;
    double room = 0.0, needed = 0.0;
    for (std::size_t i = 0; i + 1 < m_best.sheets.size(); ++i)
        room += m_best.sheets[i].size().prod();
    for (std::size_t item = 0; item < m_board.count(); ++item)
        needed += m_board.shape(item).area;
    return needed < kDensest * room;
}

void Exploration::tryDrops(Steps until)
{
    const Steps limit = m_meter.limit;
    while (!m_meter.isOver() && m_meter.used < until && isDropWorthTrying()) {
        restore(m_best);
        dropLast();
        m_meter.limit = std::min(limit, until);
        const bool isFree = m_separation.run(kExploring, m_meter);
        m_meter.limit = limit;
        if (!isFree)
            break;
        keep();
    }
    restore(m_best);
}

void Exploration::swap(std::size_t a, std::size_t b)
{
    const Vec2 way = m_board.box(b).center() - m_board.box(a).center();
    for (const auto &[item, by] : {std::pair(a, way), std::pair(b, Vec2(-way))}) {
        Pose pose = m_board.pose(item);
        pose.at += by;
        m_board.place(item, pose);
    }
    squeeze(a);
    squeeze(b);
}

/// Two large shapes that differ change places.
void Exploration::disrupt()
{
    std::vector<std::size_t> large;
    double whole = 0.0, sum = 0.0;
    for (std::size_t item = 0; item < m_board.count(); ++item) {
        large.push_back(item);
        whole += m_board.shape(item).area;
    }
    std::stable_sort(large.begin(), large.end(), [this](std::size_t a, std::size_t b) {
        return m_board.shape(a).area > m_board.shape(b).area;
    });
    constexpr double kLargeShare = 0.75;
    std::size_t count = 0;
    while (count < large.size() && (sum < kLargeShare * whole || count < 2))
        sum += m_board.shape(large[count++]).area;
    if (count < 2)
        return;
    for (int tries = 0; tries < 20; ++tries) {
        const std::size_t a = large[m_random.below(count)], b = large[m_random.below(count)];
        if (a == b || (tries < 10 && m_board.shapeIndex(a) == m_board.shapeIndex(b)))
            continue;
        swap(a, b);
        return;
    }
}

void Exploration::explore(Steps until, std::stop_token stop)
{
    m_meter.limit = until;
    m_meter.stop = std::move(stop);
    tryDrops(m_meter.used + (until - m_meter.used) / 3);
    bool isShort = !m_failed.empty(); // the sheet is as short as wanted, shapes overlap still
    while (!m_meter.isOver()) {
        if (!isShort) {
            restore(m_best);
            const double length = m_best.length * (1.0 - m_step);
            if (length < leastLength() || !shorten(length, last().max.x())) {
                restore(m_best);
                if (m_step <= kLeastShortening)
                    return;
                m_step = std::max(kLeastShortening, kShyer * m_step);
                continue;
            }
        }
        if (m_separation.run(kExploring, m_meter)) {
            if (!isShort)
                m_step = std::min(kMostShortening, kBolder * m_step);
            keep();
            isShort = false;
            continue;
        }
        m_failed.push_back({m_separation.poses(), m_separation.loss()});
        std::stable_sort(m_failed.begin(), m_failed.end(),
                         [](const Failed &a, const Failed &b) { return a.loss < b.loss; });
        if (m_failed.size() > kRemembered)
            m_failed.pop_back();
        if (m_step > kLeastShortening) {
            // It was too much at once.
            m_step = std::max(kLeastShortening, kShyer * m_step);
            m_failed.clear();
            isShort = false;
            continue;
        }
        constexpr double kSpread = 0.25;
        const double rank = std::min(0.999, std::abs(kSpread * m_random.bell()));
        const auto chosen = static_cast<std::size_t>(rank * static_cast<double>(m_failed.size()));
        m_separation.setPoses(m_failed[chosen].poses);
        disrupt();
        isShort = true;
    }
    restore(m_best);
    m_failed.clear();
}

void Exploration::compress(Steps from, Steps until, std::stop_token stop)
{
    m_meter.limit = until;
    m_meter.stop = std::move(stop);
    m_failed.clear();
    while (!m_meter.isOver()) {
        const double done = std::clamp(static_cast<double>(m_meter.used - from) /
                                           static_cast<double>(std::max<Steps>(1, until - from)),
                                       0.0, 1.0);
        const double step = kFirstPress * std::pow(kLastPress / kFirstPress, done);
        restore(m_best);
        const double length = m_best.length * (1.0 - step);
        const double split = m_random.between(last().min.x(), last().max.x());
        if (length < leastLength() || !shorten(length, split))
            break;
        if (m_separation.run(kCompressing, m_meter))
            keep();
    }
    restore(m_best);
}

} // namespace fff::nest
